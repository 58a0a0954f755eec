#include <npsee/aiming.h>

#include "tests/physics/ballistics_support.h"

namespace npsee {
namespace {

using test::flying;
using test::mil;

AimRequest request(const Projectile& projectile, const char* charge) {
  const auto found = findCharge(projectile, charge);
  EXPECT_TRUE(found);
  AimRequest r;
  r.speed_mps = found->speed_mps;
  r.factors = found->factors;
  return r;
}

/// Flies a solution again, alone, and measures the distance to the target in the world.
double missOf(const Ballistics& model, const AimSolution& solution, const AimRequest& r, double range_m) {
  const Ballistics onto = model.onto(r.height_m);
  const Flight flight = onto.fly(solution.shot);
  const Vec3 impact = worldFromFlight({flight.range_m, 0.0, flight.drift_m}, solution.shot.azimuth_rad);
  return length(impact - worldFromFlight({range_m, 0.0, 0.0}, r.azimuth_rad));
}

TEST(Aiming, LowAndHighSolutionsHitWithinHalfAMetreUpToNearlyTheGreatestRange) {
  const Projectile m107 = test::shipped("m107");
  for (const bool windy : {false, true})
    for (const char* charge : {"3W", "7W", "8"})
      for (const double height : {0.0, 250.0, -400.0}) {
        Conditions conditions;
        conditions.has_latitude = conditions.coriolis = windy;
        conditions.latitude_rad = 0.6;
        AimRequest r = request(m107, charge);
        r.height_m = height;
        r.azimuth_rad = 1.1;
        if (windy) r.wind_mps = {-8.0, 0.0, 14.0};
        const Ballistics model = flying(m107, conditions);
        const auto aimer = Aimer::make(model, r);
        ASSERT_TRUE(aimer) << aimer.error().text();
        for (const double share : {0.3, 0.5, 0.8, 0.95, 0.99, 0.999}) {
          const double range = share * aimer->maxRange();
          const auto low = aimer->low(range), high = aimer->high(range);
          ASSERT_TRUE(low && high) << charge << ' ' << height << ' ' << share;
          for (const AimSolution& solution : {*low, *high}) {
            EXPECT_LT(missOf(model, solution, r, range), 0.5) << charge << ' ' << height << ' ' << share;
            EXPECT_LT(solution.miss_m, 0.5);
          }
          EXPECT_LT(low->shot.elevation_rad, aimer->maxRangeElevation());
          EXPECT_GT(high->shot.elevation_rad, aimer->maxRangeElevation());
          EXPECT_TRUE(windy || low->azimuth_correction_rad < 0.0) << "against the drift to the right";
        }
      }
}

TEST(Aiming, NoElevationReachesFurtherThanTheMaximum) {
  const Projectile m107 = test::shipped("m107");
  const Ballistics model = flying(m107);
  const auto aimer = Aimer::make(model, request(m107, "3W"));
  ASSERT_TRUE(aimer);
  const auto charge = findCharge(m107, "3W");
  double best = 0.0;
  for (double e = 600; e < 950; e += 0.5) {
    Shot s = test::shot(charge->speed_mps, mil(e));
    s.factors = charge->factors.at(s.elevation_rad);
    const Flight f = model.fly(s);
    best = std::max(best, std::hypot(f.range_m, f.drift_m));
  }
  EXPECT_NEAR(aimer->maxRange(), best, 0.2);
}

TEST(Aiming, OutOfReachNamesTheMaximum) {
  const Projectile m107 = test::shipped("m107");
  const auto aimer = Aimer::make(flying(m107), request(m107, "3W"));
  ASSERT_TRUE(aimer);
  EXPECT_FALSE(aimer->low(9000.0));
  EXPECT_FALSE(aimer->high(9000.0));
  const auto reach = aimer->checkReach(9000.0);
  ASSERT_FALSE(reach);
  char limit[40];
  std::snprintf(limit, sizeof limit, "the maximum is %.1f m", aimer->maxRange());
  EXPECT_NE(reach.error().text().find(limit), std::string::npos) << reach.error().text();
  EXPECT_TRUE(aimer->checkReach(5000.0));
  EXPECT_FALSE(aimer->checkReach(-1.0));
  EXPECT_FALSE(aimer->checkReach(std::nan("")));
}

TEST(Aiming, ATargetHigherThanTheShellFliesIsRefused) {
  const Projectile m107 = test::shipped("m107");
  AimRequest r = request(m107, "3W");
  r.height_m = 15000.0;
  const auto aimer = Aimer::make(flying(m107), r);
  ASSERT_FALSE(aimer);
  EXPECT_NE(aimer.error().text().find("15000 m above the muzzle"), std::string::npos);
}

TEST(Aiming, ATargetStraightBelowIsHitFiringDownwards) {
  const Projectile m107 = test::shipped("m107");
  AimRequest r = request(m107, "3W");
  r.height_m = -1000.0;
  const Ballistics model = flying(m107);
  const auto aimer = Aimer::make(model, r);
  ASSERT_TRUE(aimer);
  const auto low = aimer->low(900.0);
  ASSERT_TRUE(low);
  EXPECT_LT(low->shot.elevation_rad, 0.0);
  EXPECT_LT(missOf(model, *low, r, 900.0), 0.5);
}

TEST(Aiming, TheVacuumHasItsTwoTextbookElevations) {
  // sin 2e = g R / v^2.
  AimRequest r;
  r.speed_mps = 200.0;
  const auto aimer = Aimer::make(flying(test::sphere(10.0, 0.1, 0.3), {}, FlightModel::vacuum), r);
  ASSERT_TRUE(aimer);
  EXPECT_NEAR(aimer->maxRange(), 200.0 * 200.0 / kStandardGravity_mps2, 0.1);
  const double twice = std::asin(kStandardGravity_mps2 * 3000.0 / 40000.0);
  EXPECT_NEAR(aimer->low(3000.0)->shot.elevation_rad, 0.5 * twice, 1e-5);
  EXPECT_NEAR(aimer->high(3000.0)->shot.elevation_rad, 0.5 * (kPi - twice), 1e-5);
}

TEST(Aiming, PublishedGreatestRangesAreMet) {
  // tests/data/ballistics_reference.json, maxrange_*: to 1.5 %.
  Projectile m107 = test::shipped("m107");
  m107.twist_cal = 25.0;
  for (const auto& [speed, range] : {std::pair(274.3, 6300.0), std::pair(374.6, 9700.0)}) {
    AimRequest r;
    r.speed_mps = speed;
    const auto aimer = Aimer::make(flying(m107), r);
    ASSERT_TRUE(aimer);
    EXPECT_NEAR(aimer->maxRange(), range, 0.015 * range);
  }
}

TEST(Aiming, TheLegacyTableLaysForMultiplesOfTwoHundredAndFiftyMetres) {
  EXPECT_EQ(legacyRange(5130.0), 5250.0);
  EXPECT_EQ(legacyRange(5120.0), 5000.0);
  EXPECT_EQ(legacyRange(5130.0, 100.0), 5100.0);
}

}  // namespace
}  // namespace npsee
