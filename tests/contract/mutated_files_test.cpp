// Thousands of damaged projectile files, coefficient tables and weapons.dat: each is refused with a fault, or is a value that flies
// and survives writing and reading.

#include <npsee/ballistics.h>
#include <npsee/weapons.h>

#include "tests/support/damage.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace npsee {
namespace {

const std::string kAssets = std::string(NPSEE_SOURCE_DIR) + "/assets/";

/// With what parsers stumble over.
std::string damaged(std::string text, std::mt19937& random) {
  static const char* const kTraps[] = {"NaN", "1e999", "-", "\"", "[", "}", "/*", "*/", "null", "0", "-1", "1e308", "D", "I", "\n", "\\u0000", "99999999999999999999", "\xff"};
  return test::damaged(std::move(text), random, kTraps, 4);
}

void expectFaults(const Error& error) {
  ASSERT_FALSE(error.faults.empty());
  for (const Fault& fault : error.faults) EXPECT_FALSE(fault.what.empty());
}

TEST(MutatedFiles, AProjectileIsRefusedOrFlies) {
  std::mt19937 random(2024);
  int read = 0;
  for (const char* name : {"m107", "m33", "m106"}) {
    const std::string whole = test::slurp(kAssets + "projectiles/" + name + ".json");
    ASSERT_FALSE(whole.empty());
    for (int i = 0; i < 700; ++i) {
      const auto p = parseProjectile(damaged(whole, random), "damaged");
      if (!p) {
        expectFaults(p.error());
        continue;
      }
      ++read;
      const auto again = parseProjectile(projectileText(*p), "again");
      ASSERT_TRUE(again) << again.error().text();
      EXPECT_EQ(*again, *p);
      Integration integration;
      integration.step_limit = 2000;
      const auto model = Ballistics::make(*p, {}, FlightModel::modified_point_mass, integration);
      ASSERT_TRUE(model) << model.error().text();
      Shot shot;
      shot.speed_mps = 500.0;
      shot.elevation_rad = 0.7;
      if (!p->charges.empty()) shot.factors = p->charges[0].factors.at(shot.elevation_rad);
      const Flight flight = model->fly(shot);
      EXPECT_TRUE(std::isfinite(flight.range_m) && std::isfinite(flight.drift_m) && std::isfinite(flight.max_ordinate_m));
    }
  }
  EXPECT_GT(read, 100) << "most damage should not be total";
}

TEST(MutatedFiles, ACoefficientTableIsRefusedOrHasFiniteCurves) {
  std::mt19937 random(7);
  const std::string whole = test::slurp(std::string(NPSEE_SOURCE_DIR) + "/tests/data/m107_table.json");
  for (int i = 0; i < 500; ++i) {
    const auto table = parseAeroTable(damaged(whole, random), "damaged", i % 2 ? Interpolation::linear : Interpolation::monotone);
    if (!table) expectFaults(table.error());
    else
      for (const CoefficientCurve& curve : *table)
        for (const double mach : {0.0, 0.5, 0.97, 1.3, 9.0}) EXPECT_TRUE(std::isfinite(curve.at(mach)));
  }
}

TEST(MutatedFiles, AWeaponsFileIsRefusedOrSurvivesWriting) {
  std::mt19937 random(42);
  const std::string whole = test::slurp(kAssets + "weapons.dat");
  int read = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::string text = damaged(whole, random);
    const auto weapons = parseWeapons(text, "damaged");
    if (!weapons) {
      expectFaults(weapons.error());
      continue;
    }
    ++read;
    const auto again = parseWeapons(weaponsText(*weapons), "again");
    ASSERT_TRUE(again) << text << "\n-> " << weaponsText(*weapons) << again.error().text();
    EXPECT_EQ(*again, *weapons) << text << "\n-> " << weaponsText(*weapons);
  }
  EXPECT_GT(read, 300);
}

}  // namespace
}  // namespace npsee
