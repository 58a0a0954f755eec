#include "tests/support/explosions.h"

#include <npsee/units.h>

#include <gtest/gtest.h>

#include <cmath>

namespace npsee {
namespace {

using test::compiled;
using test::exactAt;
using test::onePiece;

TEST(Flight, WithoutAirFollowsTheParabola) {
  Preset preset = onePiece();
  preset.layers[0].count = 50;
  preset.layers[0].lifetime_mean_s = 60.0;
  const auto explosion = compiled(preset);
  const ExactFrame start = exactAt(*explosion, 0.0);
  for (const double t : {0.1, 0.5, 1.0}) {
    const ExactFrame now = exactAt(*explosion, t);
    for (std::size_t i = 0; i < now.count; ++i) {
      ASSERT_EQ(now.bounces[i], 0);
      EXPECT_NEAR(now.x[i], start.x[i] + start.vx[i] * t, 1e-12 * 100);
      EXPECT_NEAR(now.y[i], start.y[i] + start.vy[i] * t - 0.5 * kStandardGravity_mps2 * t * t, 1e-12 * 100);
      EXPECT_NEAR(now.vy[i], start.vy[i] - kStandardGravity_mps2 * t, 1e-12 * 100);
    }
  }
}

TEST(Flight, LinearTrajectoriesAreStraightWhateverGravityDragAndWindAre) {
  Preset preset = onePiece();
  preset.wind_mps = {10, 0, 5};
  preset.layers[0].trajectory = Trajectory::linear;
  preset.layers[0].drag_ps = 2.0;
  const auto explosion = compiled(preset);
  const ExactFrame a = exactAt(*explosion, 0.0), b = exactAt(*explosion, 3.0);
  EXPECT_DOUBLE_EQ(b.y[0], a.y[0] + 3.0 * a.vy[0]);
  EXPECT_DOUBLE_EQ(b.vx[0], a.vx[0]);
}

/// Runge-Kutta integration of dv/dt = a - k (v - w), independent of the closed form.
void integrate(double k, const Vec3& wind, double a, double t, Vec3& x, Vec3& v) {
  const int steps = 20000;
  const double h = t / steps;
  const auto acceleration = [&](const Vec3& u) { return Vec3{-k * (u.x - wind.x), a - k * (u.y - wind.y), -k * (u.z - wind.z)}; };
  for (int i = 0; i < steps; ++i) {
    const Vec3 k1 = acceleration(v), k2 = acceleration(v + (h / 2) * k1), k3 = acceleration(v + (h / 2) * k2), k4 = acceleration(v + h * k3);
    x = x + h * v + (h * h / 6) * (k1 + k2 + k3);
    v = v + (h / 6) * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
}

class DragStrength : public testing::TestWithParam<double> {};

TEST_P(DragStrength, AgreesWithNumericalIntegration) {
  Preset preset = onePiece();
  preset.wind_mps = {7.0, 1.0, -4.0};
  Layer& layer = preset.layers[0];
  layer.drag_ps = GetParam();
  layer.buoyancy_mps2 = 1.5;
  layer.collide = false;
  const auto explosion = compiled(preset);
  const ExactFrame start = exactAt(*explosion, 0.0);
  for (const double t : {0.3, 2.0, 10.0}) {
    Vec3 x{start.x[0], start.y[0], start.z[0]}, v{start.vx[0], start.vy[0], start.vz[0]};
    integrate(GetParam(), preset.wind_mps, 1.5 - preset.gravity_mps2, t, x, v);
    const ExactFrame now = exactAt(*explosion, t);
    EXPECT_NEAR(now.x[0], x.x, 1e-7);
    EXPECT_NEAR(now.y[0], x.y, 1e-7);
    EXPECT_NEAR(now.z[0], x.z, 1e-7);
    EXPECT_NEAR(now.vy[0], v.y, 1e-7);
    EXPECT_NEAR(now.vz[0], v.z, 1e-7);
  }
}

INSTANTIATE_TEST_SUITE_P(FromNearlyNoneToThick, DragStrength, testing::Values(1e-7, 1e-5, 1.9e-4, 2.1e-4, 1e-2, 0.3, 2.0, 20.0));

TEST(Flight, DragBecomesTheParabolaAsItVanishes) {
  Preset preset = onePiece();
  preset.layers[0].collide = false;
  const ExactFrame without = exactAt(*compiled(preset), 5.0);
  preset.layers[0].drag_ps = 1e-9;
  const ExactFrame with = exactAt(*compiled(preset), 5.0);
  EXPECT_NEAR(with.y[0], without.y[0], 1e-6);
}

TEST(Flight, DragInTheLongRunLeavesTheTerminalVelocity) {
  Preset preset = onePiece();
  preset.wind_mps = {12.0, 0.0, 3.0};
  Layer& layer = preset.layers[0];
  layer.drag_ps = 2.0;
  layer.collide = false;
  layer.lifetime_mean_s = 100.0;
  const ExactFrame now = exactAt(*compiled(preset), 50.0);
  EXPECT_NEAR(now.vx[0], 12.0, 1e-12);
  EXPECT_NEAR(now.vz[0], 3.0, 1e-12);
  EXPECT_NEAR(now.vy[0], -kStandardGravity_mps2 / 2.0, 1e-12);
}

TEST(Flight, NothingIsAliveBeforeTheBurstOrAfterDeath) {
  Preset preset = onePiece();
  preset.layers[0].start_s = 0.5;
  preset.layers[0].lifetime_mean_s = 2.0;
  const auto explosion = compiled(preset);
  EXPECT_EQ(exactAt(*explosion, -1.0).alive[0], 0);
  EXPECT_EQ(exactAt(*explosion, 0.49).alive[0], 0);
  EXPECT_EQ(exactAt(*explosion, 0.5).alive[0], 1);
  EXPECT_EQ(exactAt(*explosion, 2.49).alive[0], 1);
  EXPECT_EQ(exactAt(*explosion, 2.5).alive[0], 0);
  EXPECT_DOUBLE_EQ(explosion->duration_s(), 2.5);
  for (const double t : {-1e300, 1e300}) {
    const ExactFrame far = exactAt(*explosion, t);
    EXPECT_EQ(far.size[0], 0.0);
    EXPECT_EQ(far.a[0], 0.0);
    EXPECT_TRUE(std::isfinite(far.y[0]));
  }
}

TEST(Flight, OrientationIsAUnitQuaternionThatStopsTurningAtRest) {
  Preset preset = onePiece();
  Layer& layer = preset.layers[0];
  layer.count = 40;
  layer.lifetime_mean_s = 100.0;
  layer.bounce_limit = 2;
  const auto explosion = compiled(preset);
  for (const double t : {0.0, 0.7, 40.0}) {
    const ExactFrame now = exactAt(*explosion, t);
    for (std::size_t i = 0; i < now.count; ++i)
      EXPECT_NEAR(now.qx[i] * now.qx[i] + now.qy[i] * now.qy[i] + now.qz[i] * now.qz[i] + now.qw[i] * now.qw[i], 1.0, 1e-6);
  }
  const ExactFrame early = exactAt(*explosion, 0.2), later = exactAt(*explosion, 0.4), rest = exactAt(*explosion, 60.0), still = exactAt(*explosion, 80.0);
  EXPECT_NE(early.qw[0], later.qw[0]);
  EXPECT_EQ(rest.qw, still.qw);
}

}  // namespace
}  // namespace npsee
