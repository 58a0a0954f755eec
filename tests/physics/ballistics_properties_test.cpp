// What must hold of any flight: conservation, symmetry, events, limits, equal bits.

#include "tests/physics/ballistics_support.h"

#include "sim/ballistics/setup.h"

#include <npsee/firing_table.h>

#include <cstring>
#include <random>

namespace npsee {
namespace {

using test::flying;
using test::mil;
using test::shot;

double energy(const FlightPath::State& s) { return 0.5 * dot(s.velocity_mps, s.velocity_mps) + kStandardGravity_mps2 * s.position_m.y; }

Shot charge7(double elevation_mil) { return shot(568.0, mil(elevation_mil)); }

TEST(Ballistics, EnergyIsKeptInAVacuumAndOnlyFallsInStillAir) {
  for (const FlightModel model : {FlightModel::vacuum, FlightModel::point_mass, FlightModel::modified_point_mass}) {
    const FlightPath path = flying(test::shipped("m107"), {}, model).path(charge7(700));
    double before = energy(path.at(0.0));
    const double first = before;
    for (double t = 0.5; t < path.flight().time_of_flight_s; t += 0.5) {
      const double now = energy(path.at(t));
      // Lift and Magnus force are normal to the velocity and do no work.
      EXPECT_TRUE(model == FlightModel::vacuum ? std::fabs(now - first) < 1e-6 * first : now < before) << t;
      before = now;
    }
  }
}

TEST(Ballistics, ATailWindLengthensTheRangeAndAHeadWindShortensIt) {
  const Ballistics model = flying(test::shipped("m107"));
  Shot s = charge7(533);
  const double still = model.fly(s).range_m;
  s.wind_mps = {15, 0, 0};
  EXPECT_GT(model.fly(s).range_m, still + 100.0);
  s.wind_mps = {-15, 0, 0};
  EXPECT_LT(model.fly(s).range_m, still - 100.0);
}

TEST(Ballistics, AWindFromTheLeftCarriesTheShellToTheRight) {
  const Ballistics model = flying(test::shipped("m107"));
  Shot s = charge7(533);
  const double still = model.fly(s).drift_m;
  s.wind_mps = {0, 0, 10};
  EXPECT_GT(model.fly(s).drift_m, still + 20.0);
}

TEST(Ballistics, FlyingWithTheWindIsFlyingInStillAirSeenFromAMovingFrame) {
  // Constant air, drag only: the path in the air's frame does not know the wind.
  const Projectile p = test::sphere(43.0, 0.155, 0.3);
  const Ballistics model = flying(p, test::constantAir());
  Shot windy = shot(300.0, mil(600));
  windy.wind_mps = {20.0, 0.0, -7.0};
  const FlightPath there = model.path(windy);
  const Vec3 u = there.at(0.0).velocity_mps - windy.wind_mps;
  Shot still = shot(length(u), std::atan2(u.y, std::hypot(u.x, u.z)));
  const double turn = std::atan2(u.z, u.x);
  const FlightPath here = model.path(still);
  for (const double t : {1.0, 5.0, 12.0, 20.0}) {
    const Vec3 a = there.at(t).position_m - t * windy.wind_mps, b = here.at(t).position_m;
    EXPECT_NEAR(a.x, b.x * std::cos(turn) - b.z * std::sin(turn), 0.01);
    EXPECT_NEAR(a.y, b.y, 0.01);
    EXPECT_NEAR(a.z, b.x * std::sin(turn) + b.z * std::cos(turn), 0.01);
  }
}

TEST(Ballistics, ReversingTheTwistMirrorsTheDrift) {
  Projectile p = test::shipped("m107");
  const Flight right = flying(p).fly(charge7(800));
  p.left_hand = true;
  const Flight left = flying(p).fly(charge7(800));
  EXPECT_GT(right.drift_m, 100.0);
  EXPECT_EQ(left.drift_m, -right.drift_m);
  EXPECT_EQ(left.range_m, right.range_m);
  EXPECT_EQ(left.spin_impact_radps, -right.spin_impact_radps);
}

TEST(Ballistics, TheSummitIsWhereTheShellNeitherRisesNorFalls) {
  for (const Integrator integrator : {Integrator::dormand_prince, Integrator::predictor_corrector, Integrator::rk4}) {
    Integration integration;
    integration.integrator = integrator;
    const FlightPath path = flying(test::shipped("m107"), {}, FlightModel::modified_point_mass, integration).path(charge7(600));
    const Flight& flight = path.flight();
    EXPECT_NEAR(path.at(flight.apex_time_s).velocity_mps.y, 0.0, 1e-6);
    EXPECT_NEAR(path.at(flight.apex_time_s).position_m.y, flight.max_ordinate_m, 1e-9);
    for (double t = 0.0; t < flight.time_of_flight_s; t += 0.37) EXPECT_LE(path.at(t).position_m.y, flight.max_ordinate_m + 1e-6);
  }
}

TEST(Ballistics, ThePathBeginsAtTheMuzzleAndEndsAtTheImpact) {
  const FlightPath path = flying(test::shipped("m107")).path(charge7(450));
  const Flight& flight = path.flight();
  EXPECT_EQ(length(path.at(-3.0).position_m), 0.0);
  EXPECT_NEAR(length(path.at(0.0).velocity_mps), 568.0, 1e-9);
  const auto end = path.at(flight.time_of_flight_s), after = path.at(1e9);
  EXPECT_NEAR(end.position_m.x, flight.range_m, 1e-6);
  EXPECT_NEAR(end.position_m.z, flight.drift_m, 1e-6);
  EXPECT_NEAR(end.position_m.y, 0.0, 1e-6);
  EXPECT_EQ(after.position_m, end.position_m);
  EXPECT_EQ(path.flight(), flying(test::shipped("m107")).fly(charge7(450)));
}

TEST(Ballistics, TheWorldSeesAnEastwardShotFlyEast) {
  Shot s = charge7(450);
  s.azimuth_rad = 0.5 * kPi;
  s.muzzle_m = {1000.0, 50.0, 2000.0};
  const FlightPath path = flying(test::shipped("m107")).path(s);
  const Vec3 end = path.inWorld(1e9).position_m;
  EXPECT_NEAR(end.x, 1000.0 + path.flight().range_m, 1e-6);
  EXPECT_NEAR(end.z, 2000.0 + path.flight().drift_m, 1e-6);  // right of east is south
  EXPECT_NEAR(end.y, 50.0, 1e-6);
  EXPECT_NEAR(length(flightFromWorld(worldFromFlight({1, 2, 3}, 0.7), 0.7) - Vec3{1, 2, 3}), 0.0, 1e-12);
}

TEST(Ballistics, ASmallerToleranceNeverWorsensTheImpact) {
  const Projectile p = test::shipped("m107");
  for (const double elevation : {266.67, 533.33, 800.0}) {
    Integration integration;
    integration.tolerance_m = 1e-9;
    const Flight exact = flying(p, {}, FlightModel::modified_point_mass, integration).fly(charge7(elevation));
    // A single impact may be right by luck; the bound at each tolerance must shrink with it.
    const std::pair<double, double> bounds[] = {{1e-2, 1.5}, {1e-3, 0.15}, {3e-4, 0.05}, {1e-5, 0.005}, {1e-7, 2e-4}};
    for (const auto& [tolerance, bound] : bounds)
      for (const double half : {1.0, 0.5}) {
        integration.tolerance_m = tolerance * half;
        const Flight flight = flying(p, {}, FlightModel::modified_point_mass, integration).fly(charge7(elevation));
        EXPECT_LT(std::hypot(flight.range_m - exact.range_m, flight.drift_m - exact.drift_m), bound) << elevation << " mil, tolerance " << tolerance * half;
      }
  }
}

TEST(Ballistics, FixedStepsConvergeWithTheirOrder) {
  // A smooth case, so that the order shows: constant drag.
  const Projectile p = test::sphere(43.0913, 0.155, 0.3);
  const auto range = [&](Integrator integrator, double step) {
    Integration integration;
    integration.integrator = integrator;
    integration.step_s = step;
    integration.tolerance_m = 1e-9;
    return flying(p, test::constantAir(), FlightModel::point_mass, integration).fly(charge7(533.0)).range_m;
  };
  const double exact = range(Integrator::dormand_prince, 0.1);
  const auto error = [&](Integrator integrator, double step) { return std::fabs(range(integrator, step) - exact); };
  EXPECT_NEAR(error(Integrator::rk4, 0.4) / error(Integrator::rk4, 0.2), 16.0, 8.0);
  EXPECT_NEAR(error(Integrator::predictor_corrector, 0.2) / error(Integrator::predictor_corrector, 0.1), 4.0, 1.5);
  EXPECT_LT(error(Integrator::predictor_corrector, 0.1), 0.5);
  EXPECT_LT(error(Integrator::rk4, 0.1), 0.001);
}

TEST(Ballistics, AllIntegratorsAgreeOnTheFullModel) {
  const Projectile p = test::shipped("m107");
  const Flight adaptive = flying(p).fly(charge7(533.33));
  for (const auto& [integrator, bound] : {std::pair(Integrator::rk4, 0.05), std::pair(Integrator::predictor_corrector, 0.5)}) {
    Integration integration;
    integration.integrator = integrator;
    const Flight flight = flying(p, {}, FlightModel::modified_point_mass, integration).fly(charge7(533.33));
    EXPECT_NEAR(flight.range_m, adaptive.range_m, bound);
    EXPECT_NEAR(flight.drift_m, adaptive.drift_m, bound);
    EXPECT_NEAR(flight.spin_impact_radps, adaptive.spin_impact_radps, 0.1);
  }
}

TEST(Ballistics, TheSimplifiedModelIgnoresWindAndCoriolisAndHasTheClosedFormSpin) {
  Projectile p = test::shipped("m107");
  Conditions conditions;
  conditions.has_latitude = conditions.coriolis = true;
  conditions.latitude_rad = 0.6;
  Shot windy = charge7(533.33);
  windy.wind_mps = {12, 0, 8};
  const FlightModel simplified = FlightModel::simplified_modified_point_mass;
  EXPECT_EQ(flying(p, conditions, simplified).fly(windy).range_m, flying(p, {}, simplified).fly(charge7(533.33)).range_m);
  // Where rho and V hardly change, 3.15 is the exact solution; over a whole flight it is not.
  const Flight thesis = flying(p, {}, simplified).fly(charge7(20)), full = flying(p).fly(charge7(20));
  EXPECT_NEAR(thesis.spin_impact_radps, full.spin_impact_radps, 0.01 * full.spin_impact_radps);
  EXPECT_NEAR(thesis.range_m, full.range_m, 0.2);
  const Flight far = flying(p, {}, simplified).fly(charge7(800));
  EXPECT_LT(far.spin_impact_radps, far.spin_muzzle_radps);
  EXPECT_GT(far.spin_impact_radps, 0.0);
}

TEST(Ballistics, SpinDecaysWithTheDistanceFlownInConstantAir) {
  // dp/dt = rho S.. V p: p = p0 exp(pi rho d^4 Cspin s / (8 Ix)), s the length of the path through the air.
  Projectile p = test::sphere(43.0913, 0.155, 0.3);
  p.inertia_kgm2 = 0.1461;
  p.twist_cal = 20.0;
  p.curve(Coefficient::cspin) = CoefficientCurve::constant(-0.01);
  const FlightPath path = flying(p, test::constantAir()).path(charge7(533));
  double distance = 0.0;
  constexpr int kParts = 40000;
  const double h = path.flight().time_of_flight_s / kParts;
  for (int i = 0; i < kParts; ++i) distance += h * length(path.at((i + 0.5) * h).velocity_mps);
  const double d4 = 0.155 * 0.155 * 0.155 * 0.155;
  EXPECT_NEAR(path.flight().spin_impact_radps, kTwoPi * 568.0 / (20.0 * 0.155) * std::exp(-kPi * 1.225 * d4 * 0.01 * distance / (8.0 * 0.1461)), 1e-3);
}

/// The published way to the yaw of repose, by repeated substitution at one state; independent of the kernel's closed form.
Vec3 substitutedYaw(const Vec3& v, double p, double rho, double cd, double cla, double cma, double cmagf, int passes) {
  const double d = 0.155, m = 43.0913, ix = 0.1461, speed = length(v), k = kPi * rho / (8.0 * m);
  const Vec3 g{0, -kStandardGravity_mps2, 0};
  Vec3 ae, du = g - (k * d * d * cd * speed) * v;
  for (int i = 0; i < passes; ++i) {
    ae = (-8.0 * ix * p / (kPi * rho * d * d * d * cma * speed * speed * speed * speed)) * cross(v, du);
    du = g - (k * d * d * cd * speed) * v + (k * d * d * cla * speed * speed) * ae - (k * d * d * d * p * cmagf) * cross(ae, v);
  }
  return ae;
}

TEST(Ballistics, TheYawOfReposeIsTheFixedPointOfRepeatedSubstitution) {
  Projectile p = test::shipped("m107");
  const double cd = 0.3, cla = 1.7, cma = 3.6, cspin = 0.0, cmagf = -0.4;
  p.curve(Coefficient::cd0) = CoefficientCurve::constant(cd);
  p.curve(Coefficient::cda2) = {};
  p.curve(Coefficient::cla) = CoefficientCurve::constant(cla);
  p.curve(Coefficient::cma) = CoefficientCurve::constant(cma);
  p.curve(Coefficient::cspin) = CoefficientCurve::constant(cspin);
  p.curve(Coefficient::cmagf) = CoefficientCurve::constant(cmagf);
  const FlightPath path = flying(p, test::constantAir(0.9)).path(charge7(900));
  double greatest = 0.0;
  for (double t = 0.0; t < path.flight().time_of_flight_s; t += 0.05) {
    const auto s = path.at(t);
    greatest = std::max(greatest, length(substitutedYaw(s.velocity_mps, s.spin_radps, 0.9, cd, cla, cma, cmagf, 60)));
  }
  // The flight looks at its stages only, so it may miss the very top of the curve.
  EXPECT_NEAR(path.flight().yaw_max_rad, greatest, 0.03 * greatest);
  EXPECT_LE(path.flight().yaw_max_rad, greatest * 1.001);
}

TEST(Ballistics, BeyondItsValidityAResultIsFlaggedAndStaysFinite) {
  const Ballistics model = flying(test::shipped("m107"));
  EXPECT_TRUE(model.fly(shot(297, mil(1150))).valid());
  const Flight steep = model.fly(shot(297, mil(1200)));
  EXPECT_FALSE(steep.valid());
  EXPECT_TRUE(steep.doubts & doubt_elevation);
  const Flight steepest = model.fly(shot(297, mil(1590)));
  EXPECT_TRUE(steepest.doubts & doubt_yaw);
  EXPECT_LE(steepest.yaw_max_rad, kYawClamp_rad + 1e-12);
  EXPECT_EQ(steepest.end, FlightEnd::impact);
  const Flight fast = model.fly(shot(1500, mil(300)));
  EXPECT_TRUE(fast.doubts & doubt_mach);
  // Without yaw there is nothing to doubt in a vertical shot.
  EXPECT_TRUE(flying(test::shipped("m107"), {}, FlightModel::point_mass).fly(shot(297, mil(1600))).valid());
}

TEST(Ballistics, NoShotMakesANumberThatIsNone) {
  std::mt19937 random(12345);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (static_cast<double>(random()) / 4294967295.0); };
  for (int i = 0; i < 600; ++i) {
    Projectile p = test::shipped("m107");
    p.mass_kg = std::exp(uniform(-9, 9));
    p.diameter_m = std::exp(uniform(-7, 2));
    p.inertia_kgm2 = i % 5 == 0 ? 0.0 : std::exp(uniform(-20, 8));
    p.twist_cal = i % 7 == 0 ? 0.0 : uniform(0.1, 200);
    Conditions c;
    c.gravity = static_cast<GravityModel>(i % 3);
    c.has_latitude = c.coriolis = i % 2 == 0;
    c.latitude_rad = uniform(-1.5, 1.5);
    c.muzzle_altitude_m = uniform(-5000, 20000);
    c.target_height_m = uniform(-3000, 3000);
    if (i % 4 == 0) c.atmosphere = {false, uniform(0.0, 10.0), uniform(100, 1000)};
    Integration integration;
    integration.integrator = static_cast<Integrator>(i % 3);
    integration.step_limit = 3000;
    integration.time_limit_s = 300;
    Shot s = shot(std::exp(uniform(-4, 9.2)), uniform(-1.57, 1.57));
    s.wind_mps = {uniform(-200, 200), uniform(-50, 50), uniform(-200, 200)};
    s.factors = {uniform(0, 5), uniform(0, 5), uniform(-5, 5), uniform(0, 5)};
    s.azimuth_rad = uniform(-7, 7);
    const auto model = Ballistics::make(p, c, static_cast<FlightModel>(i % 4), integration);
    ASSERT_TRUE(model) << model.error().text();
    const FlightPath path = model->path(s);
    const Flight& f = path.flight();
    for (const double value : {f.range_m, f.drift_m, f.height_m, f.time_of_flight_s, f.max_ordinate_m, f.apex_time_s, f.apex_range_m, f.impact_speed_mps, f.angle_of_fall_rad, f.spin_impact_radps, f.yaw_max_rad})
      EXPECT_TRUE(std::isfinite(value)) << "case " << i;
    for (const double t : {0.0, 0.3, 3.0, 30.0, 1e9}) EXPECT_TRUE(std::isfinite(length(path.at(t).position_m))) << "case " << i;
  }
}

TEST(Ballistics, ImpossibleShotsAreRefusedAndSayWhy) {
  const Ballistics model = flying(test::shipped("m107"));
  const std::pair<Shot, const char*> wrong[] = {{shot(0.0, 0.5), "muzzle velocity"}, {shot(300, 1.6), "straight up"}, {shot(std::nan(""), 0.5), "muzzle velocity"}, {shot(300, INFINITY), "elevation"}, {shot(-5, 0.5), "muzzle velocity"}};
  for (const auto& [s, word] : wrong) {
    const auto checked = model.checkShot(s);
    ASSERT_FALSE(checked);
    EXPECT_NE(checked.error().text().find(word), std::string::npos) << checked.error().text();
    EXPECT_EQ(model.fly(s), Flight{});
    EXPECT_EQ(model.fly(s).end, FlightEnd::refused);
  }
}

TEST(Ballistics, AShellThatNeverComesDownOnTheSurfaceSaysSo) {
  Conditions high;
  high.target_height_m = 5000;
  const Flight flight = flying(test::shipped("m107"), high).fly(shot(297, mil(100)));
  EXPECT_EQ(flight.end, FlightEnd::no_impact);
  EXPECT_GT(flight.max_ordinate_m, 30.0);
  EXPECT_FALSE(flight.valid());
}

TEST(Ballistics, ATargetAboveIsMetOnTheWayDown) {
  Conditions conditions;
  conditions.target_height_m = 400.0;
  const FlightPath path = flying(test::shipped("m107"), conditions).path(charge7(300));
  EXPECT_EQ(path.flight().end, FlightEnd::impact);
  EXPECT_NEAR(path.flight().height_m, 400.0, 1e-6);
  EXPECT_GT(path.flight().time_of_flight_s, path.flight().apex_time_s);
  EXPECT_GT(path.flight().angle_of_fall_rad, 0.0);
}

/// A wall across the line of fire: 20 m thick, 300 m high.
class Ridge final : public Ground {
 public:
  double height(double x, double) const override { return std::fabs(x - 4000.0) < 10.0 ? 300.0 : 0.0; }
  double detail() const override { return 20.0; }
};

TEST(Ballistics, AThinRidgeIsNotJumpedOver) {
  Conditions conditions;
  conditions.ground = std::make_shared<Ridge>();
  Shot s = charge7(100);
  s.azimuth_rad = 0.5 * kPi;
  const Flight flight = flying(test::shipped("m107"), conditions).fly(s);
  EXPECT_NEAR(flight.range_m, 3990.0, 0.5);
  // Steeper, it clears the ridge and falls beyond.
  s.elevation_rad = mil(400);
  EXPECT_GT(flying(test::shipped("m107"), conditions).fly(s).range_m, 10000.0);
}

TEST(Ballistics, FlatTerrainAndAFlatSurfaceGiveTheSameImpact) {
  Conditions terrain;
  terrain.ground = std::make_shared<FlatGround>(30.0);
  Shot s = charge7(500);
  s.muzzle_m = {10.0, 32.0, -7.0};
  Conditions flat;
  flat.target_height_m = -2.0;
  const Flight a = flying(test::shipped("m107"), terrain).fly(s), b = flying(test::shipped("m107"), flat).fly(s);
  EXPECT_NEAR(a.range_m, b.range_m, 1e-6);
  EXPECT_NEAR(a.height_m, -2.0, 1e-6);
}

std::vector<Shot> manyShots() {
  std::vector<Shot> shots;
  for (int i = 0; i < 1300; ++i) {
    Shot s = shot(200.0 + 0.4 * i, mil(20 + (i * 37) % 1500));
    s.wind_mps = {0.01 * (i % 50), 0.0, -0.02 * (i % 31)};
    s.azimuth_rad = 0.001 * i;
    s.factors.form = 0.9 + 0.0002 * i;
    shots.push_back(s);
  }
  shots[77].speed_mps = -1.0;  // refused among the others
  return shots;
}

TEST(Ballistics, ManyShotsHaveTheBitsOfSingleOnesForAnyNumberOfThreads) {
  Conditions conditions;
  conditions.gravity = GravityModel::curved;
  conditions.has_latitude = conditions.coriolis = true;
  conditions.latitude_rad = 0.7;
  const auto shots = manyShots();
  for (const FlightModel kind : {FlightModel::modified_point_mass, FlightModel::simplified_modified_point_mass, FlightModel::point_mass, FlightModel::vacuum}) {
    const Ballistics model = flying(test::shipped("m107"), conditions, kind);
    std::vector<Flight> single, many(shots.size());
    for (const Shot& s : shots) single.push_back(model.fly(s));
    std::vector<Flight> few(11);
    model.flyMany(std::span(shots).first(few.size()), few, 1);
    for (std::size_t i = 0; i < few.size(); ++i) EXPECT_TRUE(few[i] == single[i]) << "shot " << i << " of a few";
    for (const int threads : {1, 2, 3, 7}) {
      std::ranges::fill(many, Flight{});
      model.flyMany(shots, many, threads);
      for (std::size_t i = 0; i < shots.size(); ++i) EXPECT_TRUE(many[i] == single[i]) << "shot " << i << ", " << threads << " threads";
    }
  }
}

TEST(Ballistics, EveryInstructionSetGivesTheSameBits) {
  using namespace ballistics;
  const Projectile m107 = test::shipped("m107");
  const auto setup = setupOf(m107, {}, FlightModel::modified_point_mass, {});
  std::vector<ShotConstants> constants;
  for (const Shot& s : manyShots())
    if (s.speed_mps > 0.0) constants.push_back(constantsOf(setup, s));
  std::vector<Progress> best(constants.size()), baseline(constants.size());
  bestKernels().fly_many(setup, constants.data(), best.data(), constants.size());
  baselineKernels().fly_many(setup, constants.data(), baseline.data(), constants.size());
  for (std::size_t i = 0; i < constants.size(); ++i) {
    Progress alone;
    baselineKernels().fly_one(setup, constants[i], alone, nullptr);
    for (const Progress* other : {&baseline[i], &alone}) {
      EXPECT_TRUE(best[i].flight == other->flight) << i;
      EXPECT_EQ(std::memcmp(best[i].impact_state, other->impact_state, sizeof alone.impact_state), 0) << i;
      EXPECT_EQ(best[i].yaw2_max, other->yaw2_max) << i;
    }
  }
}

TEST(Ballistics, TheThesisRowsAreMetWithinTheirBounds) {
  const auto tables = thesisTables();
  ASSERT_TRUE(tables) << tables.error().text();
  ASSERT_EQ(tables->rows.size(), 6u);
  const Projectile m107 = test::shipped("m107");
  const Ballistics model = flying(m107);
  for (const ThesisRow& row : tables->rows) {
    const auto charge = findCharge(m107, row.charge);
    ASSERT_TRUE(charge);
    Shot s = shot(charge->speed_mps, row.elevation_rad);
    const Flight unfitted = model.fly(s);
    EXPECT_LT(errorInCeps(row, unfitted.range_m, unfitted.drift_m), 5.5) << row.charge;
    s.factors = charge->factors.at(row.elevation_rad);
    const Flight fitted = model.fly(s);
    EXPECT_LT(errorInCeps(row, fitted.range_m, fitted.drift_m), row.charge == "7W" ? 1.0 : 1.6) << row.charge;
    // The thesis's own column of table 2, to the digits it prints.
    EXPECT_GT(errorInCeps(row, row.thesis_model.range_m, row.thesis_model.deflection_m), 1.0);
  }
  EXPECT_NEAR(errorInCeps(tables->rows[4], 13084, 210), 4.72, 0.01);
  EXPECT_NEAR(errorInCeps(tables->rows[0], 5513, 4), 136.7, 0.05);
}

TEST(Ballistics, FactorsAreHeldOutsideTheElevationsTheyWereFittedTo) {
  FactorCurves f;
  f.elevation_min_rad = mil(200);
  f.elevation_max_rad = mil(800);
  f.form = {1.0, 0.5};
  EXPECT_DOUBLE_EQ(f.at(mil(400)).form, 1.2);
  EXPECT_DOUBLE_EQ(f.at(mil(1200)).form, 1.4);
  EXPECT_DOUBLE_EQ(f.at(0.0).form, 1.1);
  EXPECT_EQ(f.at(mil(400)).lift, 1.0);
}

TEST(Ballistics, CurvedGravityCarriesAsFarAsTheEarthFallsAway) {
  Conditions curved;
  curved.gravity = GravityModel::curved;
  const Projectile p = test::shipped("m107");
  const double far = flying(p, curved).fly(charge7(533)).range_m - flying(p).fly(charge7(533)).range_m;
  const double near = flying(p, curved).fly(shot(297, mil(533))).range_m - flying(p).fly(shot(297, mil(533))).range_m;
  EXPECT_NEAR(far, 13.0, 4.0);
  EXPECT_NEAR(near, 4.0, 1.5);
  curved.has_latitude = true;
  curved.latitude_rad = 0.0;
  EXPECT_NEAR(curved.gravityAtMuzzle(), 9.80665 * 0.9974, 1e-12);
}

TEST(Ballistics, AltitudeThinsTheAir) {
  Conditions high;
  high.muzzle_altitude_m = 2000.0;
  EXPECT_GT(flying(test::shipped("m107"), high).fly(charge7(533)).range_m, flying(test::shipped("m107")).fly(charge7(533)).range_m + 500.0);
}

}  // namespace
}  // namespace npsee
