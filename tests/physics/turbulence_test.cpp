// Eddies that move particles off their paths.

#include "tests/support/explosions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace npsee {
namespace {

using test::compiled;
using test::exactAt;

constexpr double kAmplitude = 2.0;

/// A cloud of all kinds of motion: thrown up, slowed, bouncing.
Preset cloudOf(double turbulence_m, bool collide = true) {
  Preset preset;
  preset.wind_mps = {2.0, 0.0, -1.0};
  preset.layers.emplace_back();
  Layer& layer = preset.layers[0];
  layer.count = 700;
  layer.drag_ps = 0.8;
  layer.lifetime_mean_s = 4.0;
  layer.collide = collide;
  layer.turbulence_m = turbulence_m;
  layer.turbulence_size_m = 3.0;
  return preset;
}

/// One unmoved particle at a place, without or in eddies.
Preset stillAt(const Vec3& place, double turbulence_m, double lifetime_s = 5.0) {
  Preset preset = test::onePiece();
  Layer& layer = preset.layers[0];
  layer.region_shape = RegionShape::point;
  layer.region_offset_m = place;
  layer.trajectory = Trajectory::linear;
  layer.collide = false;
  layer.speed_mean_mps = layer.speed_deviation_mps = 0.0;
  layer.lifetime_mean_s = lifetime_s;
  layer.turbulence_m = turbulence_m;
  layer.turbulence_size_m = 3.0;
  return preset;
}

Vec3 placeOf(const ExactFrame& frame, std::size_t i) { return {frame.x[i], frame.y[i], frame.z[i]}; }

Vec3 displacedAt(const Vec3& place, double t) { return placeOf(exactAt(*compiled(stillAt(place, kAmplitude)), t), 0) - placeOf(exactAt(*compiled(stillAt(place, 0.0)), t), 0); }

TEST(Turbulence, IsZeroAtBirthAndNeverMoreThanItsAmplitude) {
  const auto calm = compiled(cloudOf(0.0)), stirred = compiled(cloudOf(kAmplitude));
  double most = 0.0, sum = 0.0;
  int count = 0;
  for (const double t : {0.0, 0.01, 0.5, 1.3, 2.9, 3.8}) {
    const ExactFrame a = exactAt(*calm, t), b = exactAt(*stirred, t);
    for (std::size_t i = 0; i < a.count; ++i) {
      const double way = length(placeOf(b, i) - placeOf(a, i));
      ASSERT_LE(way, t == 0.0 ? 0.0 : t == 0.01 ? 0.03 * kAmplitude : kAmplitude);
      most = std::max(most, way);
      if (t > 2.0) sum += way, ++count;
    }
  }
  // As the parameter's words promise: a quarter or so is usual.
  EXPECT_GT(most, 0.45 * kAmplitude);
  EXPECT_NEAR(sum / count, 0.25 * kAmplitude, 0.10 * kAmplitude);
}

TEST(Turbulence, NothingIsPushedBelowTheGround) {
  for (const double ground : {0.0, -7.5}) {
    Preset preset = cloudOf(6.0);
    preset.ground_height_m = ground;
    const auto explosion = compiled(preset);
    for (int k = 0; k <= 80; ++k) {
      const ExactFrame now = exactAt(*explosion, 0.1 * k);
      for (std::size_t i = 0; i < now.count; ++i) ASSERT_GE(now.y[i], ground - 1e-12) << "at " << now.time_s;
    }
  }
}

TEST(Turbulence, TheVelocityIsTheDerivativeOfThePlace) {
  const double step = 1e-5;
  const auto explosion = compiled(cloudOf(kAmplitude));
  int compared = 0;
  for (const double t : {0.4, 1.1, 2.6}) {
    const ExactFrame before = exactAt(*explosion, t - step), now = exactAt(*explosion, t), after = exactAt(*explosion, t + step);
    for (std::size_t i = 0; i < now.count; ++i) {
      if (!before.alive[i] || !after.alive[i] || before.bounces[i] != after.bounces[i]) continue;
      const Vec3 slope = (0.5 / step) * (placeOf(after, i) - placeOf(before, i));
      // Where a wave's two parabolas meet, the difference quotient is off by its curvature times the step.
      ASSERT_NEAR(slope.x, now.vx[i], 2e-3);
      ASSERT_NEAR(slope.y, now.vy[i], 2e-3);
      ASSERT_NEAR(slope.z, now.vz[i], 2e-3);
      ++compared;
    }
  }
  EXPECT_GT(compared, 1500);
}

TEST(Turbulence, PathsHaveNoJumps) {
  const auto explosion = compiled(cloudOf(kAmplitude));
  ExactFrame before = exactAt(*explosion, 0.0);
  for (int k = 1; k <= 400; ++k) {
    const ExactFrame now = exactAt(*explosion, 0.01 * k);
    for (std::size_t i = 0; i < now.count; ++i)
      // The fastest piece is thrown at some 30 m/s; eddies of 3 m add less than 15.
      ASSERT_LT(length(placeOf(now, i) - placeOf(before, i)), 0.45) << "piece " << i << " at " << now.time_s;
    before = now;
  }
}

TEST(Turbulence, NeighboursMoveTogetherAndFarOnesDoNot) {
  double near = 0.0, far = 0.0;
  for (int k = 0; k < 12; ++k) {
    const Vec3 here{1.0 + 2.7 * k, 60.0 - 1.9 * k, -2.0 + 1.3 * k}, moved = displacedAt(here, 4.0);
    near += length(displacedAt(here + Vec3{0.05, 0.0, 0.05}, 4.0) - moved);
    far += length(displacedAt(here + Vec3{11.0, 3.0, 7.0}, 4.0) - moved);
  }
  EXPECT_GT(far / 12, 0.2 * kAmplitude);
  EXPECT_LT(near, 0.3 * far);
}

TEST(Turbulence, TheFieldIsFreeOfDivergence) {
  const double h = 0.02, t = 3.0;
  double divergences = 0.0, slopes = 0.0;
  for (int k = 0; k < 12; ++k) {
    // So high above the ground that its damping of the vertical part does not show.
    const Vec3 place{3.1 * k, 100.0 + 1.7 * k, -2.3 * k};
    const Vec3 axes[] = {{h, 0.0, 0.0}, {0.0, h, 0.0}, {0.0, 0.0, h}};
    double divergence = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 change = (0.5 / h) * (displacedAt(place + axes[axis], t) - displacedAt(place - axes[axis], t));
      divergence += axis == 0 ? change.x : axis == 1 ? change.y : change.z;
      slopes += length(change);
    }
    divergences += std::abs(divergence);
  }
  EXPECT_GT(slopes, 1.0);
  // Places are stored as floats: at 100 m to 4e-6, a five thousandth of the step.
  EXPECT_LT(divergences, 0.02 * slopes);
}

TEST(Turbulence, LayersOfOneSizeMoveTogetherAndSeedsDiffer) {
  Preset preset = stillAt({2.0, 30.0, 1.0}, kAmplitude);
  preset.layers.push_back(preset.layers[0]);
  preset.layers[1].name = "other";
  const ExactFrame now = exactAt(*compiled(preset), 3.0);
  EXPECT_EQ(now.x[0], now.x[1]);
  EXPECT_EQ(now.y[0], now.y[1]);
  ++preset.seed;
  EXPECT_NE(exactAt(*compiled(preset), 3.0).x[0], now.x[0]);
}

TEST(Turbulence, PiecesAtRestStayWhereTheyLie) {
  const auto explosion = compiled([] {
    Preset preset = cloudOf(kAmplitude);
    preset.layers[0].lifetime_mean_s = 60.0;
    preset.layers[0].lifetime_deviation_s = 0.0;
    return preset;
  }());
  const ExactFrame early = exactAt(*explosion, 30.0), late = exactAt(*explosion, 50.0);
  for (std::size_t i = 0; i < early.count; ++i) {
    ASSERT_EQ(placeOf(early, i), placeOf(late, i));
    ASSERT_EQ(early.vx[i], 0.0);
    ASSERT_EQ(early.vz[i], 0.0);
  }
}

TEST(Turbulence, ChildrenStartWhereTheParentWasCarried) {
  Preset preset = cloudOf(kAmplitude, false);
  preset.layers[0].count = 20;
  preset.layers[0].lifetime_deviation_s = 0.0;
  preset.layers.emplace_back();
  Layer& child = preset.layers[1];
  child.name = "trail";
  child.parent = preset.layers[0].name;
  child.trigger = Trigger::path;
  child.count = 4;
  child.region_shape = RegionShape::point;
  child.trajectory = Trajectory::linear;
  child.speed_mean_mps = child.speed_deviation_mps = 0.0;
  child.collide = false;
  child.lifetime_mean_s = 50.0;
  const auto explosion = compiled(preset);
  for (int j = 0; j < 4; ++j) {
    const ExactFrame then = exactAt(*explosion, 4.0 * (j + 0.5) / 4);
    for (std::size_t parent = 0; parent < 20; ++parent)
      // A child's place of start is a float.
      EXPECT_LT(length(placeOf(then, 20 + 4 * parent + static_cast<std::size_t>(j)) - placeOf(then, parent)), 1e-5);
  }
}

}  // namespace
}  // namespace npsee
