#pragma once

#include "sim/observer/fire_direction.h"

#include <npsee/units.h>
#include <npsee/weapons.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace npsee::observer::test {

inline double mil(double value) { return value * kTwoPi / 6400.0; }
inline double level(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.z - b.z); }

/// The weapons of the shipped file.
inline Weapon weapon(int id) {
  const auto weapons = loadWeapons(std::string(NPSEE_SOURCE_DIR) + "/assets/weapons.dat");
  EXPECT_TRUE(weapons) << (weapons ? "" : weapons.error().text());
  const Weapon* found = weapons ? weapons->find(std::to_string(id)) : nullptr;
  EXPECT_TRUE(found);
  return found ? *found : Weapon{};
}

inline Terrain terrain(const TerrainSource& source, double sea_level_m = 0.0) {
  auto made = Terrain::make(source, 50000.0, 50000.0, sea_level_m);
  EXPECT_TRUE(made) << (made ? "" : made.error().text());
  return made ? *made : Terrain();
}
inline Terrain level(double height_m = 0.0) {
  TerrainSource source;
  source.height_m = height_m;
  return terrain(source);
}
/// The ridge of the acceptance scenarios: foot at 4,200 m from the guns, crest at 4,600, foot at 4,900.
inline Terrain ridge(double crest_m) {
  TerrainSource source;
  source.kind = TerrainKind::function;
  source.expression = "ridge";
  source.axis = "z";
  source.params = {{"crest_x", 25000.0}, {"crest_height", crest_m}, {"foot_before", 400.0}, {"foot_after", 300.0}};
  return terrain(source);
}
/// Rises towards the east; the sea lies 1,000 m down, out of the way.
inline Terrain slope(double rise) {
  TerrainSource source;
  source.kind = TerrainKind::function;
  source.expression = "plane";
  source.params = {{"height", 100.0}, {"slope_x", rise}};
  return terrain(source, -1000.0);
}

/// A battery of the shipped 155 mm weapon, without errors.
inline BatterySetup battery() {
  BatterySetup b;
  b.id = "alpha";
  b.guns.push_back({"gun1", {20400.0, 25000.0}});
  return b;
}

inline FireDirection centre(const BatterySetup& b, const Terrain& t, const Weather& weather = {}, const FdcSetup& fdc = {}, const Weapon& w = weapon(110)) {
  auto made = FireDirection::make(b, w, t, weather, fdc);
  if (!made) throw std::runtime_error(made.error().text());
  return std::move(*made);
}

/// Gun at (20400, 25000), target so far east and south of it, both on the ground.
inline FireRequest request(const Terrain& t, double east_m, double south_m = 0.0) {
  FireRequest r;
  r.muzzle_m = {20400.0, t.surface(20400.0, 25000.0) + 2.0, 25000.0};
  r.target_m = {20400.0 + east_m, t.surface(20400.0 + east_m, 25000.0 + south_m), 25000.0 + south_m};
  return r;
}

inline Vec3 impactOf(const FlightPath& path) { return path.inWorld(1e9).position_m; }

}  // namespace npsee::observer::test
