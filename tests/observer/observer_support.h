#pragma once

#include "sim/observer/mind.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace npsee::observer {

/// A mind with its facts, told and asked in short phrases.
class Observer {
 public:
  explicit Observer(MindSetup setup = destroyTanks()) : mind_(made(setup)) { self(); }

  static MindSetup destroyTanks() {
    MindSetup setup;
    setup.orders = {{MissionAction::destroy, 51}};
    return setup;
  }
  static MindSetup withRules(std::string rules) {
    MindSetup setup = destroyTanks();
    setup.rules = std::move(rules);
    setup.rules_name = "own.clp";
    return setup;
  }

  void self(SelfFacts facts = {}) {
    if (facts.type == 0) facts.type = 8;
    mind_.self(facts);
  }
  /// A T-72 he is sure of.
  static Contact tank(int id, double range_m) {
    Contact out;
    out.id = id;
    out.type = 51;
    out.type_name = "T-72";
    out.range_m = range_m;
    out.x_m = range_m;
    return out;
  }
  static Contact uncertainTank(int id, double range_m) {
    Contact out = tank(id, range_m);
    out.location_error_m = 200.0;
    return out;
  }
  static MissionFact mission(int number, int contact, MissionFact::State state, FireMethod method = FireMethod::adjust_fire, double ot_distance_m = 3000.0) {
    MissionFact out;
    out.mission = number;
    out.contact = contact;
    out.state = state;
    out.method = method;
    out.ot_distance_m = ot_distance_m;
    return out;
  }

  std::vector<Decision> think() {
    std::vector<Decision> out;
    const auto thought = mind_.think(out);
    EXPECT_TRUE(thought) << (thought ? "" : thought.error().text());
    return out;
  }
  /// The only decision of one run.
  Decision one() {
    const auto all = think();
    EXPECT_EQ(all.size(), 1u) << told(all);
    return all.empty() ? Decision{} : all.front();
  }
  void nothing() {
    const auto all = think();
    EXPECT_TRUE(all.empty()) << told(all);
  }
  Mind& mind() { return mind_; }

  static std::string told(const Decision& decision) {
    static constexpr const char* kKinds[] = {"call", "correct", "effect", "end", "withdraw", "warn"};
    std::string out = kKinds[static_cast<int>(decision.kind)];
    if (decision.kind == Decision::Kind::call) out += " " + std::to_string(decision.contact) + " " + methodName(decision.method);
    if (decision.kind == Decision::Kind::correct || decision.kind == Decision::Kind::fire_for_effect)
      out += " " + std::to_string(decision.mission) + " right " + std::to_string(static_cast<int>(decision.right_m)) + " add " + std::to_string(static_cast<int>(decision.add_m));
    if (decision.kind == Decision::Kind::end) out += " " + std::to_string(decision.mission);
    if (!decision.reason.empty()) out += " " + decision.reason;
    return out;
  }
  static std::string told(const std::vector<Decision>& decisions) {
    std::string out;
    for (const Decision& decision : decisions) out += told(decision) + "\n";
    return out;
  }
  static std::string methodName(FireMethod method) {
    static constexpr const char* kNames[] = {"automatic", "adjust_fire", "fire_for_effect", "suppress", "immediate_suppression", "smoke", "illuminate"};
    return kNames[static_cast<int>(method)];
  }

 private:
  static Mind made(const MindSetup& setup) {
    auto mind = Mind::make(setup);
    EXPECT_TRUE(mind) << (mind ? "" : mind.error().text());
    if (!mind) throw std::runtime_error(mind.error().text());
    return std::move(*mind);
  }
  Mind mind_;
};

}  // namespace npsee::observer
