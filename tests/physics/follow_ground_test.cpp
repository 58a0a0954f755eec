// Layers that flow along the ground, trails of even spacing, blast fronts, and the extent of what is drawn.

#include "tests/support/explosions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace npsee::follow_ground {
namespace {

using test::compiled;
using test::exactAt;

/// Dust thrown flat to all sides.
Preset skirt() {
  Preset preset;
  preset.layers.emplace_back();
  Layer& layer = preset.layers[0];
  layer.count = 300;
  layer.ejection_angle_rad = 1.5;
  layer.angle_distribution = AngleDistribution::uniform;
  layer.speed_mean_mps = 12.0;
  layer.drag_ps = 1.5;
  layer.lifetime_mean_s = 5.0;
  layer.follow_ground = true;
  return preset;
}

/// Rolling land without any level place.
class Waves final : public Ground {
 public:
  double height(double x, double z) const override { return 3.0 + 1.2 * std::sin(0.21 * x) * std::cos(0.17 * z) + 0.05 * x; }
  double detail() const override { return 2.0; }
  bool flat() const override { return false; }
};

TEST(FollowGround, DustStaysLowSpreadsAndSlowsDown) {
  const auto explosion = compiled(skirt());
  double reach_before = 0.0;
  for (const double t : {0.1, 0.5, 1.5, 3.0}) {
    const ExactFrame now = exactAt(*explosion, t);
    double reach = 0.0, speed = 0.0;
    for (std::size_t i = 0; i < now.count; ++i) {
      ASSERT_GE(now.y[i], 0.0);
      // What it was thrown upward is used up by drag: v / k at most.
      ASSERT_LE(now.y[i], 21.0 / 1.5);
      ASSERT_EQ(now.bounces[i], 0);
      reach += std::hypot(now.x[i], now.z[i]);
      speed += std::hypot(now.vx[i], now.vz[i]);
    }
    EXPECT_GT(reach, reach_before);
    // Drag alone slows it along the ground: no contact, no friction.
    EXPECT_NEAR(speed / 300, 12.0 * std::sin(1.5) * std::exp(-1.5 * t) * 0.68, 3.2 * std::exp(-1.5 * t));
    reach_before = reach;
  }
}

TEST(FollowGround, NeitherGravityNorContactParametersMatterButBuoyancyLifts) {
  Preset preset = skirt();
  const ExactFrame before = exactAt(*compiled(preset), 2.0);
  preset.gravity_mps2 = 30.0;
  preset.layers[0].collide = false;
  preset.layers[0].restitution = 0.9;
  EXPECT_EQ(exactAt(*compiled(preset), 2.0).y, before.y);
  preset.layers[0].buoyancy_mps2 = 31.0;
  const ExactFrame lifted = exactAt(*compiled(preset), 2.0);
  // 1 m/s2 against a drag of 1.5 / s for 2 s: (t - (1 - e^{-kt}) / k) / k.
  const double rise = (2.0 - (1.0 - std::exp(-3.0)) / 1.5) / 1.5;
  for (std::size_t i = 0; i < before.count; ++i)
    ASSERT_NEAR(lifted.y[i] - before.y[i], rise, 1e-5) << i;
}

TEST(FollowGround, OverHillsTheBudgetOfMemoryHoldsToo) {
  Preset preset = skirt();
  preset.layers[0].count = 5000;
  const Waves waves;
  const FlatGround flat(0.0);
  for (const Ground* ground : {static_cast<const Ground*>(&waves), static_cast<const Ground*>(&flat)}) {
    CompileOptions options;
    // What is refused by a budget must be able to take it, and what is let in must stay within.
    std::size_t held = 0;
    for (options.max_bytes = 1e4; held == 0 && options.max_bytes < 1e9; options.max_bytes *= 1.25)
      if (const auto explosion = Explosion::compile(preset, {}, ground, options)) held = (*explosion)->memoryBytes();
    EXPECT_GT(held, 0u);
    EXPECT_LE(static_cast<double>(held), options.max_bytes / 1.25);
  }
}

TEST(FollowGround, OverHillsItRisesAndSinksWithTheGround) {
  const Waves ground;
  Preset preset = skirt();
  const auto level = compiled(preset), hills = compiled(preset, &ground);
  for (const double t : {0.0, 0.2, 0.9, 2.0, 4.0}) {
    const ExactFrame a = exactAt(*level, t), b = exactAt(*hills, t);
    for (std::size_t i = 0; i < a.count; ++i) {
      // The same way over the land (its cuts are stored as floats), and nearly the same height above it.
      ASSERT_NEAR(b.x[i], a.x[i], 1e-4);
      ASSERT_NEAR(b.z[i], a.z[i], 1e-4);
      ASSERT_NEAR(b.y[i] - ground.height(b.x[i], b.z[i]), a.y[i], 0.08) << "particle " << i << " at " << t;
      ASSERT_EQ(b.bounces[i], 0);
    }
  }
}

TEST(FollowGround, ItStrikesNoBounces) {
  const Waves ground;
  Preset preset = skirt();
  preset.layers.emplace_back();
  preset.layers[1].name = "sparks";
  preset.layers[1].parent = preset.layers[0].name;
  preset.layers[1].trigger = Trigger::bounce;
  preset.layers[1].count = 1;
  EXPECT_EQ(compiled(preset)->particleCount(), 300u);
  EXPECT_EQ(compiled(preset, &ground)->particleCount(), 300u);
}

/// Trails of pieces that drag slows strongly.
Preset trails(PathSpacing spacing) {
  Preset preset;
  preset.layers.resize(2);
  Layer &parent = preset.layers[0], &child = preset.layers[1];
  parent.count = 6;
  parent.speed_mean_mps = 40.0;
  parent.drag_ps = 1.8;
  parent.lifetime_mean_s = 5.0;
  child.name = "trail";
  child.parent = parent.name;
  child.trigger = Trigger::path;
  child.path_spacing = spacing;
  child.count = 60;
  child.region_shape = RegionShape::point;
  child.trajectory = Trajectory::linear;
  child.collide = false;
  child.speed_mean_mps = child.speed_deviation_mps = 0.0;
  child.lifetime_mean_s = 100.0;
  return preset;
}

/// Largest gap between neighbours of a trail over the mean gap, over all trails.
double worstGap(const Preset& preset) {
  const ExactFrame now = exactAt(*compiled(preset), 30.0);
  double worst = 0.0;
  for (std::size_t trail = 0; trail < 6; ++trail) {
    double sum = 0.0, most = 0.0;
    for (std::size_t j = 1; j < 60; ++j) {
      const std::size_t i = 6 + 60 * trail + j;
      const double gap = length(Vec3{now.x[i], now.y[i], now.z[i]} - Vec3{now.x[i - 1], now.y[i - 1], now.z[i - 1]});
      sum += gap;
      most = std::max(most, gap);
    }
    worst = std::max(worst, most / (sum / 59));
  }
  return worst;
}

TEST(PathSpacing, ByDistanceATrailHasNeitherGapsNorKnots) {
  EXPECT_GT(worstGap(trails(PathSpacing::time)), 3.0);
  EXPECT_LT(worstGap(trails(PathSpacing::distance)), 1.15);
}

TEST(PathSpacing, ChildrenStillStartWhenTheParentIsThere) {
  const auto explosion = compiled(trails(PathSpacing::distance));
  // Each child is born at the moment at which its parent comes by.
  for (double t = 0.05; t < 4.0; t += 0.15) {
    const ExactFrame before = exactAt(*explosion, t - 0.002), now = exactAt(*explosion, t);
    for (std::size_t i = 6; i < now.count; ++i) {
      if (before.alive[i] || !now.alive[i]) continue;
      const std::size_t parent = (i - 6) / 60;
      EXPECT_LT(length(Vec3{now.x[i] - now.x[parent], now.y[i] - now.y[parent], now.z[i] - now.z[parent]}), 0.002 * 45.0);
    }
  }
}

Preset shock() {
  Preset preset = test::onePiece();
  Layer& layer = preset.layers[0];
  layer.form = Form::shock;
  layer.region_shape = RegionShape::point;
  layer.speed_mean_mps = layer.speed_deviation_mps = 0.0;
  layer.size_mean_m = 40.0;
  layer.size_deviation_m = 0.0;
  layer.lifetime_mean_s = 0.8;
  return preset;
}

TEST(Shock, GrowsByTheLawOfAStrongShockThenEvenly) {
  const auto explosion = compiled(shock());
  const auto radius = [&](double u) { return 0.5 * exactAt(*explosion, 0.8 * u).size[0]; };
  // Far from the end the radius grows with the 2/5th power of time.
  for (const double u : {0.02, 0.05, 0.1}) EXPECT_NEAR(radius(2.0 * u) / radius(u), std::pow(2.0, 0.4), 0.01) << u;
  // Later at one speed, the one that it had there.
  EXPECT_NEAR(radius(0.6) - radius(0.5), radius(0.9) - radius(0.8), 1e-6);
  EXPECT_NEAR((radius(0.25) - radius(0.22)) / 0.03, (radius(0.9) - radius(0.8)) / 0.1, 1.0);
  EXPECT_NEAR(radius(1.0 - 1e-9), 20.0, 1e-4);
}

TEST(Shock, FadesFastAndKeepsCurvesThatAreGiven) {
  Preset preset = shock();
  const auto explosion = compiled(preset);
  EXPECT_NEAR(exactAt(*explosion, 0.0).a[0], 1.0, 1e-12);
  EXPECT_NEAR(exactAt(*explosion, 0.4).a[0], 0.25, 1e-3);
  EXPECT_LT(exactAt(*explosion, 0.72).a[0], 0.02);
  preset.layers[0].size_over_life = {{0.0, 1.0}, {1.0, 1.0}};
  preset.layers[0].opacity_over_life = {{0.0, 0.5}, {1.0, 0.5}};
  const ExactFrame now = exactAt(*compiled(preset), 0.4);
  EXPECT_EQ(now.size[0], 40.0);
  EXPECT_EQ(now.a[0], 0.5);
}

/// A dense cloud with splinters that fly far.
Preset cloudWithSplinters() {
  Preset preset;
  preset.layers.resize(2);
  Layer &cloud = preset.layers[0], &splinters = preset.layers[1];
  cloud.name = "cloud";
  cloud.form = Form::smoke;
  cloud.count = 80;
  cloud.speed_mean_mps = 3.0;
  cloud.drag_ps = 1.0;
  cloud.size_mean_m = 5.0;
  splinters.name = "splinters";
  splinters.count = 100;
  splinters.size_mean_m = 0.2;
  splinters.speed_mean_mps = 60.0;
  return preset;
}

TEST(Extent, FollowsWhatIsDrawnNotWhatFliesFarOrIsInvisible) {
  const auto explosion = compiled(cloudWithSplinters());
  EXPECT_LT(explosion->extent().radius_m(), 18.0);
  // But the reach holds the splinters too.
  EXPECT_GT(explosion->extent().reach_m, 60.0);
  Preset preset = cloudWithSplinters();
  preset.layers[1].size_mean_m = 30.0;
  const double with = compiled(preset)->extent().radius_m();
  preset.layers[1].opacity = 0.0;
  EXPECT_LT(compiled(preset)->extent().radius_m(), 0.5 * with);
}

TEST(Extent, HoldsTheSizeOfWhatIsDrawn) {
  Preset preset = test::onePiece();
  Layer& layer = preset.layers[0];
  layer.region_shape = RegionShape::point;
  layer.form = Form::sphere;
  layer.speed_mean_mps = layer.speed_deviation_mps = 0.0;
  layer.size_mean_m = 8.0;
  layer.size_deviation_m = 0.0;
  const Extent extent = compiled(preset)->extent();
  EXPECT_NEAR(extent.max.x, 4.0, 1e-6);
  EXPECT_NEAR(extent.min.z, -4.0, 1e-6);
  EXPECT_NEAR(extent.max.y, 4.0, 1e-6);
  EXPECT_EQ(extent.min.y, 0.0) << "what is under the ground is not drawn";
}

TEST(Extent, DoesNotHoldWhatSinksIntoTheGround) {
  Preset preset = cloudWithSplinters();
  preset.layers.pop_back();
  preset.layers[0].collide = false;
  preset.layers[0].lifetime_mean_s = 4.0;
  const Extent extent = compiled(preset)->extent();
  EXPECT_EQ(extent.min.y, 0.0);
  EXPECT_LT(extent.radius_m(), 12.0) << "it falls some 20 m below";
}

TEST(Extent, TheReachHoldsEveryParticleAtAnyTimeWithTurbulenceToo) {
  Preset preset = cloudWithSplinters();
  for (Layer& layer : preset.layers) layer.turbulence_m = 5.0;
  const auto explosion = compiled(preset);
  const Extent& extent = explosion->extent();
  for (double t = 0.0; t < 7.0; t += 0.1) {
    const ExactFrame now = exactAt(*explosion, t);
    for (std::size_t i = 0; i < now.count; ++i)
      ASSERT_LE(now.bounces[i] < 2 ? length(Vec3{now.x[i], now.y[i], now.z[i]} - extent.centre()) : 0.0, extent.reach_m + 0.5);
  }
}

}  // namespace
}  // namespace npsee::follow_ground
