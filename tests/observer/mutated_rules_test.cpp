// Damaged rules files: each is refused with a message or thinks. And the shipped rules, taken as if they came from somebody else.
#include "sim/observer/mind_data.h"
#include "tests/observer/observer_support.h"
#include "tests/support/damage.h"

#include <random>

namespace npsee::observer {
namespace {

/// With what parsers and rules stumble over.
std::string damaged(std::string text, std::mt19937& random) {
  static const char* const kTraps[] = {"(", ")", "\"", "?", "$?", "&", "~", "|", ":", "=", "=>", "<-", "not", "test", "and", "or", "-9223372036854775808", "1e999", "nan", "(retract ?target)", "(exit)",
                                       "none", "TRUE", "?id", ";", "0", "-1", "(not (contact))", "\n", "\xff", "(while TRUE do)", "contact", "(assert (target (id 3)))", "declare"};
  return test::damaged(std::move(text), random, kTraps, 3);
}

/// The shipped rules in one file.
std::string shippedText() {
  std::string out;
  for (const ShippedFile& file : shippedFiles(true))
    if (file.name.find("templates") == std::string_view::npos) out += file.text;
  return out;
}

MindSetup alone(std::string rules) {
  MindSetup setup = Observer::withRules(std::move(rules));
  setup.shipped_rules = false;
  return setup;
}

TEST(MutatedRules, AreRefusedWithAMessageOrThink) {
  std::mt19937 random(1993);
  int thought = 0, refused = 0;
  for (int i = 0; i < 120; ++i) {
    auto mind = Mind::make(alone(damaged(shippedText(), random)));
    if (!mind) {
      ++refused;
      ASSERT_FALSE(mind.error().faults.empty());
      for (const Fault& fault : mind.error().faults) EXPECT_FALSE(fault.what.empty());
      continue;
    }
    ++thought;
    mind->contact(Observer::tank(1, 1500.0));
    mind->self({});
    std::vector<Decision> decisions;
    const auto outcome = mind->think(decisions);
    EXPECT_TRUE(outcome || !outcome.error().text().empty());
  }
  EXPECT_GT(thought, 10);
  EXPECT_GT(refused, 10);
}

TEST(MutatedRules, AreCheckedAsTextWhateverTheyAre) {
  std::mt19937 random(7);
  const KnownRules known = shippedNames(true);
  for (int i = 0; i < 3000; ++i) {
    const std::string text = damaged(damaged(shippedText().substr(random() % 10000, 3000), random), random);
    if (const auto guarded = guardRules(text, "own.clp", known); !guarded) {
      ASSERT_FALSE(guarded.error().faults.empty());
      EXPECT_GT(guarded.error().faults.front().line, 0);
    }
    static_cast<void>(parseObserverFacts(text, "own.clp"));
  }
}

/// A mission with adjustment, effect and a refusal, as decisions.
std::string story(Observer observer) {
  using State = MissionFact::State;
  std::string out;
  const auto tell = [&] {
    for (const Decision& decision : observer.think()) {
      out += Observer::told(decision) + " by " + decision.rule + "\n";
      for (const std::string& fact : decision.facts) out += "  " + fact + "\n";
    }
  };
  observer.mind().contact(Observer::uncertainTank(1, 2400.0));
  observer.mind().contact(Observer::tank(2, 2600.0));
  tell();
  observer.mind().mission(Observer::mission(1, 1, State::accepted));
  tell();
  for (const double range : {350.0, -50.0, -150.0, 60.0}) {
    observer.mind().spot({1, 1, true, 12.0, range});
    tell();
  }
  observer.mind().mission(Observer::mission(1, 1, State::effect));
  tell();
  observer.mind().mission(Observer::mission(1, 1, State::effect_over));
  tell();
  Contact destroyed = Observer::uncertainTank(1, 2400.0);
  destroyed.condition = Contact::Condition::destroyed;
  observer.mind().contact(destroyed);
  observer.mind().mission(Observer::mission(1, 1, State::effect));
  tell();
  observer.mind().mission(Observer::mission(1, 1, State::effect_over));
  tell();
  observer.mind().mission(Observer::mission(1, 1, State::ended));
  observer.mind().mission(Observer::mission(2, 2, State::refused));
  tell();
  return out;
}

TEST(ForeignRules, DecideAsTheyDoWithoutTheCountersPutBetweenTheirConditions) {
  const std::string shipped = story(Observer());
  EXPECT_EQ(story(Observer(alone(shippedText()))), shipped);
  EXPECT_NE(shipped.find("end 2"), std::string::npos) << shipped;
}

}  // namespace
}  // namespace npsee::observer
