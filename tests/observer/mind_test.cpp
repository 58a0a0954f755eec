#include "tests/observer/observer_support.h"

#include <algorithm>

namespace npsee::observer {
namespace {

using State = MissionFact::State;

// ----- contacts and targets -----

TEST(Observer, CallsFireOnAHostileContactOfAnOrderedType) {
  Observer observer;
  observer.mind().contact(Observer::tank(3, 2000.0));
  const Decision call = observer.one();
  EXPECT_EQ(Observer::told(call), "call 3 fire_for_effect");
  EXPECT_EQ(call.rule, "call-on-most-dangerous");
  observer.nothing();
}

TEST(Observer, ExplainsADecisionByTheFactsItsRuleFiredOn) {
  Observer observer;
  observer.mind().contact(Observer::tank(3, 2000.0));
  const Decision call = observer.one();
  ASSERT_FALSE(call.facts.empty());
  const auto contact = std::ranges::find_if(call.facts, [](const std::string& fact) { return fact.starts_with("(contact "); });
  ASSERT_NE(contact, call.facts.end());
  EXPECT_NE(contact->find("(id 3)"), std::string::npos) << *contact;
  EXPECT_NE(contact->find("(range 2000)"), std::string::npos) << *contact;
  EXPECT_NE(contact->find("(name T-72)"), std::string::npos) << *contact;
  EXPECT_TRUE(std::ranges::any_of(call.facts, [](const std::string& fact) { return fact == "(target (id 3) (action destroy) (state waiting) (mission 0) (x none) (z none) (own-x none) (own-z none))"; }));
  EXPECT_EQ(observer.mind().lastRule(), "call-on-most-dangerous");
}

TEST(Observer, DismissesFriendlyContactsAndLeavesOtherHostilesAlone) {
  Observer observer;
  Contact friendly = Observer::tank(1, 1000.0);
  friendly.type = 8;
  friendly.hostile = 0.0;
  friendly.friendly = 1.0;
  Contact truck = Observer::tank(2, 1500.0);
  truck.type = 54;
  observer.mind().contact(friendly);
  observer.mind().contact(truck);
  observer.nothing();
  for (const std::string& fact : observer.mind().facts()) EXPECT_EQ(fact.find("(contact (id 1)"), std::string::npos) << fact;
}

TEST(Observer, WaitsWhileHeIsUndecidedAboutAContact) {
  Observer observer;
  Contact contact = Observer::tank(1, 2000.0);
  contact.hostile = 0.3;
  contact.friendly = 0.1;
  observer.mind().contact(contact);
  observer.nothing();
  contact.hostile = 0.7;
  observer.mind().contact(contact);
  EXPECT_EQ(Observer::told(observer.one()), "call 1 adjust_fire") << "the identification is not certain";
}

TEST(Observer, ObeysAnOrderAgainstHisOwnTypeWithAWarning) {
  MindSetup setup;
  setup.orders = {{MissionAction::destroy, 8}};
  Observer observer(setup);
  Contact own = Observer::tank(4, 2000.0);
  own.type = 8;
  own.type_name = "M577";
  own.hostile = 0.0;
  own.friendly = 1.0;
  observer.mind().contact(own);
  EXPECT_EQ(Observer::told(observer.think()), "warn ordered to destroy M577, the observer's own vehicle type\ncall 4 fire_for_effect\n");
}

TEST(Observer, TakesTheNearestTargetThatCanStillFightFirst) {
  Observer observer;
  Contact damaged = Observer::tank(1, 900.0);
  damaged.condition = Contact::Condition::damaged;
  observer.mind().contact(damaged);
  observer.mind().contact(Observer::tank(2, 3000.0));
  observer.mind().contact(Observer::tank(3, 1500.0));
  Contact destroyed = Observer::tank(4, 600.0);
  destroyed.condition = Contact::Condition::destroyed;
  observer.mind().contact(destroyed);
  EXPECT_EQ(Observer::told(observer.think()), "call 3 fire_for_effect\n");
}

TEST(Observer, HasAsManyMissionsOpenAsHeHasBatteries) {
  MindSetup setup = Observer::destroyTanks();
  setup.max_missions = 2;
  Observer observer(setup);
  for (int id = 1; id <= 4; ++id) observer.mind().contact(Observer::tank(id, 1000.0 * id));
  EXPECT_EQ(Observer::told(observer.think()), "call 1 fire_for_effect\ncall 2 fire_for_effect\n");
  observer.mind().mission(Observer::mission(1, 1, State::accepted, FireMethod::fire_for_effect));
  observer.mind().mission(Observer::mission(2, 2, State::accepted, FireMethod::fire_for_effect));
  observer.nothing();
  Contact destroyed = Observer::tank(1, 1000.0);
  destroyed.condition = Contact::Condition::destroyed;
  observer.mind().contact(destroyed);
  observer.mind().mission(Observer::mission(1, 1, State::effect_over, FireMethod::fire_for_effect));
  EXPECT_EQ(Observer::told(observer.think()), "end 1 destroyed\ncall 3 fire_for_effect\n");
}

TEST(Observer, IgnoresTargetsOutOfSightOrReach) {
  Observer observer;
  Contact hidden = Observer::tank(1, 1000.0);
  hidden.seen = false;
  observer.mind().contact(hidden);
  observer.mind().contact(Observer::tank(2, 4500.0));
  observer.nothing();
}

TEST(Observer, FollowsTheStrongestOfSeveralOrders) {
  MindSetup setup;
  setup.orders = {{MissionAction::special, 51}, {MissionAction::destroy, 51}, {MissionAction::neutralize, 51}};
  Observer observer(setup);
  observer.mind().contact(Observer::tank(1, 2000.0));
  observer.one();
  const auto facts = observer.mind().facts();
  EXPECT_TRUE(std::ranges::any_of(facts, [](const std::string& fact) { return fact.starts_with("(target (id 1) (action destroy)"); }));
}

// ----- method -----

TEST(Observer, AdjustsWhereTheLocationIsUncertainOrFriendliesAreNear) {
  for (const bool friendlies : {false, true}) {
    Observer observer;
    Contact contact = Observer::tank(1, 2000.0);
    if (friendlies)
      contact.friendly_distance_m = 400.0;
    else
      contact.location_error_m = 200.0;
    observer.mind().contact(contact);
    EXPECT_EQ(Observer::told(observer.one()), "call 1 adjust_fire");
  }
}

TEST(Observer, FiresForEffectAtOnceOnWhatWillNotWait) {
  Observer observer;
  Contact contact = Observer::uncertainTank(1, 2000.0);
  contact.speed_mps = 10.0;
  observer.mind().contact(contact);
  EXPECT_EQ(Observer::told(observer.one()), "call 1 fire_for_effect");
}

TEST(Observer, UsesTheConfiguredMethod) {
  for (const FireMethod method : {FireMethod::adjust_fire, FireMethod::fire_for_effect, FireMethod::suppress, FireMethod::immediate_suppression, FireMethod::smoke, FireMethod::illuminate}) {
    Observer observer;
    SelfFacts self;
    self.method = method;
    observer.self(self);
    observer.mind().contact(Observer::tank(1, 2000.0));
    EXPECT_EQ(observer.one().method, method);
  }
}

// ----- effect -----

/// The end of a mission for effect with a condition of the target; empty if it is repeated.
std::string endWith(MissionAction action, Contact::Condition condition, FireMethod method = FireMethod::fire_for_effect) {
  MindSetup setup;
  setup.orders = {{action, 51}};
  Observer observer(setup);
  SelfFacts self;
  self.method = method;
  observer.self(self);
  observer.mind().contact(Observer::tank(1, 2000.0));
  observer.one();
  observer.mind().mission(Observer::mission(1, 1, State::accepted, method));
  observer.nothing();
  observer.mind().mission(Observer::mission(1, 1, State::effect, method));
  observer.nothing();
  Contact after = Observer::tank(1, 2000.0);
  after.condition = condition;
  observer.mind().contact(after);
  observer.mind().mission(Observer::mission(1, 1, State::effect_over, method));
  const Decision decision = observer.one();
  if (decision.kind == Decision::Kind::fire_for_effect) return "again";
  observer.mind().mission(Observer::mission(1, 1, State::ended, method));
  observer.nothing();
  return decision.reason;
}

TEST(Observer, EndsAMissionByWhatWasOrdered) {
  using Condition = Contact::Condition;
  EXPECT_EQ(endWith(MissionAction::destroy, Condition::destroyed), "destroyed");
  EXPECT_EQ(endWith(MissionAction::destroy, Condition::damaged), "again");
  EXPECT_EQ(endWith(MissionAction::destroy, Condition::suppressed), "again");
  EXPECT_EQ(endWith(MissionAction::destroy, Condition::whole), "again");
  EXPECT_EQ(endWith(MissionAction::neutralize, Condition::destroyed), "destroyed");
  EXPECT_EQ(endWith(MissionAction::neutralize, Condition::damaged), "neutralised");
  EXPECT_EQ(endWith(MissionAction::neutralize, Condition::suppressed), "suppressed");
  EXPECT_EQ(endWith(MissionAction::neutralize, Condition::whole), "again");
  EXPECT_EQ(endWith(MissionAction::special, Condition::whole), "no effect seen");
  EXPECT_EQ(endWith(MissionAction::special, Condition::suppressed), "suppressed");
  EXPECT_EQ(endWith(MissionAction::destroy, Condition::suppressed, FireMethod::suppress), "suppressed");
  EXPECT_EQ(endWith(MissionAction::destroy, Condition::whole, FireMethod::smoke), "screened");
  EXPECT_EQ(endWith(MissionAction::destroy, Condition::whole, FireMethod::illuminate), "illuminated");
}

/// The reason for ending a mission against one of several tanks that stand together, of which some are damaged; empty if it goes on.
std::string areaEnd(MissionAction action, int tanks, int damaged) {
  MindSetup setup;
  setup.orders = {{action, 51}, {MissionAction::special, 51}};
  Observer observer(setup);
  for (int id = 1; id <= tanks; ++id) observer.mind().contact(Observer::tank(id, 2000.0 + 5.0 * id));
  Contact apart = Observer::tank(99, 3000.0);
  apart.condition = Contact::Condition::damaged;
  observer.mind().contact(apart);
  EXPECT_EQ(observer.one().contact, 1);
  for (int id = tanks; id > tanks - damaged; --id) {
    Contact hit = Observer::tank(id, 2000.0 + 5.0 * id);
    hit.condition = Contact::Condition::damaged;
    observer.mind().contact(hit);
  }
  observer.mind().mission(Observer::mission(1, 1, State::effect_over, FireMethod::fire_for_effect));
  const auto decisions = observer.think();
  return !decisions.empty() && decisions.front().kind == Decision::Kind::end ? decisions.front().reason : "";
}

TEST(Observer, JudgesAnAreaByTheShareOfItsVehiclesThatAreHit) {
  EXPECT_EQ(areaEnd(MissionAction::neutralize, 10, 0), "");
  EXPECT_EQ(areaEnd(MissionAction::neutralize, 10, 1), "no effect seen, area neutralised (1 of 10 vehicles hit)");
  EXPECT_EQ(areaEnd(MissionAction::neutralize, 11, 1), "") << "under a tenth";
  EXPECT_EQ(areaEnd(MissionAction::neutralize, 10, 3), "no effect seen, area destroyed (3 of 10 vehicles hit)");
  EXPECT_EQ(areaEnd(MissionAction::neutralize, 2, 1), "") << "two vehicles are no area";
  EXPECT_EQ(areaEnd(MissionAction::destroy, 10, 3), "") << "destroy means the target itself";
}

TEST(Observer, RepeatsEffectTenTimesAtMost) {
  Observer observer;
  observer.mind().contact(Observer::tank(1, 2000.0));
  observer.one();
  int volleys = 0;
  for (; volleys < 20; ++volleys) {
    observer.mind().mission(Observer::mission(1, 1, State::effect, FireMethod::fire_for_effect));
    observer.nothing();
    observer.mind().mission(Observer::mission(1, 1, State::effect_over, FireMethod::fire_for_effect));
    const Decision decision = observer.one();
    if (decision.kind == Decision::Kind::end) {
      EXPECT_EQ(decision.reason, "no effect seen after 10 volleys");
      break;
    }
    EXPECT_EQ(decision.kind, Decision::Kind::fire_for_effect);
    observer.nothing();
  }
  EXPECT_EQ(volleys, 9);
  observer.mind().mission(Observer::mission(1, 1, State::ended, FireMethod::fire_for_effect));
  observer.nothing();
}

TEST(Observer, CorrectsAVolleyThatIsSeenToBeOff) {
  Observer observer;
  observer.mind().contact(Observer::tank(1, 2000.0));
  observer.one();
  observer.mind().mission(Observer::mission(1, 1, State::effect, FireMethod::fire_for_effect, 2000.0));
  observer.nothing();
  observer.mind().mission(Observer::mission(1, 1, State::effect_over, FireMethod::fire_for_effect, 2000.0));
  observer.mind().spot({1, 1, true, 30.0, -80.0});
  EXPECT_EQ(Observer::told(observer.one()), "effect 1 right -60 add 50");
}

TEST(Observer, StopsFiringAtWhatHeNoLongerSees) {
  Observer observer;
  observer.mind().contact(Observer::tank(1, 2000.0));
  observer.one();
  observer.mind().mission(Observer::mission(1, 1, State::effect, FireMethod::fire_for_effect));
  observer.nothing();
  Contact hidden = Observer::tank(1, 2000.0);
  hidden.seen = false;
  observer.mind().contact(hidden);
  observer.mind().mission(Observer::mission(1, 1, State::effect_over, FireMethod::fire_for_effect));
  EXPECT_EQ(Observer::told(observer.one()), "end 1 target out of sight, no effect seen");
}

TEST(Observer, EndsTheMissionWhenTheContactIsForgotten) {
  Observer observer;
  observer.mind().contact(Observer::tank(1, 2000.0));
  observer.one();
  observer.mind().mission(Observer::mission(1, 1, State::accepted));
  observer.nothing();
  observer.mind().forget(1);
  EXPECT_EQ(Observer::told(observer.one()), "end 1 the target is gone");
}

// ----- refusals -----

TEST(Observer, EndsARefusedMissionAndCallsAgainOnlyWhenSomethingChanged) {
  Observer observer;
  observer.mind().contact(Observer::tank(1, 2000.0));
  observer.one();
  MissionFact refused = Observer::mission(1, 1, State::refused, FireMethod::fire_for_effect);
  refused.reason = "out of range: 12,700 m of 7,300 m";
  observer.mind().mission(refused);
  EXPECT_EQ(Observer::told(observer.one()), "end 1 out of range: 12,700 m of 7,300 m");
  observer.mind().mission(Observer::mission(1, 1, State::ended, FireMethod::fire_for_effect));
  observer.nothing();
  Contact moved = Observer::tank(1, 2150.0);
  observer.mind().contact(moved);
  observer.nothing();
  moved = Observer::tank(1, 2250.0);
  observer.mind().contact(moved);
  EXPECT_EQ(Observer::told(observer.one()), "call 1 fire_for_effect");
}

TEST(Observer, TakesTheNextTargetWhenOneIsRefused) {
  Observer observer;
  observer.mind().contact(Observer::tank(1, 1000.0));
  observer.mind().contact(Observer::tank(2, 2000.0));
  observer.one();
  observer.mind().mission(Observer::mission(1, 1, State::refused, FireMethod::fire_for_effect));
  EXPECT_EQ(Observer::told(observer.think()), "end 1\ncall 2 fire_for_effect\n");
}

TEST(Observer, AcceptsThatSomebodyElseEndsHisMission) {
  Observer observer;
  observer.mind().contact(Observer::tank(1, 1000.0));
  observer.mind().contact(Observer::tank(2, 2000.0));
  observer.one();
  observer.mind().mission(Observer::mission(1, 1, State::accepted, FireMethod::fire_for_effect));
  observer.nothing();
  observer.mind().mission(Observer::mission(1, 1, State::ended, FireMethod::fire_for_effect));
  EXPECT_EQ(Observer::told(observer.think()), "call 2 fire_for_effect\n");
}

// ----- self-preservation, night -----

TEST(Observer, LeavesWhenFireFallsNear) {
  Observer observer;
  observer.mind().incoming(800.0);
  observer.nothing();
  observer.mind().incoming(250.0);
  observer.mind().incoming(120.0);
  EXPECT_EQ(Observer::told(observer.think()), "withdraw fire falls 120 m away\n");
  observer.nothing();
}

TEST(Observer, LeavesOnceBeforeAHostileThatComesClose) {
  Observer observer;
  Contact truck = Observer::tank(2, 450.0);
  truck.type = 54;
  truck.type_name = "truck";
  observer.mind().contact(truck);
  EXPECT_EQ(Observer::told(observer.one()), "withdraw truck is 450 m away");
  truck.range_m = 420.0;
  observer.mind().contact(truck);
  observer.nothing();
  truck.range_m = 900.0;
  observer.mind().contact(truck);
  observer.nothing();
  truck.range_m = 400.0;
  observer.mind().contact(truck);
  EXPECT_EQ(Observer::told(observer.one()), "withdraw truck is 400 m away");
}

TEST(Observer, StaysWithoutSelfPreservationAndWhileHeMoves) {
  for (const bool moving : {false, true}) {
    Observer observer;
    SelfFacts self;
    self.self_preservation = moving;
    self.moving = moving;
    observer.self(self);
    observer.mind().incoming(50.0);
    observer.nothing();
  }
}

TEST(Observer, LightsUpATargetLostAtNightAndAttacksItUnderTheLight) {
  MindSetup setup = Observer::destroyTanks();
  Observer observer(setup);
  SelfFacts self;
  self.night = true;
  observer.self(self);
  Contact lost = Observer::tank(1, 1200.0);
  lost.seen = false;
  observer.mind().contact(lost);
  EXPECT_EQ(Observer::told(observer.one()), "call 1 illuminate");
  observer.mind().mission(Observer::mission(1, 1, State::accepted, FireMethod::illuminate));
  observer.nothing();
  observer.mind().mission(Observer::mission(1, 1, State::effect, FireMethod::illuminate));
  observer.nothing();
  observer.mind().contact(Observer::tank(1, 1200.0));
  EXPECT_EQ(Observer::told(observer.one()), "call 1 fire_for_effect");
  observer.mind().mission(Observer::mission(2, 1, State::accepted, FireMethod::fire_for_effect));
  observer.nothing();
  observer.mind().mission(Observer::mission(1, 1, State::effect_over, FireMethod::illuminate));
  EXPECT_EQ(Observer::told(observer.one()), "end 1 illuminated");
}

// ----- the machinery -----

TEST(Observer, DecidesTheSameFromTheSameFactsInAnyOrder) {
  std::string first;
  for (int pass = 0; pass < 3; ++pass) {
    MindSetup setup = Observer::destroyTanks();
    setup.max_missions = 5;
    Observer observer(setup);
    std::string told;
    for (int round = 0; round < 20; ++round) {
      std::vector<int> ids;
      for (int id = 0; id < 30; ++id) ids.push_back(id);
      if (pass == 1) std::ranges::reverse(ids);
      if (pass == 2) std::ranges::rotate(ids, ids.begin() + 11);
      for (const int id : ids) observer.mind().contact(Observer::tank(id, 1000.0 + (id * 37 + round * 11) % 1500));
      for (const Decision& decision : observer.think()) {
        told += Observer::told(decision) + " " + decision.rule + "\n";
        for (const std::string& fact : decision.facts) told += fact + "\n";
        if (decision.kind == Decision::Kind::call) observer.mind().mission(Observer::mission(decision.contact + 1, decision.contact, round % 3 == 0 ? State::refused : State::effect_over, decision.method));
        if (decision.kind == Decision::Kind::end) observer.mind().mission(Observer::mission(decision.mission, decision.contact, State::ended));
      }
    }
    if (pass == 0)
      first = told;
    else
      EXPECT_EQ(told, first);
  }
  EXPECT_NE(first.find("call"), std::string::npos);
}

TEST(Observer, TellsHisRulesOnlyOfChangesThatMatter) {
  Observer observer;
  observer.mind().contact(Observer::tank(1, 2000.0));
  observer.one();
  const auto before = observer.mind().facts();
  Contact nearly = Observer::tank(1, 2015.0);
  nearly.hostile = 0.99;
  observer.mind().contact(nearly);
  EXPECT_EQ(observer.mind().facts(), before);
  nearly.friendly_distance_m = 590.0;
  observer.mind().contact(nearly);
  EXPECT_NE(observer.mind().facts(), before) << "danger close is a limit";
}

TEST(Observer, DoesNotGrowWhileContactsMove) {
  Observer observer;
  std::size_t facts = 0;
  for (int round = 0; round < 2000; ++round) {
    for (int id = 0; id < 20; ++id) {
      Contact contact = Observer::tank(id, 1000.0 + (round * 7 + id * 13) % 900);
      contact.type = 54;
      observer.mind().contact(contact);
    }
    observer.think();
    if (round == 10) facts = observer.mind().facts().size();
  }
  EXPECT_EQ(observer.mind().facts().size(), facts);
}

}  // namespace
}  // namespace npsee::observer
