#include <npsee/parameters.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>

namespace npsee {

void PrintTo(const Parameter* row, std::ostream* out) { *out << row->key; }

namespace {

Preset onePreset() {
  Preset preset;
  preset.layers.emplace_back();
  return preset;
}

/// A valid value that differs from the row's default.
Value another(const Parameter& row) {
  switch (row.type) {
    case ParameterType::boolean: return !std::get<bool>(row.initial);
    case ParameterType::integer: return static_cast<std::int64_t>(row.hard.max);
    case ParameterType::number: return toSi(row.unit, row.hard.min + 0.3 * (row.hard.max - row.hard.min));
    case ParameterType::choice: return std::string(std::get<std::string>(row.initial) == row.choices.back() ? row.choices.front() : row.choices.back());
    case ParameterType::text: return std::string("other \"text\"\n\xc3\xa9");
    case ParameterType::vector: return Vec3{0.25, 0.5, -0.75};
    case ParameterType::colour: return Colour{0.1, 0.2, 1.0};
    case ParameterType::curve: return Curve{{0.0, 1.0}, {0.3, 0.25}, {1.0, 0.0}};
    case ParameterType::gradient: return Gradient{{0.0, {1, 1, 1}}, {1.0, {0.123, 0.2, 0.0}}};
  }
  return row.initial;
}

class EveryParameter : public testing::TestWithParam<const Parameter*> {};

std::vector<const Parameter*> allRows() {
  std::vector<const Parameter*> out;
  for (const Parameter& row : parameters()) out.push_back(&row);
  return out;
}

Value valueOf(const Parameter& row, const Preset& preset) { return row.scope == Scope::burst ? row.get(preset) : row.get(preset.layers[0]); }

void assign(const Parameter& row, Preset& preset, const Value& value) {
  if (row.scope == Scope::burst) row.assign(preset, value);
  else row.assign(preset.layers[0], value);
}

TEST_P(EveryParameter, HasWordsARangeThatHoldsSliderAndDefault) {
  const Parameter& row = *GetParam();
  EXPECT_FALSE(row.key.empty());
  EXPECT_FALSE(row.label.empty());
  EXPECT_TRUE(row.doc.ends_with('.')) << row.doc;
  EXPECT_LE(row.hard.min, row.slider.min);
  EXPECT_GE(row.hard.max, row.slider.max);
  if (row.scale == Scale::logarithmic) {
    EXPECT_GT(row.slider.min, 0.0);
  }
  EXPECT_EQ(checkValue(row, row.initial), "");
}

TEST_P(EveryParameter, IsSavedAndReadBackAsTheSameValue) {
  const Parameter& row = *GetParam();
  Preset preset = onePreset();
  if (row.key == "name") assign(row, preset, Value(std::string("other-name")));
  else if (row.key == "parent" || row.key == "trigger") return;  // needs a second layer: Presets.ATreeOfLayersSurvives
  else assign(row, preset, another(row));
  if (row.key == "density") preset.layers[0].region_radius_m = 0.1;  // within the particle budget
  const std::string text = presetText(preset);
  const auto read = parsePreset(text, "f");
  ASSERT_TRUE(read) << read.error().text() << text;
  EXPECT_EQ(*read, preset);
  EXPECT_EQ(presetText(*read), text);
}

TEST_P(EveryParameter, IsSetFromTheCommandLineByItsOwnText) {
  const Parameter& row = *GetParam();
  const Value value = row.key == "name" ? Value(std::string("n2")) : another(row);
  const auto parsed = parseValue(row, valueText(row, value));
  ASSERT_TRUE(parsed) << parsed.error().text();
  EXPECT_EQ(*parsed, value);

  Preset preset = onePreset();
  const std::string key = (row.scope == Scope::layer ? "fragments." : "") + std::string(row.key);
  const auto applied = applySetting(preset, key + "=" + valueText(row, value));
  ASSERT_TRUE(applied) << applied.error().text();
  EXPECT_EQ(valueOf(row, preset), value);
}

TEST_P(EveryParameter, RefusesNumbersBeyondItsRangeNamingTheLimit) {
  const Parameter& row = *GetParam();
  if (row.type != ParameterType::number && row.type != ParameterType::integer) return;
  const std::string beyond = row.type == ParameterType::integer ? "9007199254740993" : shortest(row.hard.max * 1.5 + 1.0);
  const auto parsed = parseValue(row, beyond);
  ASSERT_FALSE(parsed);
  EXPECT_NE(parsed.error().text().find("above the limit of " + shortest(row.hard.max)), std::string::npos) << parsed.error().text();
  EXPECT_FALSE(parseValue(row, "nan"));
  EXPECT_FALSE(parseValue(row, "-1e300"));
  EXPECT_FALSE(parseValue(row, ""));
}

TEST_P(EveryParameter, RefusesAFileValueOfAnotherTypeAtItsPlace) {
  const Parameter& row = *GetParam();
  nlohmann::json wrong = {{"npsee", 1}, {"layers", {nlohmann::json::object()}}};
  std::string pointer = row.scope == Scope::layer ? "/layers/0/" : "/";
  pointer += row.key;
  std::ranges::replace(pointer, '.', '/');
  wrong[nlohmann::json::json_pointer(pointer)] = {{"not", "this"}};
  const auto read = parsePreset(wrong.dump(), "bad.json");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().text().find("bad.json:1: " + pointer + ": " + std::string(row.key) + " is {"), std::string::npos) << read.error().text();
}

TEST_P(EveryParameter, StandsInEveryFormOfTheReference) {
  const std::string key(GetParam()->key);
  for (const auto format : {ReferenceFormat::text, ReferenceFormat::markdown, ReferenceFormat::json}) EXPECT_NE(parameterReference(format)->find(key), std::string::npos);
  const auto schema = nlohmann::json::parse(*parameterReference(ReferenceFormat::json_schema));
  std::string pointer = GetParam()->scope == Scope::layer ? "/properties/layers/items" : "";
  std::string rest = key;
  for (std::size_t dot; (dot = rest.find('.')) != std::string::npos; rest.erase(0, dot + 1)) pointer += "/properties/" + rest.substr(0, dot);
  EXPECT_TRUE(schema.contains(nlohmann::json::json_pointer(pointer + "/properties/" + rest)));
}

std::string nameOfCase(const testing::TestParamInfo<const Parameter*>& test) {
  std::string name = (test.param->scope == Scope::burst ? "burst_" : "layer_") + std::string(test.param->key);
  std::ranges::replace(name, '.', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Table, EveryParameter, testing::ValuesIn(allRows()), nameOfCase);

TEST(ParameterTable, KeysAreUniqueWithinTheirScope) {
  std::set<std::pair<Scope, std::string_view>> seen;
  for (const Parameter& row : parameters()) EXPECT_TRUE(seen.emplace(row.scope, row.key).second) << row.key;
}

TEST(ParameterTable, HoldsEveryParameterOfTheThesis) {
  for (const char* key : {"region.shape", "region.radius", "density", "ejection_angle", "speed_mean", "speed_deviation", "size_mean", "size_deviation", "trajectory", "colour",
                          "lifetime_mean", "restitution", "friction", "collide"})
    EXPECT_NE(findParameter(Scope::layer, key), nullptr) << key;
  EXPECT_NE(findParameter(Scope::burst, "burst"), nullptr);
}

}  // namespace
}  // namespace npsee
