// The acceptance scenarios of fire missions, seen from outside: only the command line and its log. Figures are those of a constant-drag
// fit of the 155 mm shell with charge 3W; 2 % are allowed.

#include "tests/scenario/mission_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace npsee {
namespace {

using test::acceptance;
using test::missionRun;
using Json = nlohmann::json;

testing::AssertionResult about(double value, double wanted, double share = 0.02) {
  if (std::fabs(value - wanted) <= share * std::fabs(wanted)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << value << " is not within " << 100 * share << " % of " << wanted;
}

// --- A: a ridge between guns and target --------------------------------------------------------------------------------------

TEST(AcceptanceA, TheLowTrajectoryIsRefusedAsMaskedAndTheHighOneIsFired) {
  const auto run = missionRun(acceptance("a_ridge"), {"--expect"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto refused = run.of("refuse");
  ASSERT_FALSE(refused.empty()) << run.out;
  EXPECT_EQ(refused[0].at("reason"), "masked");
  EXPECT_EQ(refused[0].at("trajectory"), "low");
  EXPECT_TRUE(about(refused[0].at("qe_mil"), 349));
  EXPECT_FALSE(refused[0].at("text").get<std::string>().empty());

  const auto solutions = run.of("solution");
  ASSERT_FALSE(solutions.empty());
  EXPECT_EQ(solutions[0].at("trajectory"), "high");
  EXPECT_EQ(solutions[0].at("charge"), "3W");
  EXPECT_TRUE(about(solutions[0].at("qe_mil"), 1218));
  EXPECT_TRUE(about(solutions[0].at("tof_s"), 53));
  EXPECT_FALSE(solutions[0].at("doubt").empty()) << "the yaw of repose at the summit lies beyond the model's validity";
  const auto bursts = run.of("detonation");
  ASSERT_FALSE(bursts.empty());
  EXPECT_TRUE(about(bursts[0].at("position")[0].get<double>() - 20400.0, 5000));
  EXPECT_LE(bursts[0].at("miss_m").get<double>(), 60.0);
}

TEST(AcceptanceA, TheLowTrajectoryForcedLandsOnTheRidge) {
  const auto run = missionRun(acceptance("a_ridge"), {"--set", "fdc.trajectory=low", "--until", "60"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto solutions = run.of("solution");
  ASSERT_FALSE(solutions.empty()) << run.out;
  EXPECT_EQ(solutions[0].at("trajectory"), "low");
  EXPECT_EQ(solutions[0].at("masked"), true);
  EXPECT_TRUE(about(solutions[0].at("qe_mil"), 349));
  const auto bursts = run.of("detonation");
  ASSERT_FALSE(bursts.empty());
  EXPECT_TRUE(about(bursts[0].at("position")[0].get<double>() - 20400.0, 4536));
}

TEST(AcceptanceA, ACrestOf140MetresLetsTheLowTrajectoryPass) {
  const auto run = missionRun(acceptance("a_ridge"), {"--set", "world.terrain.params.crest_height=140"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  ASSERT_FALSE(run.of("solution").empty()) << run.out;
  for (const Json& solution : run.of("solution")) EXPECT_EQ(solution.at("trajectory"), "low");
  ASSERT_FALSE(run.of("detonation").empty());
  EXPECT_LE(run.of("detonation")[0].at("miss_m").get<double>(), 60.0);
}

TEST(AcceptanceA, MaskingBeginsBetween146And150Metres) {
  const auto first = [](const std::string& crest) {
    const auto run = missionRun(acceptance("a_ridge"), {"--set", "world.terrain.params.crest_height=" + crest, "--until", "10"});
    return run.of("solution").empty() ? std::string("none") : run.of("solution")[0].at("trajectory").get<std::string>();
  };
  EXPECT_EQ(first("143"), "low");
  EXPECT_EQ(first("153"), "high");
}

// --- B: the thesis's default files ---------------------------------------------------------------------------------------------

TEST(AcceptanceB, DestroysTheTankInTheFirstVolleyForEverySeed) {
  for (const char* seed : {"1", "2", "3", "1993", "123456789", "9007199254740991"}) {
    const auto run = missionRun(acceptance("b_default"), {"--seed", seed, "--expect"});
    EXPECT_EQ(run.exit_code, 0) << seed << ": " << run.err;
    std::set<std::string> guns;
    for (const Json& shot : run.of("fire")) EXPECT_TRUE(guns.insert(shot.at("gun")).second) << "no gun fires twice";
    ASSERT_EQ(run.of("destroyed").size(), 1u);
    EXPECT_EQ(run.of("destroyed")[0].at("target"), "t72-1");
  }
}

TEST(AcceptanceB, Gun1ReportsOutOfRange) {
  const auto run = missionRun(acceptance("b_default"));
  const auto refused = run.of("refuse");
  ASSERT_EQ(refused.size(), 1u) << run.out;
  EXPECT_EQ(refused[0].at("gun"), "gun1");
  EXPECT_EQ(refused[0].at("reason"), "out_of_range");
}

// --- C: a crossing target ------------------------------------------------------------------------------------------------------

TEST(AcceptanceC, WithLeadTheFirstVolleyDestroys) {
  const auto run = missionRun(acceptance("c_crossing"), {"--expect"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(AcceptanceC, WithoutLeadTenVolleysDoNot) {
  const auto run = missionRun(acceptance("c_crossing"), {"--set", "fdc.lead=false", "--set", "fdc.absolute_relay=true"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_GE(run.of("detonation").size(), 40u) << "ten volleys of four guns";
  EXPECT_TRUE(run.of("destroyed").empty());
}

// --- E: danger close -----------------------------------------------------------------------------------------------------------

TEST(AcceptanceE, NoMissionNamesTheFriendAndCorrectionsCreep) {
  for (const char* seed : {"1", "2", "3", "4", "5"}) {
    const auto run = missionRun(acceptance("e_danger_close"), {"--seed", seed, "--expect"});
    EXPECT_EQ(run.exit_code, 0) << seed << ": " << run.err;
    ASSERT_FALSE(run.of("danger_close").empty()) << run.out;
    EXPECT_LE(run.of("danger_close")[0].at("distance_m").get<double>(), 600.0);
    ASSERT_FALSE(run.of("correction").empty());
    for (const Json& correction : run.of("correction"))
      EXPECT_LE(std::hypot(correction.at("right_m").get<double>(), correction.at("add_m").get<double>()), 100.5) << correction;
    for (const Json& event : run.events) {
      if (event.at("ev") == "call" || event.at("ev") == "fire" || event.at("ev") == "solution") {
        EXPECT_NE(event.value("target", ""), "friend") << event;
      }
    }
  }
}

// --- F: programmed for stupidity -----------------------------------------------------------------------------------------------

TEST(AcceptanceF, TheObserverEngagesHisOwnVehicleTypeWithAWarning) {
  const auto run = missionRun(acceptance("f_own_side"), {"--expect"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto warnings = run.of("warning");
  EXPECT_TRUE(std::ranges::any_of(warnings, [](const Json& warning) { return warning.at("text").get<std::string>().find("own") != std::string::npos; })) << run.out;
  EXPECT_FALSE(run.of("fire").empty());
}

// --- G: a ridge between two samples ----------------------------------------------------------------------------------------------

TEST(AcceptanceG, TheExactTestSeesANarrowRidge) {
  const auto run = missionRun(acceptance("g_narrow_ridge"), {"--expect"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(run.of("contact").empty());
}

TEST(AcceptanceG, TheHundredSamplesOf1993DoNot) {
  const auto run = missionRun(acceptance("g_narrow_ridge"), {"--set", "fdc.sampled_visibility=true"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_FALSE(run.of("contact").empty());
}

/// Observers at seeded places west of the ridge, each with two targets straight east of him beyond it; all of it in one mission.
class ManyLinesOverTheRidge {
 public:
  explicit ManyLinesOverTheRidge(double eye_height_m) {
    std::mt19937 random(1993);
    const auto between = [&](double low, double high) { return low + (high - low) * static_cast<double>(random()) / 4294967296.0; };
    for (int i = 0; i < kLines / kTargets; ++i) {
      // So far from the ridge, where a sample falls differs for his two lines as if by chance.
      const double z = 1000.0 + 450.0 * i, before = between(1000.0, 2000.0);
      const std::string id = std::to_string(i);
      mission_["observers"].push_back({{"id", "fo" + id}, {"pos", {25000.0 - before, z}}, {"eye_height", eye_height_m}, {"missions", Json::array({{{"action", "destroy"}, {"type", 51}}})}});
      for (int k = 0; k < kTargets; ++k) {
        const double after = between(300.0, 1900.0), crossing = eye_height_m + (kTop_m - eye_height_m) * before / (before + after);
        mission_["vehicles"].push_back({{"id", "t" + id + "-" + std::to_string(k)}, {"type", 51}, {"pos", {25000.0 + after, z}}});
        // A sample meets the ridge by its breadth at the ray's height over the distance of the samples.
        const double apart = (before + after) / std::ceil((before + after) / 40.0);
        expected_ += 1.0 - 20.0 * (1.0 - crossing / 40.0) / apart;
      }
    }
  }
  static constexpr int kLines = 200, kTargets = 2;
  /// Lines that slip through, by the formula.
  double expected() const { return expected_; }
  /// Lines along which the tool reports a contact.
  int seen(bool by_samples) {
    mission_["fdc"]["sampled_visibility"] = by_samples;
    const test::TemporaryFolder folder;
    const std::string file = folder / "lines.mission.json";
    test::spill(file, mission_.dump());
    const auto run = missionRun(file);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    int count = 0;
    for (const Json& contact : run.of("contact")) {
      const std::string target = contact.at("target"), observer = contact.at("observer");
      count += target.starts_with("t" + observer.substr(2) + "-") ? 1 : 0;
    }
    return count;
  }

 private:
  static constexpr double kTop_m = 2.2;  // of a T-72
  double expected_ = 0.0;
  Json mission_ = Json::parse(R"({ "npsee_mission": 1, "duration": 0.05, "vehicles": [], "observers": [],
    "world": { "terrain": { "kind": "function", "expr": "ridge", "params": { "crest_x": 25000, "crest_height": 40, "foot_before": 10, "foot_after": 10 } } } })");
};

TEST(AcceptanceG, FromTwoHundredPlacesTheExactTestNeverAndTheSampledOneUsuallySeesThrough) {
  // Eyes at 2.5 m look through the ridge near its foot, about 19 of 40 m broad: a little more than half of the lines slip through. From
  // posts of 30 m they cross it higher, where it is narrower: about three in four. Four standard deviations of a count are allowed.
  for (const double eye_height_m : {2.5, 30.0}) {
    ManyLinesOverTheRidge lines(eye_height_m);
    const double share = lines.expected() / ManyLinesOverTheRidge::kLines;
    EXPECT_GT(share, 0.5);
    EXPECT_EQ(lines.seen(false), 0);
    EXPECT_NEAR(lines.seen(true), lines.expected(), 4.0 * std::sqrt(share * (1.0 - share) * ManyLinesOverTheRidge::kLines)) << eye_height_m << " m";
  }
}

// --- H: fog ------------------------------------------------------------------------------------------------------------------------

TEST(AcceptanceH, InFogOnlyTheNearTargetIsSeen) {
  const auto run = missionRun(acceptance("h_fog"), {"--expect"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto clear = missionRun(acceptance("h_fog"), {"--set", "world.weather.visibility=20km"});
  EXPECT_EQ(clear.of("contact").size(), 2u);
}

// --- I: broken rules ---------------------------------------------------------------------------------------------------------------

TEST(AcceptanceI, BrokenRulesStopEverythingWithFileAndLine) {
  const auto run = missionRun(acceptance("i_broken_rules"));
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("/broken.clp:"), std::string::npos) << run.err;
}

// --- J: determinism ------------------------------------------------------------------------------------------------------------------

TEST(AcceptanceJ, TheSameSeedGivesTheSameLogAndAnotherAnother) {
  const auto first = missionRun(acceptance("d_adjust")), again = missionRun(acceptance("d_adjust"));
  const auto other = missionRun(acceptance("d_adjust"), {"--seed", "7"});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.out, again.out);
  EXPECT_FALSE(first.hash().empty());
  EXPECT_EQ(first.hash(), again.hash());
  EXPECT_NE(first.hash(), other.hash());
}

// --- shipped missions ------------------------------------------------------------------------------------------------------------------

class ShippedMission : public testing::TestWithParam<const char*> {};

TEST_P(ShippedMission, MeetsItsOwnExpectations) {
  const auto run = missionRun(std::string(NPSEE_SOURCE_DIR) + "/assets/missions/" + GetParam() + ".mission.json", {"--expect"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  ASSERT_FALSE(run.events.empty());
  EXPECT_EQ(run.events.back().at("ev"), "end");
}

INSTANTIATE_TEST_SUITE_P(Missions, ShippedMission,
                         testing::Values("thesis_default", "ridge_high_angle", "ridge_low", "moving_column", "danger_close", "foggy_night", "hills_patrol", "illumination_night"),
                         [](const auto& mission) { return std::string(mission.param); });

}  // namespace
}  // namespace npsee
