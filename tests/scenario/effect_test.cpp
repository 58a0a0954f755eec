// What the observer makes of volleys and of rounds he cannot see, through the command line.

#include "tests/scenario/mission_run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace npsee {
namespace {

using test::acceptance;
using test::missionRun;

TEST(FireForEffect, VolleysThatAreSeenToBeOffAreCorrected) {
  for (const char* seed : {"1", "2", "3"}) {
    const auto run = missionRun(acceptance("d_adjust"), {"--set", "observers.fo1.method=fire_for_effect", "--seed", seed});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto bursts = run.of("detonation"), spots = run.of("spot"), corrections = run.of("correction");
    ASSERT_GE(bursts.size(), 5u);
    ASSERT_FALSE(spots.empty()) << "a volley is spotted";
    ASSERT_FALSE(corrections.empty());
    // Perfect sensing: what is left is what is not worth a correction, 50 m in range and 30 m in deviation.
    EXPECT_LE(corrections.back().at("aim_error_m").get<double>(), std::hypot(50.0, 30.0) + 20.0) << seed;
  }
}

TEST(FireForEffect, TheMiddleOfTheVolleyIsSpotted) {
  const std::vector<std::string> far_apart{"--set", R"(batteries.battery.guns=[{"id":"gun1","pos":[20000,25000]},{"id":"gun2","pos":[20100,25000]}])", "--set", "observers.fo1.method=fire_for_effect",
                                           "--set", "batteries.battery.pe_range=0", "--set", "batteries.battery.pe_deflection=0", "--set", "fdc.lay_error=1", "--until", "60"};
  const auto run = missionRun(acceptance("d_adjust"), far_apart);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto bursts = run.of("detonation"), spots = run.of("spot");
  ASSERT_GE(bursts.size(), 2u);
  ASSERT_FALSE(spots.empty());
  // The observer looks north at the target (25000, 25000) from (25000, 27000): north is beyond it.
  const double beyond = 25000.0 - (bursts[0].at("position")[2].get<double>() + bursts[1].at("position")[2].get<double>()) / 2.0;
  EXPECT_NEAR(spots[0].at("range_m").get<double>(), beyond, 0.01);
}

TEST(Spotting, RoundsBehindTheRidgeAreLost) {
  const auto run = missionRun(acceptance("a_ridge"), {"--set", "fdc.trajectory=low", "--set", "observers.fo1.method=adjust_fire", "--until", "60"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  ASSERT_FALSE(run.of("spot").empty()) << run.out;
  EXPECT_EQ(run.of("spot")[0].at("observed"), false);
  EXPECT_FALSE(run.of("spot")[0].contains("range_m"));
}

TEST(Solutions, AGunTellsOnceWhatItTriedInVain) {
  const auto run = missionRun(acceptance("a_ridge"), {"--set", "observers.fo1.method=adjust_fire", "--set", "observers.fo1.sensing.location_cep=200"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_GE(run.of("solution").size(), 2u);
  EXPECT_EQ(run.of("refuse").size(), 1u);
  for (const auto& solution : run.of("solution")) EXPECT_FALSE(solution.at("rejected").empty());
}

TEST(AimError, IsTheSameForATargetThatDrives) {
  const auto run = missionRun(acceptance("c_crossing"));
  ASSERT_FALSE(run.of("end_of_mission").empty()) << run.out;
  EXPECT_EQ(run.of("end_of_mission")[0].at("aim_error_m"), 0) << "lead is not an error of the aim";
}

}  // namespace
}  // namespace npsee
