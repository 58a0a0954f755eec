#include "sim/core/files.h"
#include "sim/observer/mind_data.h"
#include "tests/observer/observer_support.h"

namespace npsee::observer {
namespace {

std::string documentation() {
  const auto text = readTextFile(std::string(NPSEE_SOURCE_DIR) + "/docs/rules.md");
  EXPECT_TRUE(text);
  return text ? *text : std::string();
}
bool names(const std::string& text, std::string_view word) { return text.find("`" + std::string(word) + "`") != std::string::npos; }

std::string example() {
  const std::string text = documentation(), mark = "```clips\n";
  const auto from = text.find(mark), to = text.find("```", from + mark.size());
  EXPECT_NE(to, std::string::npos);
  return text.substr(from + mark.size(), to - from - mark.size());
}

TEST(RulesDocumentation, NamesEverySlotTheSimulatorAsserts) {
  const std::string text = documentation();
  const auto forms = readRules(shippedFiles(false).front().text, "templates.clp");
  ASSERT_TRUE(forms);
  int slots = 0;
  for (const RuleNode& form : *forms) {
    EXPECT_TRUE(names(text, form.items[1].text)) << form.items[1].text;
    for (const RuleNode& slot : form.items)
      if (slot.head() == "slot") {
        ++slots;
        EXPECT_TRUE(names(text, slot.items[1].text)) << form.items[1].text << " " << slot.items[1].text;
      }
  }
  EXPECT_GT(slots, 40);
}

TEST(RulesDocumentation, NamesEveryShippedRuleAndFunction) {
  const std::string text = documentation();
  int rules = 0;
  for (const ShippedFile& file : shippedFiles(true)) {
    const auto forms = readRules(file.text, file.name);
    ASSERT_TRUE(forms);
    EXPECT_NE(text.find(file.name), std::string::npos) << file.name;
    for (const RuleNode& form : *forms) {
      EXPECT_TRUE(names(text, form.items[1].text)) << form.items[1].text;
      rules += form.head() == "defrule" ? 1 : 0;
    }
  }
  EXPECT_GT(rules, 40);
}

TEST(RulesDocumentation, NamesEveryAllowedFunctionAndConstruct) {
  const std::string text = documentation();
  for (const std::string_view name : allowedFunctions()) EXPECT_TRUE(names(text, name)) << name;
  for (const std::string_view name : allowedConstructs()) EXPECT_TRUE(names(text, name)) << name;
  for (const std::string_view name : decisionFunctions()) EXPECT_NE(text.find("`(" + std::string(name) + " "), std::string::npos) << name;
}

TEST(RulesDocumentation, StatesTheLimitsThatHold) {
  const std::string text = documentation();
  const HostLimits limits;
  EXPECT_EQ(limits.firings, 20'000);
  EXPECT_EQ(limits.steps, 5'000'000);
  EXPECT_EQ(limits.joins, 20'000'000);
  EXPECT_EQ(limits.facts, 50'000);
  EXPECT_EQ(limits.memory_bytes, 64L << 20);
  EXPECT_EQ(kMaxRulesText, 64u << 10);
  EXPECT_EQ(kMaxRulesNesting, 64);
  for (const char* stated : {"20,000 firings", "5,000,000 steps", "20,000,000 combinations", "50,000 facts", "64 MiB", "64 KiB", "nested 64 deep"}) EXPECT_NE(text.find(stated), std::string::npos) << stated;
}

TEST(RulesDocumentation, HasAnExampleThatWorks) {
  const std::string rules = example();
  for (const Fault& fault : checkRules(rules, "careful.clp")) ADD_FAILURE() << fault.text();
  Observer observer(Observer::withRules(rules));
  Contact near_village = Observer::tank(1, 1000.0), far = Observer::tank(2, 3000.0);
  near_village.x_m = 26000.0;
  near_village.z_m = 25000.0;
  far.x_m = 28000.0;
  far.z_m = 25000.0;
  observer.mind().contact(near_village);
  observer.mind().contact(far);
  EXPECT_EQ(Observer::told(observer.think()), "warn spares the village near T-72 1\ncall 2 fire_for_effect\n");
  observer.mind().incoming(150.0);
  observer.nothing();
  observer.mind().incoming(50.0);
  EXPECT_EQ(Observer::told(observer.think()), "withdraw fire falls 50 m away\n");
}

}  // namespace
}  // namespace npsee::observer
