#pragma once

#include "tests/support/process.h"

#include <npsee/ballistics.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace npsee::test {

inline double mil(double value) { return value * kTwoPi / 6400.0; }

inline Projectile shipped(const char* name) {
  auto projectile = findProjectile(name);
  EXPECT_TRUE(projectile) << (projectile ? "" : projectile.error().text());
  return projectile.value_or(Projectile{});
}

/// A body with one drag coefficient and no spin.
inline Projectile sphere(double mass_kg, double diameter_m, double cd) {
  Projectile p;
  p.name = "test";
  p.mass_kg = mass_kg;
  p.diameter_m = diameter_m;
  p.curve(Coefficient::cd0) = CoefficientCurve::constant(cd);
  return p;
}

inline Ballistics flying(const Projectile& projectile, const Conditions& conditions = {}, FlightModel model = FlightModel::modified_point_mass,
                             const Integration& integration = {}) {
  auto made = Ballistics::make(projectile, conditions, model, integration);
  if (!made) throw std::runtime_error(made.error().text());
  return *made;
}

inline Shot shot(double speed_mps, double elevation_rad) {
  Shot s;
  s.speed_mps = speed_mps;
  s.elevation_rad = elevation_rad;
  return s;
}

inline std::string data(const std::string& name) { return slurp(std::string(NPSEE_SOURCE_DIR) + "/tests/data/" + name); }

/// Constant air as the closed forms assume it.
inline Conditions constantAir(double density = 1.225) {
  Conditions c;
  c.atmosphere = {false, density, 340.294};
  return c;
}

}  // namespace npsee::test
