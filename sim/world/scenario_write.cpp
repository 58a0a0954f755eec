#include "sim/world/scenario_write.h"

#include "sim/core/files.h"
#include "sim/world/scenario_expect.h"
#include "sim/world/scenario_values.h"

#include <nlohmann/json.hpp>

namespace npsee {
namespace world {
namespace {

using nlohmann::ordered_json;

/// What a reader starts from when it meets this object's identity.
std::shared_ptr<void> baseOf(const Struct& table, const void* object) {
  std::shared_ptr<void> base = table.make();
  if (table.rebase) {
    const Field& identity = *table.find(table.identity);
    identity.write(base.get(), identity.read(object));
    table.rebase(base.get());
  }
  return base;
}

ordered_json listJson(const Field& field, const void* object) {
  ordered_json out = ordered_json::array();
  for (std::size_t i = 0; i < field.count(object); ++i) out.push_back(structJson(*field.child, field.itemOf(object, i)));
  return out;
}

constexpr std::size_t kLine = 120;

/// What fits stays on one line, so that a vehicle, a gun or a clause is one line of a diff; lists of several objects never do.
void print(const ordered_json& json, int indent, std::string& out) {
  const std::string flat = json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  if (!json.is_structured() || json.empty()) {
    out += flat;
    return;
  }
  const bool objects = json.is_array() && json.size() > 1 && json[0].is_object();
  const bool one_line = indent > 0 && !objects && flat.size() + static_cast<std::size_t>(2 * indent) <= kLine;
  const auto line = [&](int depth) {
    if (one_line) {
      if (json.is_object()) out += ' ';
      return;
    }
    out += '\n';
    out.append(static_cast<std::size_t>(2 * depth), ' ');
  };
  out += json.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [key, value] : json.items()) {
    if (!first) out += ',';
    if (!first && one_line && json.is_array()) out += ' ';
    first = false;
    line(indent + 1);
    if (json.is_object()) out += ordered_json(key).dump() + ": ";
    print(value, indent + 1, out);
  }
  line(indent);
  out += json.is_object() ? '}' : ']';
}

}  // namespace

ordered_json structJson(const Struct& table, const void* object) {
  ordered_json out = ordered_json::object();
  const std::shared_ptr<void> base = baseOf(table, object);
  for (const Field& field : table.fields) {
    const std::string key(field.key);
    if (field.scalar()) {
      FieldValue value = field.read(object);
      if (field.required || field.key == table.identity || value != field.read(base.get())) out[key] = fieldToJson(field, value);
    } else if (field.type == FieldType::object) {
      if (ordered_json part = structJson(*field.child, field.partOf(object)); !part.empty()) out[key] = std::move(part);
    } else if (field.type == FieldType::list) {
      if (field.count(object) > 0) out[key] = listJson(field, object);
    } else if (const auto& clauses = static_cast<const Scenario*>(object)->expect; !clauses.empty()) {
      for (const Expectation& clause : clauses) out[key].push_back(expectationJson(clause));
    }
  }
  return out;
}

}  // namespace world

std::string scenarioText(const Scenario& scenario) {
  nlohmann::ordered_json root;
  root["npsee_mission"] = 1;
  root.update(world::structJson(world::missionTable(), &scenario));
  std::string out;
  world::print(root, 0, out);
  out += '\n';
  return out;
}

Expected<void> saveScenario(const Scenario& scenario, const std::filesystem::path& path) {
  if (std::vector<Fault> faults = validate(scenario); !faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(faults)});
  return writeFileAtomically(path, scenarioText(scenario));
}

}  // namespace npsee
