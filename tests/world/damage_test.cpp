#include "sim/world/vehicles.h"

#include <gtest/gtest.h>

#include <limits>

namespace npsee {
namespace {

using world::harmed;

Weapon howitzer() {
  Weapon weapon;
  weapon.kill_radius_m = 50;
  weapon.damage_radius_m = 150;
  weapon.knowledge_radius_m = 250;
  weapon.target = TargetType::heavy_armor;
  return weapon;
}

/// Mean of the hull lost over many seeds.
double meanHarm(const Weapon& weapon, TargetClass target, double miss_m) {
  double sum = 0.0;
  for (int seed = 0; seed < 500; ++seed) sum += harmed(weapon, target, miss_m, {}, seed, 3, 0, 1.0).hull;
  return sum / 500;
}

TEST(Damage, WithinTheKillRadiusItsOwnTargetIsDestroyedForEverySeed) {
  for (int seed = 0; seed < 200; ++seed)
    for (const double miss : {0.0, 10.0, 50.0}) {
      const DamageStep now = harmed(howitzer(), TargetClass::heavy_armor, miss, {}, seed, 1, 0, 12.5);
      EXPECT_EQ(now.hull, 1.0);
      EXPECT_FALSE(now.mobility || now.firepower);
      EXPECT_EQ(now.t_s, 12.5);
    }
}

TEST(Damage, BeyondTheDamageRadiusNothingHappens) {
  for (const double miss : {150.01, 1e6, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    const DamageStep now = harmed(howitzer(), TargetClass::personnel, miss, {}, 1, 1, 0, 1.0);
    EXPECT_EQ(now.hull, 0.0);
    EXPECT_TRUE(now.mobility && now.firepower);
  }
}

TEST(Damage, FallsWithTheMissDistance) {
  double last = 1.0;
  for (double miss = 55.0; miss <= 150.0; miss += 10.0) {
    const double mean = meanHarm(howitzer(), TargetClass::heavy_armor, miss);
    EXPECT_LT(mean, last) << miss;
    EXPECT_GT(mean, 0.0);
    last = mean;
  }
}

TEST(Damage, AccumulatesUntilTheHullIsGone) {
  int lamed_first = 0;
  for (int seed = 0; seed < 100; ++seed) {
    DamageStep state;
    std::uint32_t bursts = 0;
    bool lame = false;
    while (state.hull < 1.0 && bursts < 100) {
      const DamageStep next = harmed(howitzer(), TargetClass::heavy_armor, 80.0, state, seed, 7, bursts, 1.0 + bursts);
      ++bursts;
      EXPECT_GT(next.hull, state.hull);
      // What is lost stays lost.
      EXPECT_TRUE(state.mobility || !next.mobility);
      EXPECT_TRUE(state.firepower || !next.firepower);
      lame = lame || (!next.mobility && next.hull < 1.0);
      state = next;
    }
    EXPECT_GE(bursts, 2u);
    EXPECT_LE(bursts, 8u);
    EXPECT_FALSE(state.mobility || state.firepower);
    lamed_first += lame ? 1 : 0;
  }
  EXPECT_GT(lamed_first, 60);
}

TEST(Damage, AWeaponMadeAgainstSoftTargetsDoesLessToArmour) {
  Weapon rifle = howitzer();
  rifle.target = TargetType::personnel;
  EXPECT_EQ(harmed(rifle, TargetClass::personnel, 5.0, {}, 1, 1, 0, 1.0).hull, 1.0);
  double last = 1.0;
  for (const TargetClass target : {TargetClass::wheeled, TargetClass::light_armor, TargetClass::heavy_armor}) {
    const double hull = harmed(rifle, target, 5.0, {}, 1, 1, 0, 1.0).hull;
    EXPECT_LT(hull, last);
    EXPECT_GT(hull, 0.0);
    last = hull;
  }
}

TEST(Damage, AWeaponAgainstAnythingAndEachAgainstItsOwnHaveTheirFullEffect) {
  const TargetClass classes[] = {TargetClass::heavy_armor, TargetClass::light_armor, TargetClass::wheeled, TargetClass::personnel, TargetClass::aircraft, TargetClass::watercraft};
  const TargetType types[] = {TargetType::heavy_armor, TargetType::light_armor, TargetType::wheeled_vehicle, TargetType::personnel, TargetType::aircraft, TargetType::watercraft};
  for (int i = 0; i < 6; ++i) {
    Weapon weapon = howitzer();
    weapon.target = types[i];
    EXPECT_EQ(harmed(weapon, classes[i], 1.0, {}, 1, 1, 0, 1.0).hull, 1.0) << i;
    weapon.target = TargetType::any;
    EXPECT_EQ(harmed(weapon, classes[i], 1.0, {}, 1, 1, 0, 1.0).hull, 1.0) << i;
  }
}

TEST(Damage, IsAFunctionOfItsDrawsAlone) {
  const DamageStep once = harmed(howitzer(), TargetClass::light_armor, 90.0, {}, 42, 5, 2, 9.0);
  EXPECT_EQ(once, harmed(howitzer(), TargetClass::light_armor, 90.0, {}, 42, 5, 2, 9.0));
  EXPECT_NE(once.hull, harmed(howitzer(), TargetClass::light_armor, 90.0, {}, 43, 5, 2, 9.0).hull);
  EXPECT_NE(once.hull, harmed(howitzer(), TargetClass::light_armor, 90.0, {}, 42, 6, 2, 9.0).hull);
  EXPECT_NE(once.hull, harmed(howitzer(), TargetClass::light_armor, 90.0, {}, 42, 5, 3, 9.0).hull);
}

TEST(Damage, RadiiOfNothingAndInsideOutAreHarmless) {
  Weapon none;
  EXPECT_EQ(harmed(none, TargetClass::personnel, 0.5, {}, 1, 1, 0, 1.0).hull, 0.0);
  Weapon inside_out = howitzer();
  inside_out.damage_radius_m = 10;
  EXPECT_EQ(harmed(inside_out, TargetClass::heavy_armor, 49.0, {}, 1, 1, 0, 1.0).hull, 1.0);
  EXPECT_EQ(harmed(inside_out, TargetClass::heavy_armor, 51.0, {}, 1, 1, 0, 1.0).hull, 0.0);
}

}  // namespace
}  // namespace npsee
