#include "sim/core/text.h"
#include "sim/world/scenario_expect.h"
#include "sim/world/scenario_read.h"
#include "sim/world/scenario_values.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace npsee::world {

using nlohmann::ordered_json;

namespace {

/// "a vehicle", "an observer".
std::string withArticle(std::string_view name) { return (name.find_first_of("aeiou") == 0 ? "an " : "a ") + std::string(name); }

}  // namespace

void TableReader::read(const Struct& table, const ordered_json& object, const std::string& pointer, void* out, const std::vector<std::string_view>& extra) {
  if (!object.is_object()) {
    faults_.push_back(json_.fault(pointer, withArticle(table.name) + " is " + shownJson(object) + ", but must be an object.", ""));
    return;
  }
  readIdentity(table, object, pointer, out);
  for (const auto& [key, value] : object.items()) {
    if (full()) return;
    if (std::ranges::find(extra, key) != extra.end() || key == table.identity) continue;
    const std::string child = pointer + '/' + pointerToken(key);
    if (const Field* field = table.find(key)) {
      readField(*field, value, child, out);
    } else if (const Field* one = singular(table, key)) {
      void* element = one->append(out);
      read(*one->child, value, child, element);
    } else {
      unknown(table, key, child, extra);
    }
  }
  for (const Field& field : table.fields)
    if (field.required && (!object.contains(field.key) || object[field.key].is_null()) && !full())
      faults_.push_back(json_.fault(pointer, std::string(field.key) + " is missing: " + std::string(table.name) + " needs it.", std::string(field.doc)));
}

namespace {

/// People name a vehicle type where its index is asked for.
std::string typesByIndex(const std::string& name) {
  std::string known;
  for (const VehicleType& type : shippedVehicleTypes()) {
    if (type.name == name) return name + " is type " + std::to_string(type.index) + ".";
    known += (known.empty() ? "" : ", ") + std::to_string(type.index) + ' ' + type.name;
  }
  return "Types go by their index: " + known + ", and those of the mission's vehicle_types.";
}

}  // namespace

/// The identity comes first wherever it stands, for other defaults may depend on it.
void TableReader::readIdentity(const Struct& table, const ordered_json& object, const std::string& pointer, void* out) {
  if (table.identity.empty() || !object.contains(table.identity)) return;
  const Field& field = *table.find(table.identity);
  readField(field, object[table.identity], pointer + '/' + std::string(table.identity), out);
  if (table.rebase) table.rebase(out);
}

void TableReader::readField(const Field& field, const ordered_json& value, const std::string& pointer, void* out) {
  if (field.scalar()) {
    if (const auto read = fieldFromJson(field, json_, value, pointer, faults_)) field.write(out, *read);
    else if (field.key == "type" && value.is_string() && !faults_.empty()) faults_.back().remedy = typesByIndex(value.get_ref<const std::string&>());
  } else if (value.is_null()) {
    return;
  } else if (field.type == FieldType::list) {
    readList(field, value, pointer, out);
  } else if (field.type == FieldType::expectations) {
    readExpectations(field, value, pointer, out);
  } else if (!field.word.empty() && value.is_string()) {
    if (value.get_ref<const std::string&>() != field.word)
      faults_.push_back(json_.fault(pointer, std::string(field.key) + " is " + shownJson(value) + ", but must be an object or \"" + std::string(field.word) + "\".", fieldRemedy(field)));
    else
      for (const Field& part : field.child->fields) part.write(field.part(out), defaultOf(*field.child, part));
  } else if (!value.is_object()) {
    faults_.push_back(json_.fault(pointer, std::string(field.key) + " is " + shownJson(value) + ", but must be an object" + (field.word.empty() ? "." : " or \"" + std::string(field.word) + "\"."), fieldRemedy(field)));
  } else {
    std::vector<std::string_view> extra;
    if (foreign_ && field.key == "world") extra.push_back("georef");
    read(*field.child, value, pointer, field.part(out), extra);
  }
}

void TableReader::readList(const Field& field, const ordered_json& value, const std::string& pointer, void* out) {
  if (!value.is_array()) {
    faults_.push_back(json_.fault(pointer, std::string(field.key) + " is " + shownJson(value) + ", but must be a list of objects.", fieldRemedy(field)));
    return;
  }
  const double size = static_cast<double>(value.size());
  if (size > field.hard.max || size < field.hard.min) {
    faults_.push_back(json_.fault(pointer, size < field.hard.min ? std::string(field.key) + " is empty."
                                                                 : std::string(field.key) + " has " + std::to_string(value.size()) + " entries, above the limit of " + shortest(field.hard.max) + ".",
                                  fieldRemedy(field)));
    return;
  }
  field.clear(out);
  for (std::size_t i = 0; i < value.size() && !full(); ++i) read(*field.child, value[i], pointer + '/' + std::to_string(i), field.append(out));
}

void TableReader::readExpectations(const Field& field, const ordered_json& value, const std::string& pointer, void* out) {
  auto& clauses = static_cast<Scenario*>(out)->expect;
  clauses.clear();
  if (!value.is_array() || static_cast<double>(value.size()) > field.hard.max) {
    faults_.push_back(json_.fault(pointer, "expect is " + (value.is_array() ? "a list of " + std::to_string(value.size()) + " clauses" : shownJson(value)) + ", but must be a list of at most " + shortest(field.hard.max) + " clauses.",
                                  fieldRemedy(field)));
    return;
  }
  for (std::size_t i = 0; i < value.size() && !full(); ++i)
    if (auto clause = readExpectation(json_, value[i], pointer + '/' + std::to_string(i), faults_)) clauses.push_back(std::move(*clause));
}

const Field* TableReader::singular(const Struct& table, std::string_view key) const {
  if (!foreign_) return nullptr;
  for (const Field& field : table.fields)
    if (!field.singular.empty() && field.singular == key) return &field;
  return nullptr;
}

void TableReader::unknown(const Struct& table, const std::string& key, const std::string& pointer, const std::vector<std::string_view>& extra) {
  std::vector<std::string_view> known = table.keys();
  known.insert(known.end(), extra.begin(), extra.end());
  const auto near = nearest(key, known);
  faults_.push_back(json_.fault(pointer, withArticle(table.name) + " has no such key.", near ? "Did you mean " + std::string(*near) + "?" : "`npsee params --missions` lists all keys."));
}

}  // namespace npsee::world
