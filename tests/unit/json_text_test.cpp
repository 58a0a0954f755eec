#include "sim/core/json_text.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace npsee {
namespace {

TEST(JsonText, KnowsTheLineOfEveryValue) {
  const auto json = JsonText::parse("{\n \"a\": [1,\n  {\"b/c\": 2}],\n \"d\": \"x\\\"{\\n\"\n}\n", "f.json");
  ASSERT_TRUE(json);
  EXPECT_EQ(json->line(""), 1);
  EXPECT_EQ(json->line("/a"), 2);
  EXPECT_EQ(json->line("/a/1"), 3);
  EXPECT_EQ(json->line("/a/1/b~1c"), 3);
  EXPECT_EQ(json->line("/d"), 4);
  EXPECT_EQ(json->line("/nowhere"), 0);
  EXPECT_EQ(json->line("/a/2"), 0);
  EXPECT_EQ(json->line("/d/0"), 0);
}

TEST(JsonText, NamesTheLineOfASyntaxError) {
  const auto json = JsonText::parse("{\n \"a\": 1\n \"b\": 2\n}", "f.json");
  ASSERT_FALSE(json);
  EXPECT_TRUE(json.error().text().starts_with("f.json:3: is not JSON")) << json.error().text();
}

TEST(JsonText, RefusesNanInfinityHugeNumbersAndDeepNesting) {
  EXPECT_FALSE(JsonText::parse("{\"a\": NaN}", "f"));
  EXPECT_FALSE(JsonText::parse("{\"a\": Infinity}", "f"));
  EXPECT_FALSE(JsonText::parse("{\"a\": 1e999}", "f"));
  const auto deep = JsonText::parse(std::string(100000, '['), "f");
  ASSERT_FALSE(deep);
  EXPECT_NE(deep.error().text().find("nests deeper than 64"), std::string::npos);
}

TEST(JsonText, RefusesMoreKeysInOneObjectThanAnyFileNeeds) {
  const auto object = [](int keys) {
    std::string text;
    for (int i = 0; i < keys; ++i) text += (i == 0 ? "" : ",\n") + ('"' + std::to_string(i)) + "\": [1, 2]";
    return '{' + text + '}';
  };
  EXPECT_TRUE(JsonText::parse(object(kMaxJsonKeys), "f"));
  const auto many = JsonText::parse(object(kMaxJsonKeys + 1), "f");
  ASSERT_FALSE(many);
  EXPECT_EQ(many.error().text(), "f:256: has an object with more than 256 keys.\n  No file of npsee needs that; check what wrote it.");
}

// With a pointer kept for each value this would take a terabyte.
TEST(JsonText, ManyValuesBelowALongKeyTakeMemoryInProportionToTheText) {
  const std::string key(1u << 20, 'k');
  std::string text = "{\"" + key + "\": [0";
  for (int i = 0; i < 1'000'000; ++i) text += ",0";
  const auto json = JsonText::parse(text + ",\n1]}", "f");
  ASSERT_TRUE(json);
  EXPECT_EQ(json->line('/' + key + "/1000001"), 2);
}

TEST(JsonText, RefusesAKeyGivenTwiceWithBothItsPlaceAndPointer) {
  const auto json = JsonText::parse("{\"a\": 1,\n\"b\": {\"c\": 1,\n\"c\": 2}}", "f");
  ASSERT_FALSE(json);
  EXPECT_TRUE(json.error().text().starts_with("f:3: /b/c: is given twice.")) << json.error().text();
}

TEST(JsonText, AWholeNumberIsReadExactlyOrNotAtAll) {
  const auto whole = [](const char* text) { return wholeNumber(nlohmann::ordered_json::parse(text)); };
  EXPECT_EQ(whole("100"), 100);
  EXPECT_EQ(whole("-100.0"), -100);
  EXPECT_EQ(whole("9223372036854775807"), INT64_MAX);
  EXPECT_EQ(whole("9007199254740992.0"), std::int64_t{1} << 53);
  for (const char* none : {"9223372036854775808", "9007199254740994.0", "1e300", "0.5", "\"1\"", "true", "null", "[1]"}) EXPECT_EQ(whole(none), std::nullopt) << none;
}

TEST(JsonText, ALongValueIsShownCutBetweenLetters) {
  EXPECT_EQ(shownJson(nlohmann::ordered_json::parse(R"({"a": [1, 2]})")), R"({"a":[1,2]})");
  EXPECT_EQ(shownJson(std::string(58, 'x')), '"' + std::string(58, 'x') + '"');
  EXPECT_EQ(shownJson(std::string(59, 'x')), '"' + std::string(56, 'x') + "...");
  EXPECT_EQ(shownJson(std::string(55, 'x') + "\xc2\xb0" + std::string(9, 'x')), '"' + std::string(55, 'x') + "...");
}

}  // namespace
}  // namespace npsee
