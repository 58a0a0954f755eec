// Walks the table of mission files, so that a new key is covered by itself.

#include "sim/core/json_text.h"
#include "sim/world/scenario_read.h"
#include "sim/world/scenario_values.h"
#include "sim/world/scenario_write.h"

#include "tests/scenario/sample.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace npsee::world {
namespace {

using nlohmann::ordered_json;

struct Case {
  const Struct* table;
  const Field* field;
};

std::vector<Case> cases(bool scalars) {
  std::vector<Case> out;
  for (const Struct* table : missionTables())
    for (const Field& field : table->fields)
      if (field.scalar() || !scalars) out.push_back({table, &field});
  return out;
}

/// Runs a check on every row; failures say which.
template <class Check>
void onEach(bool scalars, const Check& check) {
  for (const Case& c : cases(scalars)) {
    SCOPED_TRACE(std::string(c.table->name) + '.' + std::string(c.field->key));
    check(c.table, c.field);
  }
}

/// Reads an object of a structure; `faults` gets what is wrong with it.
std::shared_ptr<void> readAs(const Struct& table, const ordered_json& object, std::vector<Fault>& faults) {
  std::shared_ptr<void> out = table.make();
  const auto json = JsonText::parse(object.dump(), "f");
  if (!json) throw std::runtime_error(json.error().text());
  TableReader(*json, faults, false).read(table, json->root(), "", out.get());
  return out;
}

/// What every object of the structure needs besides the field under test.
ordered_json needed(const Struct& table) {
  ordered_json out = ordered_json::object();
  for (const Field& field : table.fields) {
    if (!field.required) continue;
    if (field.type == FieldType::list) out[std::string(field.key)] = ordered_json::array({needed(*field.child)});
    else if (field.type == FieldType::id) out[std::string(field.key)] = "name";
    else out[std::string(field.key)] = fieldToJson(field, defaultOf(table, field));
    if (field.key == "count") out["count"] = 1;
  }
  return out;
}

TEST(EveryField, HasAKeyWordsAndAnAllowedDefault) {
  onEach(false, [](const Struct* table, const Field* field) {
    EXPECT_FALSE(field->key.empty());
    EXPECT_TRUE(field->doc.ends_with('.')) << field->doc;
    EXPECT_FALSE(allowed(*field).empty());
    if (field->scalar() && !field->required) {
      EXPECT_EQ(checkField(*field, defaultOf(*table, *field)), "");
    }
  });
}

TEST(EveryScalar, KeepsAnotherValueThroughItsJson) {
  onEach(true, [](const Struct* table, const Field* field) {
    const std::shared_ptr<void> object = table->make();
    const FieldValue value = test::another(*field, defaultOf(*table, *field));
    ASSERT_NE(value, defaultOf(*table, *field));
    ASSERT_EQ(checkField(*field, value), "");
    field->write(object.get(), value);
    EXPECT_EQ(field->read(object.get()), value);

    ordered_json json = needed(*table);
    json.update(structJson(*table, object.get()));
    for (const Field& other : table->fields)
      if (other.type == FieldType::id && &other != field) json[std::string(other.key)] = "name";
    if (json.contains("count") && field->key != "count") json["count"] = 1;
    std::vector<Fault> faults;
    const auto again = readAs(*table, json, faults);
    EXPECT_TRUE(faults.empty()) << faults.front().text();
    EXPECT_EQ(field->read(again.get()), value) << json.dump();
    for (const Field& other : table->fields)
      if (other.scalar() && &other != field && !other.required && other.type != FieldType::id) {
        EXPECT_EQ(other.read(again.get()), other.read(object.get())) << other.key;
      }
  });
}

TEST(EveryScalar, RefusesAWrongTypeWithItsPointerAndKey) {
  onEach(true, [](const Struct* table, const Field* field) {
    ordered_json json = needed(*table);
    json[std::string(field->key)] = field->type == FieldType::parameters ? ordered_json(3) : ordered_json{{"wrong", true}};
    std::vector<Fault> faults;
    readAs(*table, json, faults);
    ASSERT_EQ(faults.size(), 1u) << json.dump();
    EXPECT_EQ(faults[0].pointer, '/' + std::string(field->key));
    EXPECT_TRUE(faults[0].what.starts_with(std::string(field->key) + " is ")) << faults[0].what;
    EXPECT_NE(faults[0].what.find("but must be"), std::string::npos);
    EXPECT_EQ(faults[0].remedy, "`npsee params --missions " + std::string(field->key) + "` says what it does.");
  });
}

TEST(EveryScalar, RefusesWhatIsOutOfRange) {
  onEach(true, [](const Struct* table, const Field* field) {
    ordered_json above, below;
    switch (field->type) {
      case FieldType::integer: above = static_cast<std::int64_t>(field->hard.max) + 1, below = static_cast<std::int64_t>(field->hard.min) - 1; break;
      case FieldType::number: above = field->hard.max * 1.01 + 1.0, below = field->hard.min - 1.0; break;
      case FieldType::place: above = {0.5, field->hard.max * 1.01 + 1}, below = {field->hard.min - 1.0, 0.5}; break;
      case FieldType::vector: above = {0.0, field->hard.max + 1, 0.0}, below = {0.0, 0.0, field->hard.min - 1}; break;
      case FieldType::choice: above = "no such choice", below = ""; break;
      case FieldType::text: above = std::string(static_cast<std::size_t>(field->hard.max) + 1, 'x'); break;
      case FieldType::id: above = std::string(static_cast<std::size_t>(field->hard.max) + 1, 'x'), below = "a b"; break;
      case FieldType::file: above = "/etc/hostname", below = "a/../../b"; break;
      case FieldType::texts: above = std::vector<std::string>(static_cast<std::size_t>(field->hard.max) + 1, "x"), below = {""}; break;
      case FieldType::places: above = std::vector<std::array<int, 2>>(static_cast<std::size_t>(field->hard.max) + 1, {1, 2}); break;
      case FieldType::parameters: above = {{"axis", "y"}}, below = {{"x", 1e10}}; break;
      case FieldType::boolean:
      case FieldType::object:
      case FieldType::list:
      case FieldType::expectations: return;
    }
    for (const ordered_json& bad : {above, below}) {
      if (bad.is_null()) continue;
      ordered_json json = needed(*table);
      json[std::string(field->key)] = bad;
      std::vector<Fault> faults;
      readAs(*table, json, faults);
      ASSERT_EQ(faults.size(), 1u) << bad.dump();
      EXPECT_EQ(faults[0].pointer, '/' + std::string(field->key));
    }
  });
}

TEST(EveryScalar, MeansItsDefaultWhereItIsNullOrLeftOut) {
  onEach(true, [](const Struct* table, const Field* field) {
    ordered_json json = needed(*table);
    std::vector<Fault> faults;
    if (!field->required) json[std::string(field->key)] = nullptr;
    const auto read = readAs(*table, json, faults);
    EXPECT_TRUE(faults.empty()) << faults.front().text();
    if (!field->required) {
      EXPECT_EQ(field->read(read.get()), defaultOf(*table, *field));
    }
  });
}

TEST(EveryScalar, IsMissedWhereItIsRequired) {
  onEach(true, [](const Struct* table, const Field* field) {
    if (!field->required) return;
    ordered_json json = needed(*table);
    json.erase(std::string(field->key));
    std::vector<Fault> faults;
    readAs(*table, json, faults);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].what, std::string(field->key) + " is missing: " + std::string(table->name) + " needs it.");
    EXPECT_EQ(faults[0].remedy, field->doc);
  });
}

TEST(EveryScalar, IsTypedOnTheCommandLineAsItIsPrinted) {
  onEach(true, [](const Struct* table, const Field* field) {
    if (field->type == FieldType::parameters) return;
    const FieldValue value = test::another(*field, defaultOf(*table, *field));
    const auto parsed = parseField(*field, fieldText(*field, value));
    ASSERT_TRUE(parsed) << parsed.error().text();
    EXPECT_EQ(*parsed, value);
  });
}


TEST(MissionTable, NamesEveryStructureAndEveryKeyOnce) {
  std::set<std::string_view> names;
  for (const Struct* table : missionTables()) {
    EXPECT_TRUE(names.insert(table->name).second) << table->name;
    EXPECT_TRUE(table->doc.ends_with('.'));
    std::set<std::string_view> keys;
    for (const Field& field : table->fields) EXPECT_TRUE(keys.insert(field.key).second) << table->name << ' ' << field.key;
    if (!table->identity.empty()) {
      EXPECT_NE(table->find(table->identity), nullptr);
    }
  }
}

TEST(MissionTable, AnUnknownKeyOfEveryStructureComesWithTheNearest) {
  for (const Struct* table : missionTables()) {
    ordered_json json = needed(*table);
    const std::string wrong = std::string(table->fields.back().key) + "x";
    json[wrong] = 1;
    std::vector<Fault> faults;
    readAs(*table, json, faults);
    ASSERT_EQ(faults.size(), 1u) << table->name;
    EXPECT_EQ(faults[0].pointer, '/' + wrong);
    EXPECT_EQ(faults[0].what, (std::string_view("aeiou").find(table->name[0]) == std::string_view::npos ? "a " : "an ") + std::string(table->name) + " has no such key.");
    EXPECT_EQ(faults[0].remedy, "Did you mean " + std::string(table->fields.back().key) + "?");
  }
}

// The table cannot lose a member: whoever adds one to these structures adds a row, or changes these sizes knowingly.
TEST(MissionTable, HasARowForEveryMember) {
  const std::map<std::string_view, std::size_t> rows{{"mission", 15}, {"world", 4}, {"terrain", 11}, {"weather", 5}, {"vehicle type", 11}, {"vehicle", 11}, {"group", 9}, {"battery", 14}, {"gun", 2},
                                                     {"observer", 15}, {"sensing", 13}, {"mission order", 2}, {"fdc", 10}};
  for (const Struct* table : missionTables()) EXPECT_EQ(table->fields.size(), rows.at(table->name)) << table->name;
}

}  // namespace
}  // namespace npsee::world
