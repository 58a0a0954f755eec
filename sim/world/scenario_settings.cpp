#include "sim/core/text.h"
#include "sim/world/scenario_read.h"
#include "sim/world/scenario_values.h"

#include <nlohmann/json.hpp>

#include <charconv>

namespace npsee {
namespace world {
namespace {

using nlohmann::ordered_json;

/// Where a path of `--set` ends: a field of an object, or one name among its parameters.
struct Target {
  const Field* field = nullptr;
  void* object = nullptr;
  std::string parameter;
};

/// Follows a path through the table, `path` being the part of it already walked (with its dot) for messages.
class PathWalk {
 public:
  explicit PathWalk(Scenario& scenario) : object_(&scenario) {}

  Expected<Target> walk(std::string_view path) {
    const std::vector<std::string_view> parts = splitAt(path, '.');
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Field* field = table_->find(parts[i]);
      if (field == nullptr) return unknown(parts[i], table_->keys(), "key");
      const bool last = i + 1 == parts.size();
      if (last) return Target{field, object_, {}};
      walked_ += std::string(parts[i]) + '.';
      if (field->type == FieldType::parameters && i + 2 == parts.size()) return Target{field, object_, std::string(parts[i + 1])};
      if (field->type == FieldType::object) {
        object_ = field->part(object_);
      } else if (field->type == FieldType::list) {
        if (auto entered = enter(*field, parts[++i]); !entered) return tl::unexpected<Error>(entered.error());
        if (i + 1 == parts.size()) return fail(ErrorKind::usage, "this names a whole " + std::string(field->child->name) + ".", "Name one of its keys: " + listed(field->child->keys()) + ".");
      } else {
        return fail(ErrorKind::usage, std::string(field->key) + " has no parts.");
      }
      table_ = field->child;
    }
    return fail(ErrorKind::usage, "the path is empty.");
  }

 private:
  /// Goes to the element with this id, or at this position.
  Expected<void> enter(const Field& field, std::string_view name) {
    const Struct& child = *field.child;
    std::vector<std::string> ids;
    if (!child.identity.empty()) {
      const Field& identity = *child.find(child.identity);
      for (std::size_t i = 0; i < field.count(object_); ++i) {
        ids.push_back(fieldText(identity, identity.read(field.item(object_, i))));
        if (ids.back() == name) return found(field.item(object_, i), name);
      }
      if (child.rebase && addShipped(field, identity, name)) return {};
    }
    std::size_t position = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), position);
    if (error == std::errc() && end == name.data() + name.size() && position < field.count(object_)) return found(field.item(object_, position), name);
    if (ids.empty())
      for (std::size_t i = 0; i < field.count(object_); ++i) ids.push_back(std::to_string(i));
    return unknown(name, {ids.begin(), ids.end()}, child.name);
  }

  Expected<void> found(void* object, std::string_view name) {
    object_ = object;
    walked_ += std::string(name) + '.';
    return {};
  }

  /// A shipped vehicle type that the mission has not changed yet becomes one of its own.
  bool addShipped(const Field& field, const Field& identity, std::string_view name) {
    const auto value = parseField(identity, name);
    if (!value || std::ranges::none_of(shippedVehicleTypes(), [&](const VehicleType& type) { return type.index == std::get<std::int64_t>(*value); })) return false;
    void* added = field.append(object_);
    identity.write(added, *value);
    field.child->rebase(added);
    return found(added, name).has_value();
  }

  tl::unexpected<Error> unknown(std::string_view name, const std::vector<std::string_view>& candidates, std::string_view kind) {
    const auto near = nearest(name, candidates);
    std::string what = "there is no " + std::string(kind) + " \"" + std::string(name) + "\"" + (walked_.empty() ? "" : " in " + walked_.substr(0, walked_.size() - 1)) + ".";
    if (near) what += " Did you mean " + walked_ + std::string(*near) + "?";
    std::string remedy;
    if (!candidates.empty() && candidates.size() <= 30) remedy = "There are " + listed(candidates) + ".";
    return fail(ErrorKind::usage, std::move(what), std::move(remedy));
  }

  const Struct* table_ = &missionTable();
  void* object_;
  std::string walked_;
};

/// Lists and objects are typed as the JSON they have in a file.
Expected<void> assignJson(const Target& target, std::string_view text) {
  const auto json = JsonText::parse(text, "");
  if (!json) return fail(ErrorKind::usage, std::string(target.field->key) + ": " + json.error().faults.front().what);
  std::vector<Fault> faults;
  TableReader(*json, faults, false).readField(*target.field, json->root(), "", target.object);
  if (!faults.empty()) return fail(ErrorKind::usage, (faults.front().pointer.empty() ? "" : faults.front().pointer + ": ") + faults.front().what, faults.front().remedy);
  return {};
}

Expected<void> assignParameter(const Target& target, std::string_view text) {
  Params params = std::get<Params>(target.field->read(target.object));
  if (const auto number = parseQuantity(text, Unit::none)) params[target.parameter] = *number;
  else params[target.parameter] = std::string(trimmed(text));
  if (std::string wrong = checkField(*target.field, params); !wrong.empty()) return fail(ErrorKind::usage, std::move(wrong));
  target.field->write(target.object, params);
  return {};
}

Expected<void> assign(const Target& target, std::string_view text) {
  if (!target.parameter.empty()) return assignParameter(target, text);
  const std::string_view body = trimmed(text);
  const FieldType type = target.field->type;
  const bool composed = !target.field->scalar() || type == FieldType::parameters;
  const bool listed_as_json = (type == FieldType::place || type == FieldType::vector || type == FieldType::texts || type == FieldType::places) && body.starts_with('[');
  if (composed && body == target.field->word && !body.empty()) return assignJson(target, '"' + std::string(body) + '"');
  if ((composed && (body.starts_with('[') || body.starts_with('{'))) || listed_as_json) return assignJson(target, body);
  const auto value = parseField(*target.field, text);
  if (!value) return tl::unexpected<Error>(value.error());
  target.field->write(target.object, *value);
  return {};
}

}  // namespace
}  // namespace world

Expected<void> applySetting(Scenario& scenario, std::string_view expression) {
  const auto refuse = [&](const Error& error) {
    const Fault& fault = error.faults.front();
    return fail(ErrorKind::usage, "--set " + std::string(expression) + ": " + fault.what, fault.remedy);
  };
  const std::size_t equals = expression.find('=');
  if (equals == std::string_view::npos || equals == 0)
    return fail(ErrorKind::usage, "--set " + std::string(expression) + ": this is not PATH=VALUE.", "For example --set world.weather.visibility=800 or --set vehicles.t72-1.pos=25400,25000.");
  Scenario changed = scenario;
  const auto target = world::PathWalk(changed).walk(trimmed(expression.substr(0, equals)));
  if (!target) return refuse(target.error());
  if (const auto assigned = world::assign(*target, expression.substr(equals + 1)); !assigned) return refuse(assigned.error());
  scenario = std::move(changed);
  return {};
}

}  // namespace npsee
