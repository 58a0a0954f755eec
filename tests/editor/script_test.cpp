#include "editor/script/parser.h"
#include "editor/ui/slider.h"

#include <gtest/gtest.h>

#include <cmath>

namespace npsee::editor {
namespace {

TEST(Script, SplitsWordsQuotesAndTheRestOfTheLine) {
  const auto script = parseScript("# a comment\n\n  set sparks.count 40 \nclick \"layer:fragments 2\"\ntype  two words \ndrag thumb:time 20 -3\nexpect title contains my file\nexpect error =\n", "s.txt");
  ASSERT_TRUE(script.has_value()) << script.error().text();
  ASSERT_EQ(script->size(), 6u);
  EXPECT_EQ((*script)[0].arguments, (std::vector<std::string>{"sparks.count", "40"}));
  EXPECT_EQ((*script)[0].line, 3);
  EXPECT_EQ((*script)[1].arguments, (std::vector<std::string>{"layer:fragments 2"}));
  EXPECT_EQ((*script)[2].arguments, (std::vector<std::string>{"two words"}));
  EXPECT_EQ((*script)[3].arguments, (std::vector<std::string>{"thumb:time", "20", "-3"}));
  EXPECT_EQ((*script)[4].arguments, (std::vector<std::string>{"title", "contains", "my file"}));
  EXPECT_EQ((*script)[5].arguments, (std::vector<std::string>{"error", "="}));
}

TEST(Script, EveryBadLineIsReportedWithFileAndLine) {
  const auto script = parseScript("wait 3\nclik button:play\nset only\nkey ctrl+Wurst\nclick \"open\n", "s.txt");
  ASSERT_FALSE(script.has_value());
  EXPECT_EQ(script.error().kind, ErrorKind::input);
  ASSERT_EQ(script.error().faults.size(), 4u);
  const std::string text = script.error().text();
  EXPECT_NE(text.find("s.txt:2: there is no command \"clik\".\n  Did you mean click?"), std::string::npos) << text;
  EXPECT_NE(text.find("s.txt:3: set has 1 argument.\n  Write: set PARAM VALUE"), std::string::npos) << text;
  EXPECT_NE(text.find("s.txt:4: there is no key \"Wurst\"."), std::string::npos) << text;
  EXPECT_NE(text.find("s.txt:5: a quote is not closed."), std::string::npos) << text;
}

TEST(KeyStroke, IsReadAndPrinted) {
  const auto stroke = parseKeyStroke("ctrl+shift+s");
  ASSERT_TRUE(stroke.has_value());
  EXPECT_EQ(keyText(*stroke), "Ctrl+Shift+S");
  for (const char* name : {"Up", "KP8", "F1", "Space", "Home", "7", "alt+Down"}) {
    const auto parsed = parseKeyStroke(name);
    ASSERT_TRUE(parsed.has_value()) << name;
    EXPECT_EQ(*parseKeyStroke(keyText(*parsed)), *parsed) << name;
  }
  EXPECT_FALSE(parseKeyStroke("ctrl").has_value());
  EXPECT_FALSE(parseKeyStroke("").has_value());
  EXPECT_FALSE(parseKeyStroke("A+B").has_value());
}

TEST(Slider, PlaceAndValueAreInverseForEveryNumberOfTheTable) {
  for (const Parameter& parameter : parameters()) {
    if (parameter.type != ParameterType::number) continue;
    const NumberSpec spec{0.0, parameter.slider, parameter.hard, parameter.scale};
    EXPECT_EQ(valueAt(spec, 0.0, 200, false), parameter.slider.min) << parameter.key;
    EXPECT_EQ(valueAt(spec, 1.0, 200, false), parameter.slider.max) << parameter.key;
    double last = parameter.slider.min;
    for (int i = 0; i <= 200; ++i) {
      const double value = valueAt(spec, i / 200.0, 200, false);
      EXPECT_GE(value, last) << parameter.key;
      EXPECT_NEAR(fractionOf(spec, value), i / 200.0, 1.0 / 200.0) << parameter.key << " rounds by at most a pixel";
      last = value;
    }
  }
}

TEST(Slider, DraggedValuesAreRound) {
  const NumberSpec angle{52.0, {0, 90}, {0, 180}};
  const double value = valueAt(angle, 0.6123, 120, false);
  EXPECT_NEAR(value * 2.0, std::round(value * 2.0), 1e-9) << "half degrees at this width";
  EXPECT_EQ(valueAt({1.0, {0, 16}, {0, 64}, Scale::linear, true}, 0.51, 120, false), 8.0);
}

}  // namespace
}  // namespace npsee::editor
