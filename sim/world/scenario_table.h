#pragma once

#include <npsee/parameters.h>
#include <npsee/scenario.h>

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace npsee::world {

/// The table of everything a mission file can say: one row per key of each structure. Reading, writing, validation, `--set`, the
/// reference, the JSON Schema and the editor's panels are driven by it; no range, default or help text stands anywhere else.

/// Named numbers, and texts where a number would not do ("axis").
using Params = std::map<std::string, std::variant<double, std::string>>;
/// Value of a field that is neither an object nor a list of objects. Numbers with a unit are SI unless `Field::si` says otherwise; a
/// choice is its key, a file its path.
using FieldValue = std::variant<bool, std::int64_t, double, std::string, Place, Vec3, std::vector<std::string>, std::vector<Place>, Params>;

enum class FieldType {
  boolean, integer, number, choice, text,
  id,            ///< a name that the log and `--set` use: letters, digits, - and _
  file,          ///< path relative to the mission file's folder
  place,         ///< [x, z]
  vector,        ///< [x, y, z]
  texts, places,
  parameters,    ///< an object of numbers
  object,        ///< another structure
  list,          ///< of structures
  expectations,  ///< list of clauses (scenario_expect.h)
};

struct Struct;

struct Field {
  std::string_view key;
  std::string_view doc;          ///< full sentences
  FieldType type = FieldType::number;
  Unit unit = Unit::none;        ///< in files
  Range hard;                    ///< limits in the file unit; of texts the length, of lists the number of entries
  std::span<const std::string_view> choices;
  bool required = false;
  bool si = true;                ///< the member holds SI; false: the file's unit
  const Struct* child = nullptr; ///< of object and list
  std::string_view word;         ///< text that stands for an object with all defaults ("perfect")
  std::string_view singular;     ///< key of the foreign format for a list of one object ("battery")
  /// Why the field has no effect with the others of its structure as they are, empty where it may have one; null: it always may.
  std::string_view (*idle)(const void*) = nullptr;

  /// Values; unset for object, list and expectations.
  std::function<FieldValue(const void*)> read;
  std::function<void(void*, const FieldValue&)> write;
  /// object: the part itself.
  std::function<void*(void*)> part;
  /// list: number of elements, one of them, a new one at the end, and removal of all.
  std::function<std::size_t(const void*)> count;
  std::function<void*(void*, std::size_t)> item;
  std::function<void*(void*)> append;
  std::function<void(void*)> clear;

  const void* partOf(const void* object) const { return part(const_cast<void*>(object)); }
  const void* itemOf(const void* object, std::size_t index) const { return item(const_cast<void*>(object), index); }
  bool scalar() const { return static_cast<bool>(read); }
};

struct Struct {
  std::string_view name;      ///< as the reference heads it, e.g. "vehicle"
  std::string_view doc;
  std::vector<Field> fields;  ///< in the order of the file
  std::string_view identity;  ///< key by which an element of a list is known; empty = by its position
  /// A value with all defaults.
  std::function<std::shared_ptr<void>()> make;
  /// Sets every default that depends on the identity (a shipped vehicle type's own values); may be unset.
  std::function<void(void*)> rebase;

  const Field* find(std::string_view key) const;
  std::vector<std::string_view> keys() const;
};

/// The structure of the whole file; Scenario.
const Struct& missionTable();
/// Every structure once, the file's own first.
const std::vector<const Struct*>& missionTables();

/// Default of a scalar field, SI.
FieldValue defaultOf(const Struct& table, const Field& field);

/// Empty if `value` is allowed, else what is wrong, e.g. "pe_range is 5000 m, above the limit of 2000 m."
std::string checkField(const Field& field, const FieldValue& value);
/// Reads and checks a value as the command line writes it. Error kind usage.
Expected<FieldValue> parseField(const Field& field, std::string_view text);
/// The value as parseField reads it back; with its unit for people if `with_unit`.
std::string fieldText(const Field& field, const FieldValue& value, bool with_unit = false);
/// What values are allowed, in words.
std::string allowed(const Field& field);

/// The reference of mission files: all structures, or the fields called `key` and the structure of that name. Error kind usage
/// names the nearest.
Expected<std::string> missionReference(ReferenceFormat format, std::string_view key = {});

}  // namespace npsee::world
