#include "tests/observer/fire_direction_support.h"
#include "tests/support/process.h"

#include <nlohmann/json.hpp>

namespace npsee::observer {
namespace {

using namespace test;

TEST(FireDirection, HighAngleIsTakenWhereTheRidgeMasksTheLowTrajectory) {
  const Terrain t = ridge(200.0);
  const FireSolution s = centre(battery(), t).solve(request(t, 5000.0));
  ASSERT_EQ(s.refusal, Refusal::none) << s.reason;
  EXPECT_TRUE(s.high);
  EXPECT_FALSE(s.masked);
  EXPECT_NEAR(s.elevation_mil(), 1218.0, 0.02 * 1218.0);
  EXPECT_NEAR(s.time_of_flight_s, 53.0, 0.02 * 53.0);
  EXPECT_LT(level(s.impact_m, s.aim_m), 0.5);
  EXPECT_NE(s.doubts & (doubt_elevation | doubt_yaw), 0u) << "so steep a shot is beyond the model's validity";
  ASSERT_EQ(s.rejected.size(), 1u);
  EXPECT_FALSE(s.rejected[0].high);
  EXPECT_EQ(s.rejected[0].refusal, Refusal::masked);
  EXPECT_NEAR(s.rejected[0].elevation_rad, mil(349.0), 0.02 * mil(349.0));
  EXPECT_NE(s.rejected[0].reason.find("short of the target at 5000 m: the ground is in its way."), std::string::npos) << s.rejected[0].reason;
}

TEST(FireDirection, LowAngleIsTakenOverALowerRidge) {
  for (const auto& [crest, high] : {std::pair{140.0, false}, {144.0, false}, {150.0, true}, {160.0, true}}) {
    const Terrain t = ridge(crest);
    const FireSolution s = centre(battery(), t).solve(request(t, 5000.0));
    ASSERT_EQ(s.refusal, Refusal::none) << s.reason;
    EXPECT_EQ(s.high, high) << crest;
    EXPECT_LT(level(s.impact_m, s.aim_m), 0.5) << crest;
  }
}

TEST(FireDirection, EvenATipOfTheCrestInTheWayMasks) {
  // Where the unhindered shell passes over the crest line.
  const Terrain plain = level();
  const FireDirection fdc = centre(battery(), plain);
  FireRequest r = request(plain, 5000.0);
  const FlightPath path = fdc.fly(fdc.solve(r), 0.0, 0.0);
  double before = 0.0, after = path.flight().time_of_flight_s;
  for (int i = 0; i < 60; ++i) (path.inWorld(0.5 * (before + after)).position_m.x < 25000.0 ? before : after) = 0.5 * (before + after);
  const double passes_m = path.inWorld(before).position_m.y;
  EXPECT_NEAR(passes_m, 148.0, 0.02 * 148.0) << "masking begins between 146 and 150 m";
  for (const double more : {-0.05, 0.05}) {
    const Terrain t = ridge(passes_m + more);
    EXPECT_EQ(centre(battery(), t).solve(request(t, 5000.0)).high, more > 0.0) << more;
  }
}

TEST(FireDirection, AForcedLowTrajectoryIsFlownIntoTheRidgeAndSaysSo) {
  const Terrain t = ridge(200.0);
  FireRequest r = request(t, 5000.0);
  r.trajectory = TrajectoryChoice::low;
  const FireDirection fdc = centre(battery(), t);
  const FireSolution s = fdc.solve(r);
  ASSERT_EQ(s.refusal, Refusal::none) << s.reason;
  EXPECT_FALSE(s.high);
  EXPECT_TRUE(s.masked);
  EXPECT_NEAR(level(s.impact_m, r.muzzle_m), 4536.0, 0.02 * 4536.0);
  EXPECT_LT(level(impactOf(fdc.fly(s, 0.0, 0.0)), s.impact_m), 1e-6) << "the flown shell is the checked one";
}

TEST(FireDirection, GivesTheElevationsThatTheAimCommandGives) {
  const Terrain t = slope(0.01);
  const FireRequest r = request(t, 3000.0, -4000.0);
  const double height = r.target_m.y - r.muzzle_m.y;
  const auto out = npsee::test::npseeRun({"aim", "--charge", "3W", "--range", "5000", "--height-of-target", shortest(height), "--altitude", shortest(r.muzzle_m.y + 1000.0), "--json"});
  ASSERT_EQ(out.exit_code, 0) << out.err;
  const auto json = nlohmann::json::parse(out.out);
  for (const auto choice : {TrajectoryChoice::low, TrajectoryChoice::high}) {
    FireRequest forced = r;
    forced.trajectory = choice;
    const FireSolution s = centre(battery(), t).solve(forced);
    ASSERT_EQ(s.refusal, Refusal::none) << s.reason;
    const auto& solution = json["solutions"][choice == TrajectoryChoice::low ? 0 : 1];
    EXPECT_NEAR(s.shot.elevation_rad, solution["elevation_rad"].get<double>(), 1e-6);
    EXPECT_NEAR(s.time_of_flight_s, solution["time_of_flight_s"].get<double>(), 1e-3);
    // The line to the target runs 3 east to 4 north.
    EXPECT_NEAR(s.shot.azimuth_rad, std::atan2(3.0, 4.0) + solution["azimuth_correction_rad"].get<double>(), 1e-6);
  }
}

TEST(FireDirection, HitsTheRealGroundInAnyDirectionOnSlopesAndWithWind) {
  Weather weather;
  weather.wind_mps = {12.0, 0.0, -7.0};
  for (const double rise : {-0.02, 0.0, 0.03}) {
    const Terrain t = slope(rise);
    const FireDirection calm = centre(battery(), t), windy = centre(battery(), t, weather);
    for (const auto& [east, south] : {std::pair{4000.0, 1000.0}, {-3000.0, 2500.0}, {0.0, -5000.0}, {100.0, 5900.0}})
      for (const auto choice : {TrajectoryChoice::low, TrajectoryChoice::high}) {
        FireRequest r = request(t, east, south);
        r.trajectory = choice;
        const FireSolution still = calm.solve(r), blown = windy.solve(r);
        for (const auto& [fdc, s] : {std::pair{&calm, &still}, {&windy, &blown}}) {
          ASSERT_EQ(s->refusal, Refusal::none) << s->reason;
          const Vec3 impact = impactOf(fdc->fly(*s, 0.0, 0.0));
          EXPECT_LT(level(impact, r.target_m), 0.5) << rise << ' ' << east;
          EXPECT_NEAR(impact.y, t.surface(impact.x, impact.z), 1e-3);
        }
        EXPECT_NE(still.shot.azimuth_rad, blown.shot.azimuth_rad);
      }
  }
}

TEST(FireDirection, TheLeadHitsACrossingTargetAndWithoutItTheShellFallsBehind) {
  const Terrain t = level();
  FdcSetup without;
  without.lead = false;
  for (const auto choice : {TrajectoryChoice::low, TrajectoryChoice::high}) {
    FireRequest r = request(t, 5000.0);
    r.trajectory = choice;
    r.target_velocity_mps = {0.0, 0.0, 10.0};
    r.delay_s = 5.0;
    const FireDirection leading = centre(battery(), t), legacy = centre(battery(), t, {}, without);
    const FireSolution led = leading.solve(r), behind = legacy.solve(r);
    ASSERT_EQ(led.refusal, Refusal::none) << led.reason;
    ASSERT_EQ(behind.refusal, Refusal::none) << behind.reason;
    const auto where = [&](const FireSolution& s) { return r.target_m + (r.delay_s + s.time_of_flight_s) * r.target_velocity_mps; };
    EXPECT_LT(level(led.impact_m, where(led)), 1.0);
    EXPECT_NEAR(level(behind.impact_m, where(behind)), 10.0 * (5.0 + behind.time_of_flight_s), 1.0);
  }
}

TEST(FireDirection, ATargetThatDrivesIntoRangeDuringTheFlightIsLed) {
  const Terrain t = level();
  const FireDirection fdc = centre(battery(), t);
  FireRequest r = request(t, fdc.maxRange() + 200.0);
  EXPECT_EQ(fdc.solve(r).refusal, Refusal::out_of_range);
  r.trajectory = TrajectoryChoice::low;
  r.target_velocity_mps = {-15.0, 0.0, 0.0};
  const FireSolution s = fdc.solve(r);
  ASSERT_EQ(s.refusal, Refusal::none) << s.reason;
  EXPECT_LT(level(s.impact_m, r.target_m + s.time_of_flight_s * r.target_velocity_mps), 1.0);
}

TEST(FireDirection, RefusesWithAReasonThatNamesTheFigures) {
  const Terrain t = level();
  const FireDirection fdc = centre(battery(), t);
  const FireSolution far = fdc.solve(request(t, 12728.0));
  EXPECT_EQ(far.refusal, Refusal::out_of_range);
  EXPECT_NE(far.reason.find("12728 m away"), std::string::npos) << far.reason;
  EXPECT_NE(far.reason.find("greatest range"), std::string::npos) << far.reason;
  EXPECT_NE(far.reason.find(shortest(std::floor(fdc.maxRange() + 0.5)) + " m"), std::string::npos) << far.reason;
  EXPECT_NE(far.reason.find("Move the guns nearer"), std::string::npos) << far.reason;

  const FireSolution close = fdc.solve(request(t, 120.0));
  EXPECT_EQ(close.refusal, Refusal::too_close);
  EXPECT_NE(close.reason.find("120 m from the gun; nearer than 150 m"), std::string::npos) << close.reason;

  const Terrain drowned = terrain({}, 5.0);
  const FireSolution sea = centre(battery(), drowned).solve(request(drowned, 5000.0));
  EXPECT_EQ(sea.refusal, Refusal::in_sea);
  EXPECT_NE(sea.reason.find("stands in the sea. Place it on land."), std::string::npos) << sea.reason;

  FireRequest broken = request(t, 5000.0);
  broken.target_m.x = std::nan("");
  EXPECT_NE(fdc.solve(broken).refusal, Refusal::none);
}

TEST(FireDirection, TheGunsLimitOfElevationIsKeptAndNamed) {
  const Terrain t = ridge(200.0);
  BatterySetup flat_shooter = battery();
  flat_shooter.max_elevation_rad = mil(1100.0);
  const FireSolution s = centre(flat_shooter, t).solve(request(t, 5000.0));
  EXPECT_EQ(s.refusal, Refusal::masked) << "what stands in the way is the reason, the other branch the limit";
  ASSERT_EQ(s.rejected.size(), 2u);
  EXPECT_EQ(s.rejected[1].refusal, Refusal::elevation);
  EXPECT_NE(s.reason.find("above the gun's limit of 1100 mil"), std::string::npos) << s.reason;

  FireRequest high = request(t, 5000.0);
  high.trajectory = TrajectoryChoice::high;
  EXPECT_EQ(centre(flat_shooter, t).solve(high).refusal, Refusal::elevation);
}

TEST(FireDirection, TheWeakestChargeThatReachesIsTaken) {
  const Terrain t = level();
  BatterySetup b = battery();
  b.charges = {"7W", "3W", "5W"};
  const FireDirection fdc = centre(b, t);
  ASSERT_EQ(fdc.charges().size(), 3u);
  for (const auto& [range, charge] : {std::pair{5000.0, "3W"}, {9000.0, "5W"}, {12000.0, "7W"}}) {
    const FireSolution s = fdc.solve(request(t, range));
    ASSERT_EQ(s.refusal, Refusal::none) << s.reason;
    EXPECT_EQ(fdc.charges()[static_cast<std::size_t>(s.charge)].name, charge);
    EXPECT_LT(level(s.impact_m, s.aim_m), 0.5);
  }
}

TEST(FireDirection, ATableGunIsLaidForStepsOfTheThesis) {
  const Terrain t = level();
  FdcSetup table;
  table.solver = ElevationSolver::table;
  const FireRequest r = request(t, 4000.0, 2000.0);
  const FireSolution s = centre(battery(), t, {}, table).solve(r);
  ASSERT_EQ(s.refusal, Refusal::none) << s.reason;
  EXPECT_NEAR(level(s.impact_m, r.muzzle_m), 4500.0, 0.5) << "4472 m lies nearest to 4500";
  EXPECT_NEAR((s.impact_m.z - r.muzzle_m.z) / (s.impact_m.x - r.muzzle_m.x), 0.5, 1e-3) << "in the right direction";
}

TEST(FireDirection, IlluminationBurstsOverTheTarget) {
  const Terrain t = slope(0.02);
  FireRequest r = request(t, 4000.0);
  r.illumination = true;
  r.burst_height_m = 300.0;
  const FireDirection fdc = centre(battery(), t);
  const FireSolution s = fdc.solve(r);
  ASSERT_EQ(s.refusal, Refusal::none) << s.reason;
  const Vec3 burst = fdc.fly(s, 0.0, 0.0).inWorld(s.time_of_flight_s).position_m;
  EXPECT_LT(level(burst, r.target_m), 0.5);
  EXPECT_NEAR(burst.y, r.target_m.y + 300.0, 0.5);
  EXPECT_LT(length(burst - s.impact_m), 0.01);
}

TEST(FireDirection, WhatWasAskedBeforeChangesNoBitOfAnAnswer) {
  const Terrain t = slope(0.02);
  Weather weather;
  weather.wind_mps = {5.0, 0.0, 3.0};
  const FireDirection fresh = centre(battery(), t, weather), used = centre(battery(), t, weather);
  for (int i = 0; i < 100; ++i) used.solve(request(t, 3000.0 + 30.0 * i, 10.0 * i));
  const FireSolution a = fresh.solve(request(t, 4321.0)), b = used.solve(request(t, 4321.0)), c = used.solve(request(t, 4321.0));
  EXPECT_EQ(a.shot, b.shot);
  EXPECT_EQ(a.shot, c.shot);
  EXPECT_EQ(a.impact_m, b.impact_m);
}

TEST(FireDirection, DispersionDisplacesTheBurstByExactlyTheDraw) {
  BatterySetup b = battery();
  b.pe_range_m = 40.0;
  b.pe_deflection_m = 10.0;
  const Terrain t = level();
  Weather weather;
  weather.wind_mps = {3.0, 0.0, 8.0};
  const FireDirection fdc = centre(b, t, weather);
  for (const double range : {1500.0, 5000.0, 0.999 * fdc.maxRange()})
    for (const auto choice : {TrajectoryChoice::low, TrajectoryChoice::high}) {
      FireRequest r = request(t, range);
      r.trajectory = choice;
      const FireSolution s = fdc.solve(r);
      if (s.refusal == Refusal::elevation) continue;
      ASSERT_EQ(s.refusal, Refusal::none) << s.reason;
      for (const auto& [along, across] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {-2.0, 0.5}, {3.0, -3.0}}) {
        const FlightPath path = fdc.fly(s, along, across);
        const Vec3 off = impactOf(path) - s.impact_m;
        // The line of fire runs east: along is x, right of it is south.
        EXPECT_NEAR(off.x, along * 40.0 / 0.6744897501960817, 0.1) << range;
        EXPECT_NEAR(off.z, across * 10.0 / 0.6744897501960817, 0.1) << range;
        EXPECT_EQ(path.shot().elevation_rad, s.shot.elevation_rad) << "the tube stands as it was laid";
      }
    }
}

TEST(FireDirection, HalfOfTheShellsFallWithinTheProbableErrors) {
  BatterySetup b = battery();
  b.pe_range_m = 15.0;
  b.pe_deflection_m = 4.0;
  const Terrain t = slope(0.02);
  const FireDirection fdc = centre(b, t);
  const FireSolution s = fdc.solve(request(t, -5000.0));
  ASSERT_EQ(s.refusal, Refusal::none) << s.reason;
  constexpr int kShells = 2000;
  int along = 0, across = 0;
  for (std::uint32_t i = 0; i < kShells; ++i) {
    const double a = (static_cast<double>((i * 7919u) % kShells) + 0.5) / kShells, c = (static_cast<double>((i * 104729u + 17u) % kShells) + 0.5) / kShells;
    // Quantiles of the normal distribution by bisection of the error function: independent of the library's own.
    const auto normal = [](double p) {
      double low = -8.0, high = 8.0;
      for (int k = 0; k < 60; ++k) (0.5 * std::erfc(-0.5 * (low + high) / std::sqrt(2.0)) < p ? low : high) = 0.5 * (low + high);
      return low;
    };
    const Vec3 off = impactOf(fdc.fly(s, normal(a), normal(c))) - s.impact_m;
    along += std::fabs(off.x) < 15.0;
    across += std::fabs(off.z) < 4.0;
  }
  // The slope falls away to the west, so that the shells fly on a little further: a few per cent.
  EXPECT_NEAR(static_cast<double>(along) / kShells, 0.5, 0.05);
  EXPECT_NEAR(static_cast<double>(across) / kShells, 0.5, 0.01);
}

TEST(FireDirection, ALayingErrorTurnsTheShot) {
  const Terrain t = level();
  const FireDirection fdc = centre(battery(), t);
  const FireSolution s = fdc.solve(request(t, 5000.0));
  const Vec3 off = impactOf(fdc.fly(s, 0.0, 0.0, mil(100.0))) - s.impact_m;
  EXPECT_NEAR(off.z, 5000.0 * std::sin(mil(100.0)), 1.0);
  EXPECT_NEAR(off.x, 5000.0 * (std::cos(mil(100.0)) - 1.0), 1.0);
}

}  // namespace
}  // namespace npsee::observer
