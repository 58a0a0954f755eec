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

TEST(JsonText, RefusesAKeyGivenTwiceWithBothItsPlaceAndPointer) {
  const auto json = JsonText::parse("{\"a\": 1,\n\"b\": {\"c\": 1,\n\"c\": 2}}", "f");
  ASSERT_FALSE(json);
  EXPECT_TRUE(json.error().text().starts_with("f:3: /b/c: is given twice.")) << json.error().text();
}

}  // namespace
}  // namespace npsee
