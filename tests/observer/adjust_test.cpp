#include "tests/observer/observer_support.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee::observer {
namespace {

using State = MissionFact::State;

struct Model {
  double cep_m = 200.0, pe_range_m = 0.0, pe_deflection_m = 0.0;
  double bearing_mil = 0.0, range_fraction = 0.0;
  double ot_distance_m = 3000.0;
  bool danger_close = false;
};
struct Walked {
  int rounds = 0;           ///< adjusting rounds before effect
  double miss_m = 0.0;      ///< of the aim in effect
  double longest_step_m = 0.0;
  bool effect = false;
  std::string table;
};

/// Simple generator of standard normal draws for the test alone (sum of twelve uniforms of a 64-bit linear congruence).
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : state_(seed * 6364136223846793005ull + 1442695040888963407ull) {}
  double normal() {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) {
      state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
      sum += static_cast<double>(state_ >> 11) * 0x1p-53;
    }
    return sum;
  }

 private:
  std::uint64_t state_;
};

/// One mission in the observer's frame: the aim is off by the location error, every round falls off the aim by dispersion, the
/// observer is told burst minus target, and his corrections move the aim. `mind` keeps nothing from one mission to the next.
Walked walk(Observer& observer, int number, const Model& model, std::uint64_t seed) {
  Draws draws(seed);
  const double sigma = model.cep_m / 1.1774100225154747;
  double across = draws.normal() * sigma, along = draws.normal() * sigma;
  Walked out;
  observer.mind().contact(Observer::uncertainTank(number, model.ot_distance_m));
  const Decision call = observer.one();
  EXPECT_EQ(call.kind, Decision::Kind::call);
  MissionFact mission = Observer::mission(number, number, State::accepted, FireMethod::adjust_fire, model.ot_distance_m);
  mission.danger_close = model.danger_close;
  observer.mind().mission(mission);
  observer.nothing();
  for (int round = 1; round <= 30 && !out.effect; ++round) {
    const double burst_across = across + draws.normal() * model.pe_deflection_m / 0.6744897501960817;
    const double burst_along = along + draws.normal() * model.pe_range_m / 0.6744897501960817;
    Spot spot{number, round, true, 0.0, 0.0};
    spot.lateral_mil = std::atan2(burst_across, model.ot_distance_m + burst_along) * 6400.0 / kTwoPi + draws.normal() * model.bearing_mil;
    spot.range_m = burst_along + draws.normal() * model.range_fraction * model.ot_distance_m;
    mission.rounds = round;
    observer.mind().mission(mission);
    observer.mind().spot(spot);
    const Decision decision = observer.one();
    out.table += Observer::told(decision) + " by " + decision.rule + "\n";
    if (decision.kind == Decision::Kind::end) break;
    out.rounds = round;
    out.effect = decision.kind == Decision::Kind::fire_for_effect;
    out.longest_step_m = std::max(out.longest_step_m, std::hypot(decision.right_m, decision.add_m));
    across += decision.right_m;
    along += decision.add_m;
  }
  out.miss_m = std::hypot(across, along);
  Contact destroyed = Observer::tank(number, model.ot_distance_m);
  destroyed.condition = Contact::Condition::destroyed;
  observer.mind().contact(destroyed);
  mission.state = State::effect_over;
  observer.mind().mission(mission);
  observer.think();
  mission.state = State::ended;
  observer.mind().mission(mission);
  observer.mind().forget(number);
  observer.think();
  return out;
}

struct Result {
  int median = 0, p90 = 0, p99 = 0;
  double within_50 = 0.0, within_75 = 0.0, good = 0.0, reached = 0.0, longest_step_m = 0.0;
};
Result simulate(const Model& model, int runs) {
  Observer observer;
  std::vector<int> rounds;
  int within_50 = 0, within_75 = 0, good = 0, reached = 0;
  Result out;
  for (int run = 1; run <= runs; ++run) {
    const Walked walked = walk(observer, run, model, static_cast<std::uint64_t>(run));
    rounds.push_back(walked.rounds);
    within_50 += walked.effect && walked.miss_m <= 50.0;
    within_75 += walked.effect && walked.miss_m <= 75.0;
    good += walked.effect && walked.miss_m <= 50.0 && walked.rounds <= 5;
    reached += walked.effect;
    out.longest_step_m = std::max(out.longest_step_m, walked.longest_step_m);
  }
  std::ranges::sort(rounds);
  const auto quantile = [&rounds](double p) { return rounds[static_cast<std::size_t>(p * static_cast<double>(rounds.size() - 1))]; };
  out.median = quantile(0.5);
  out.p90 = quantile(0.9);
  out.p99 = quantile(0.99);
  out.within_50 = within_50 / static_cast<double>(runs);
  out.within_75 = within_75 / static_cast<double>(runs);
  out.good = good / static_cast<double>(runs);
  out.reached = reached / static_cast<double>(runs);
  return out;
}

constexpr int kRuns = 3000;

// The figures of world.md section 2, measured there with 20,000 runs of the same rules in another language. Bounds leave three
// standard deviations of a sample of 3000.
TEST(Adjustment, ReachesTheTargetInTheMeasuredNumberOfRoundsWithoutDispersion) {
  const Result result = simulate({}, kRuns);
  EXPECT_EQ(result.median, 2);
  EXPECT_EQ(result.p90, 4);
  EXPECT_EQ(result.p99, 5);
  EXPECT_GE(result.within_50, 0.998);
  EXPECT_EQ(result.reached, 1.0);
}

TEST(Adjustment, MeetsScenarioDWithTheGunsDispersion) {
  Model model;
  model.pe_range_m = 15.0;
  model.pe_deflection_m = 4.0;
  const Result result = simulate(model, kRuns);
  EXPECT_GE(result.good, 0.93);
  EXPECT_GE(result.within_75, 0.99);
  RecordProperty("good", std::to_string(result.good));
  RecordProperty("within_75", std::to_string(result.within_75));
}

TEST(Adjustment, IsVisiblyWorseWithErrorsOfSensing) {
  Model model;
  model.bearing_mil = 5.0;
  model.range_fraction = 0.05;
  EXPECT_LE(simulate(model, 1000).within_50, 0.40);
}

TEST(Adjustment, CreepsUpNearFriendliesInStepsOfAHundredMetresAtMost) {
  Model model;
  model.danger_close = true;
  const Result result = simulate(model, 1000);
  EXPECT_LE(result.longest_step_m, 100.0);
  EXPECT_EQ(result.within_75, 1.0);
  EXPECT_GE(result.reached, 0.999);
}

/// Decisions for a list of sensed ranges (all on the line).
std::string decisionsFor(const std::vector<Spot>& spots, double ot_distance_m = 3000.0) {
  Observer observer;
  observer.mind().contact(Observer::uncertainTank(1, ot_distance_m));
  observer.one();
  observer.mind().mission(Observer::mission(1, 1, State::accepted, FireMethod::adjust_fire, ot_distance_m));
  observer.nothing();
  std::string out;
  for (Spot spot : spots) {
    spot.mission = 1;
    observer.mind().spot(spot);
    const Decision decision = observer.one();
    out += Observer::told(decision) + " by " + decision.rule + "\n";
  }
  return out;
}

TEST(Adjustment, BracketsHalvesAndSplits) {
  EXPECT_EQ(decisionsFor({{1, 1, true, 20.0, 450.0}, {1, 2, true, 0.0, -350.0}, {1, 3, true, 0.0, 50.0}, {1, 4, true, 0.0, -150.0}, {1, 5, true, 0.0, -50.0}}),
            "correct 1 right -60 add -800 by shift-across-the-target\n"
            "correct 1 right 0 add 400 by target-is-bracketed\n"
            "correct 1 right 0 add -200 by halve-the-bracket\n"
            "correct 1 right 0 add 100 by halve-the-bracket\n"
            "effect 1 right 0 add 50 by split-the-last-bracket\n");
}

TEST(Adjustment, ShiftsBoldlyByTheSizeOfTheFirstMiss) {
  EXPECT_EQ(decisionsFor({{1, 1, true, 0.0, 401.0}}), "correct 1 right 0 add -800 by shift-across-the-target\n");
  EXPECT_EQ(decisionsFor({{1, 1, true, 0.0, -400.0}}), "correct 1 right 0 add 400 by shift-across-the-target\n");
  EXPECT_EQ(decisionsFor({{1, 1, true, 0.0, 200.0}}), "correct 1 right 0 add -200 by shift-across-the-target\n");
  EXPECT_EQ(decisionsFor({{1, 1, true, 0.0, -100.0}}), "correct 1 right 0 add 100 by shift-across-the-target\n");
  EXPECT_EQ(decisionsFor({{1, 1, true, 0.0, -26.0}}), "correct 1 right 0 add 100 by shift-across-the-target\n");
  EXPECT_EQ(decisionsFor({{1, 1, true, 0.0, -25.0}}), "effect 1 right 0 add 0 by range-is-correct\n");
}

TEST(Adjustment, GoesOnAcrossUntilTheTargetIsEnclosed) {
  EXPECT_EQ(decisionsFor({{1, 1, true, 0.0, 950.0}, {1, 2, true, 0.0, 150.0}, {1, 3, true, 0.0, -50.0}}),
            "correct 1 right 0 add -800 by shift-across-the-target\n"
            "correct 1 right 0 add -200 by shift-across-the-target\n"
            "correct 1 right 0 add 100 by target-is-bracketed\n");
}

TEST(Adjustment, BeginsAgainWhenTheBracketIsLost) {
  EXPECT_EQ(decisionsFor({{1, 1, true, 0.0, 150.0}, {1, 2, true, 0.0, -50.0}, {1, 3, true, 0.0, 250.0}}),
            "correct 1 right 0 add -200 by shift-across-the-target\n"
            "correct 1 right 0 add 100 by target-is-bracketed\n"
            "correct 1 right 0 add -400 by shift-across-the-target\n");
}

TEST(Adjustment, CorrectsDeviationByTheFactorOfTheDistance) {
  const auto right = [](double mils, double distance_m) { return decisionsFor({{1, 1, true, mils, 0.0}}, distance_m); };
  EXPECT_EQ(right(20.0, 3400.0), "effect 1 right -60 add 0 by range-is-correct\n");
  EXPECT_EQ(right(20.0, 3500.0), "effect 1 right -80 add 0 by range-is-correct\n");
  EXPECT_EQ(right(-21.0, 2000.0), "effect 1 right 40 add 0 by range-is-correct\n");
  EXPECT_EQ(right(29.0, 1100.0), "effect 1 right 0 add 0 by range-is-correct\n") << "under 30 m is left";
  EXPECT_EQ(right(30.0, 1100.0), "effect 1 right -30 add 0 by range-is-correct\n");
  EXPECT_EQ(right(100.0, 760.0), "effect 1 right -80 add 0 by range-is-correct\n") << "factor 0.8";
  EXPECT_EQ(right(200.0, 2000.0), "correct 1 right -400 add 0 by deviation-is-large\n");
}

TEST(Adjustment, RepeatsALostRoundThenShortensThenGivesUp) {
  const Spot lost{1, 1, false, 0.0, 0.0};
  EXPECT_EQ(decisionsFor({lost, lost, lost, lost}),
            "correct 1 right 0 add 0 by round-was-lost\n"
            "correct 1 right 0 add -400 by round-was-lost\n"
            "correct 1 right 0 add 0 by round-was-lost\n"
            "end 1 the rounds cannot be observed by rounds-stay-lost\n");
}

TEST(Adjustment, StopsWhenTheTargetIsDestroyedByAnAdjustingRound) {
  Observer observer;
  observer.mind().contact(Observer::uncertainTank(1, 2000.0));
  observer.one();
  observer.mind().mission(Observer::mission(1, 1, State::accepted));
  observer.nothing();
  Contact destroyed = Observer::uncertainTank(1, 2000.0);
  destroyed.condition = Contact::Condition::destroyed;
  observer.mind().contact(destroyed);
  observer.mind().spot({1, 1, true, 0.0, 10.0});
  EXPECT_EQ(Observer::told(observer.one()), "end 1 destroyed");
}

TEST(Adjustment, GivesUpAfterFifteenRounds) {
  Observer observer;
  observer.mind().contact(Observer::uncertainTank(1, 2000.0));
  observer.one();
  MissionFact mission = Observer::mission(1, 1, State::accepted);
  observer.mind().mission(mission);
  observer.nothing();
  mission.rounds = 16;
  observer.mind().mission(mission);
  observer.mind().spot({1, 16, true, 0.0, 300.0});
  EXPECT_EQ(Observer::told(observer.one()), "end 1 not adjusted after 16 rounds");
}

}  // namespace
}  // namespace npsee::observer
