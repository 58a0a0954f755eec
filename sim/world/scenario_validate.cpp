#include "sim/world/scenario_validate.h"

#include "sim/core/json_text.h"
#include "sim/core/text.h"
#include "sim/world/scenario_files.h"
#include "sim/world/scenario_read.h"
#include "sim/world/scenario_table.h"

#include <algorithm>
#include <map>

namespace npsee {
namespace world {
namespace {

/// Candidates a misspelt name is compared with.
constexpr std::size_t kMostCandidates = 1000;

std::string at(std::string_view list, std::size_t index, std::string_view key = {}) {
  std::string out = '/' + std::string(list) + '/' + std::to_string(index);
  if (!key.empty()) out += '/' + std::string(key);
  return out;
}

std::string shown(const Place& place) { return "(" + shortest(place.x_m) + ", " + shortest(place.z_m) + ")"; }

class Checker {
 public:
  explicit Checker(const Scenario& scenario) : s_(scenario), types_(vehicleTypes(scenario)) {}

  std::vector<ScenarioFault> run() {
    checkTypes();
    checkNames();
    checkVehicles();
    checkGroups();
    checkBatteries();
    checkObservers();
    checkTerrain();
    checkExpectations();
    if (faults_.size() > kMostFaults) faults_.resize(kMostFaults);
    return std::move(faults_);
  }

 private:
  void add(std::string pointer, std::string what, std::string remedy = {}) {
    if (faults_.size() < kMostFaults) faults_.push_back({std::move(pointer), std::move(what), std::move(remedy)});
  }

  void checkTypes() {
    std::map<int, std::size_t> first;
    for (std::size_t i = 0; i < s_.types.size(); ++i)
      if (const auto [place, added] = first.emplace(s_.types[i].index, i); !added)
        add(at("vehicle_types", i, "index"), "the index " + std::to_string(s_.types[i].index) + " is taken by vehicle type " + std::to_string(place->second) + ".", "Give each type an index of its own.");
  }

  void name(const std::string& id, std::string pointer) {
    if (id.empty()) return add(std::move(pointer), "the id is empty.", "Name it; the log and --set need a name.");
    if (const auto [place, added] = names_.emplace(id, pointer); !added) add(std::move(pointer), "the id \"" + id + "\" is taken by " + place->second + ".", "Give everything in the mission an id of its own.");
  }

  /// Everything that the log names shares one space of names.
  void checkNames() {
    std::size_t vehicles = s_.vehicles.size();
    for (std::size_t i = 0; i < s_.vehicles.size(); ++i) name(s_.vehicles[i].id, at("vehicles", i, "id"));
    for (const VehicleGroup& group : s_.groups) vehicles += static_cast<std::size_t>(std::max(0, group.count));
    vehicles += static_cast<std::size_t>(std::ranges::count_if(s_.observers, [](const ObserverSetup& observer) { return observer.vehicle.empty(); }));
    if (vehicles > kMaxVehicles) {
      add("/groups", "there are " + std::to_string(vehicles) + " vehicles with those of groups and observers, above the limit of " + std::to_string(kMaxVehicles) + ".", "Lower a group's count.");
    } else {
      for (std::size_t i = 0; i < s_.groups.size(); ++i) {
        name(s_.groups[i].id, at("groups", i, "id"));
        for (int k = 1; k <= s_.groups[i].count; ++k) name(s_.groups[i].id + '-' + std::to_string(k), at("groups", i, "id"));
      }
    }
    std::size_t guns = 0;
    for (std::size_t i = 0; i < s_.batteries.size(); ++i) {
      name(s_.batteries[i].id, at("batteries", i, "id"));
      guns += s_.batteries[i].guns.size();
      for (std::size_t k = 0; k < s_.batteries[i].guns.size(); ++k) name(s_.batteries[i].guns[k].id, at("batteries", i, "guns") + '/' + std::to_string(k) + "/id");
    }
    if (guns > kMaxGuns) add("/batteries", "there are " + std::to_string(guns) + " guns, above the limit of " + std::to_string(kMaxGuns) + ".");
    for (std::size_t i = 0; i < s_.observers.size(); ++i) name(s_.observers[i].id, at("observers", i, "id"));
  }

  void checkType(int type, const std::string& pointer) {
    if (std::ranges::any_of(types_, [&](const VehicleType& known) { return known.index == type; })) return;
    std::string known;
    for (const VehicleType& each : types_)
      if (known.size() < 400) known += (known.empty() ? "" : ", ") + std::to_string(each.index) + ' ' + each.name;
    add(pointer, "there is no vehicle type " + std::to_string(type) + ".", "Types are " + known + "; vehicle_types adds others.");
  }

  void checkPlace(const Place& place, const std::string& pointer, const std::string& what) {
    // A size of 0 is the terrain file's, which is not read here.
    const auto inside = [](double at, double size) { return at >= 0.0 && (size <= 0.0 || at <= size); };
    if (inside(place.x_m, s_.world.size_x_m) && inside(place.z_m, s_.world.size_z_m)) return;
    add(pointer, what + " at " + shown(place) + " lies outside the world, which spans 0 to " + shortest(s_.world.size_x_m) + " m east and 0 to " + shortest(s_.world.size_z_m) + " m south.",
        "Move it, or enlarge the world's size.");
  }

  void unknownName(const std::string& pointer, const std::string& kind, const std::string& wrong, const std::vector<std::string_view>& candidates) {
    const auto near = nearest(wrong, candidates);
    add(pointer, "there is no " + kind + " \"" + wrong + "\".", near ? "Did you mean " + std::string(*near) + "?" : candidates.empty() ? "The mission has no " + kind + "; add one, or leave this out." : "There are " + listed({candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(candidates.size(), 20))}) + ".");
  }

  bool isVehicle(const std::string& id) const {
    const auto found = names_.find(id);
    if (found == names_.end()) return false;
    if (found->second.starts_with("/vehicles/")) return true;
    if (!found->second.starts_with("/groups/")) return false;
    return std::ranges::none_of(s_.groups, [&](const VehicleGroup& group) { return group.id == id; });
  }

  std::vector<std::string_view> vehicleNames() const {
    std::vector<std::string_view> out;
    for (const auto& [id, pointer] : names_)
      if (out.size() < kMostCandidates && isVehicle(id)) out.push_back(id);
    return out;
  }

  void checkVehicles() {
    for (std::size_t i = 0; i < s_.vehicles.size(); ++i) {
      const VehicleSetup& vehicle = s_.vehicles[i];
      checkType(vehicle.type, at("vehicles", i, "type"));
      checkPlace(vehicle.at, at("vehicles", i, "pos"), "vehicle \"" + vehicle.id + "\"");
      for (std::size_t k = 0; k < vehicle.goals.size(); ++k) checkPlace(vehicle.goals[k], at("vehicles", i, "goals") + '/' + std::to_string(k), "the goal");
      if (vehicle.behaviour == Behaviour::goals && vehicle.goals.empty()) add(at("vehicles", i, "goals"), "behaviour goals needs at least one goal.", "Add \"goals\": [[x, z], ...].");
      if (vehicle.behaviour == Behaviour::follow) checkFollower(i);
    }
  }

  void checkFollower(std::size_t i) {
    const VehicleSetup& vehicle = s_.vehicles[i];
    const std::string pointer = at("vehicles", i, "follows");
    if (vehicle.follows.empty()) return add(pointer, "behaviour follow needs the vehicle ahead.", "Add \"follows\": with its id.");
    if (!isVehicle(vehicle.follows)) return unknownName(pointer, "vehicle", vehicle.follows, vehicleNames());
    // Along the vehicles ahead; a chain longer than there are vehicles is a ring.
    const VehicleSetup* ahead = &vehicle;
    for (std::size_t hop = 0; hop <= s_.vehicles.size(); ++hop) {
      if (ahead->behaviour != Behaviour::follow) return;
      const auto found = names_.find(ahead->follows);
      if (found == names_.end() || !found->second.starts_with("/vehicles/")) return;
      ahead = &s_.vehicles[std::stoul(found->second.substr(10))];
      if (ahead == &vehicle) return add(pointer, "vehicle \"" + vehicle.id + "\" follows itself, directly or through others.", "Let one vehicle of the ring do something else.");
    }
  }

  void checkGroups() {
    for (std::size_t i = 0; i < s_.groups.size(); ++i) {
      const VehicleGroup& group = s_.groups[i];
      checkType(group.type, at("groups", i, "type"));
      checkPlace(group.from, at("groups", i, "from"), "the corner");
      checkPlace(group.to, at("groups", i, "to"), "the corner");
      if (group.speed_min_mps > group.speed_max_mps)
        add(at("groups", i, "speed_min"), "speed_min is " + shortest(group.speed_min_mps) + " m/s, above speed_max, " + shortest(group.speed_max_mps) + " m/s.", "Exchange them.");
      if (group.behaviour == Behaviour::goals || group.behaviour == Behaviour::follow)
        add(at("groups", i, "behaviour"), "a group cannot have goals or follow.", "List the vehicles one by one in vehicles.");
    }
  }

  void checkBatteries() {
    for (std::size_t i = 0; i < s_.batteries.size(); ++i) {
      const BatterySetup& battery = s_.batteries[i];
      for (std::size_t k = 0; k < battery.guns.size(); ++k) checkPlace(battery.guns[k].at, at("batteries", i, "guns") + '/' + std::to_string(k) + "/pos", "gun \"" + battery.guns[k].id + "\"");
      // A dot or a slash makes these a file, as it does for the ballistics library.
      for (const auto& [key, value] : {std::pair<std::string, const std::string&>{"projectile", battery.projectile}, {"preset", battery.preset}})
        if (value.find_first_of("./\\") != std::string::npos)
          if (std::string wrong = wrongPath(key, value); !wrong.empty()) add(at("batteries", i, key), std::move(wrong), "Put the file beside the mission file.");
    }
  }

  void checkObservers() {
    std::vector<std::string_view> batteries;
    for (const BatterySetup& battery : s_.batteries) batteries.push_back(battery.id);
    for (std::size_t i = 0; i < s_.observers.size(); ++i) {
      const ObserverSetup& observer = s_.observers[i];
      checkPlace(observer.at, at("observers", i, "pos"), "observer \"" + observer.id + "\"");
      if (observer.vehicle.empty()) checkType(observer.type, at("observers", i, "type"));
      else if (!isVehicle(observer.vehicle)) unknownName(at("observers", i, "vehicle"), "vehicle", observer.vehicle, vehicleNames());
      for (std::size_t k = 0; k < observer.missions.size(); ++k) checkType(observer.missions[k].type, at("observers", i, "missions") + '/' + std::to_string(k) + "/type");
      for (std::size_t k = 0; k < observer.batteries.size(); ++k)
        if (std::ranges::find(batteries, observer.batteries[k]) == batteries.end() && !(batteries.empty() && observer.batteries[k] == "battery"))
          unknownName(at("observers", i, "batteries") + '/' + std::to_string(k), "battery", observer.batteries[k], batteries);
      if (!observer.shipped_rules && observer.rules.empty()) add(at("observers", i, "shipped_rules"), "the observer has no rules at all.", "Name his own in rules, or leave shipped_rules out.");
      checkSensing(observer.sensing, at("observers", i, "sensing"));
    }
  }

  void checkSensing(const Sensing& sensing, const std::string& pointer) {
    if (!(sensing.far_m > sensing.near_m)) add(pointer + "/far", "far is " + shortest(sensing.far_m) + " m, not beyond near, " + shortest(sensing.near_m) + " m.", "Belief falls from near to far.");
    if (sensing.belief_far > sensing.belief_near)
      add(pointer + "/belief_far", "belief_far is " + shortest(sensing.belief_far) + ", above belief_near, " + shortest(sensing.belief_near) + ".", "Belief falls with range.");
  }

  void checkTerrain() {
    const TerrainSource& source = s_.world.terrain;
    const bool from_file = source.kind == TerrainKind::hgt || source.kind == TerrainKind::png;
    if (from_file && source.file.empty()) add("/world/terrain/file", "this kind of terrain needs a file.", "Name it in file, relative to the mission file.");
    if (source.kind == TerrainKind::function && source.expression.empty()) add("/world/terrain/expr", "kind function needs the function's name.", "Add \"expr\": \"ridge\".");
    if (from_file) return;
    for (const auto& [key, size] : {std::pair{"x", s_.world.size_x_m}, {"z", s_.world.size_z_m}})
      if (!(size > 0.0)) add("/world/size", "the size along " + std::string(key) + " is 0, which only a terrain file can fill in.", "The thesis's world is [50000, 50000].");
  }

  void checkExpectations() {
    for (std::size_t i = 0; i < s_.expect.size(); ++i) {
      const std::string& of = s_.expect[i].within_of;
      if (of.empty() || names_.contains(of) || !s_.facts.empty()) continue;
      std::vector<std::string_view> known;
      for (const auto& [id, pointer] : names_)
        if (known.size() < kMostCandidates) known.push_back(id);
      unknownName(at("expect", i), "vehicle, gun or observer", of, known);
    }
  }

  const Scenario& s_;
  std::vector<VehicleType> types_;
  std::map<std::string, std::string> names_;  ///< id and where it was given first
  std::vector<ScenarioFault> faults_;
};

/// Every value against its row.
void checkValues(const Struct& table, const void* object, const std::string& pointer, std::vector<Fault>& faults) {
  const auto add = [&](std::string where, std::string what) { faults.push_back({.what = std::move(what), .remedy = {}, .file = {}, .line = 0, .pointer = std::move(where)}); };
  for (const Field& field : table.fields) {
    if (faults.size() >= kMostFaults) return;
    const std::string here = pointer + '/' + std::string(field.key);
    if (field.scalar()) {
      if (std::string wrong = checkField(field, field.read(object)); !wrong.empty()) add(here, std::move(wrong));
    } else if (field.type == FieldType::object) {
      checkValues(*field.child, field.partOf(object), here, faults);
    } else if (field.type == FieldType::list) {
      const double count = static_cast<double>(field.count(object));
      if (count > field.hard.max) add(here, std::string(field.key) + " has " + shortest(count) + " entries, above the limit of " + shortest(field.hard.max) + ".");
      else if (count < field.hard.min) add(here, std::string(field.key) + " is empty.");
      else
        for (std::size_t i = 0; i < field.count(object); ++i) checkValues(*field.child, field.itemOf(object, i), here + '/' + std::to_string(i), faults);
    }
  }
}

}  // namespace

std::vector<ScenarioFault> relationFaults(const Scenario& scenario) { return Checker(scenario).run(); }

}  // namespace world

std::vector<Fault> validate(const Scenario& scenario) {
  std::vector<Fault> faults;
  world::checkValues(world::missionTable(), &scenario, "", faults);
  if (faults.empty())
    for (world::ScenarioFault& fault : world::relationFaults(scenario))
      faults.push_back({.what = std::move(fault.what), .remedy = std::move(fault.remedy), .file = {}, .line = 0, .pointer = std::move(fault.pointer)});
  return faults;
}

bool Sensing::perfect() const { return !limited_belief && location_cep_m == 0.0 && own_cep_m == 0.0 && bearing_error_mil == 0.0 && range_error == 0.0; }

}  // namespace npsee
