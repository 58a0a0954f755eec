#include "sim/world/scenario_row.h"

namespace npsee::world {
namespace {

Field expectations() {
  return fieldOf({.key = "expect", .doc = "Clauses that the event log must meet; `npsee mission FILE --expect` checks them.", .hard = {0, 200}}, FieldType::expectations);
}

void collect(const Struct& table, std::vector<const Struct*>& out) {
  out.push_back(&table);
  for (const Field& field : table.fields)
    if (field.child != nullptr) collect(*field.child, out);
}

}  // namespace

const Struct& missionTable() {
  static const Struct table = structOf<Scenario>(
      "mission", "A whole mission. The first key of a file is \"npsee_mission\": 1.",
      {
          field(&Scenario::name, {.key = "name", .doc = "Short name.", .hard = {0, 60}}),
          field(&Scenario::title, {.key = "title", .doc = "Name as people read it.", .hard = {0, 120}}),
          field(&Scenario::description, {.key = "description", .doc = "What the mission shows.", .hard = {0, 4000}}),
          field(&Scenario::seed, {.key = "seed", .doc = "Selects the random draws; the same seed gives the same log, byte for byte.", .hard = {0, kLargestWhole}}),
          field(&Scenario::duration_s, {.key = "duration", .doc = "Simulated time.", .hard = {kMissionTick_s, kMaxMissionDuration_s}, .unit = Unit::second}),
          object(&Scenario::world, worldTable(), {.key = "world", .doc = "Ground, sea and air."}),
          field(&Scenario::weapons, {.key = "weapons", .doc = "A weapons.dat of the thesis; empty, or weapons.dat where there is no such file, means the shipped one.", .hard = {0, 1000}}),
          field(&Scenario::facts, {.key = "facts", .doc = "A facts file of the thesis (forwardobserver.clp): observer, guns and mission orders where this file gives none.", .hard = {0, 1000}}),
          list(&Scenario::types, vehicleTypeTable(), {.key = "vehicle_types", .doc = "Vehicle types besides the shipped ones.", .hard = {0, 1000}}),
          list(&Scenario::vehicles, vehicleTable(), {.key = "vehicles", .doc = "Vehicles one by one.", .hard = {0, static_cast<double>(kMaxVehicles)}}),
          list(&Scenario::groups, groupTable(), {.key = "groups", .doc = "Vehicles at random.", .hard = {0, 1000}}),
          list(&Scenario::batteries, batteryTable(), {.key = "batteries", .doc = "Guns.", .hard = {0, static_cast<double>(kMaxGuns)}, .singular = "battery"}),
          list(&Scenario::observers, observerTable(), {.key = "observers", .doc = "Forward observers.", .hard = {0, static_cast<double>(kMaxObservers)}, .singular = "observer"}),
          object(&Scenario::fdc, fdcTable(), {.key = "fdc", .doc = "Fire direction."}),
          expectations(),
      });
  return table;
}

const std::vector<const Struct*>& missionTables() {
  static const std::vector<const Struct*> all = [] {
    std::vector<const Struct*> out;
    collect(missionTable(), out);
    return out;
  }();
  return all;
}

const Field* Struct::find(std::string_view key) const {
  for (const Field& field : fields)
    if (field.key == key) return &field;
  return nullptr;
}

std::vector<std::string_view> Struct::keys() const {
  std::vector<std::string_view> out;
  for (const Field& field : fields) out.push_back(field.key);
  return out;
}

FieldValue defaultOf(const Struct& table, const Field& field) { return field.read(table.make().get()); }

}  // namespace npsee::world
