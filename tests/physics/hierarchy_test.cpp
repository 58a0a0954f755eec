#include "tests/support/explosions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace npsee {
namespace {

using test::compiled;
using test::exactAt;

/// Three pieces, and a child layer that starts at the parent's event without speed of its own.
Preset pair(Trigger trigger, std::int64_t children) {
  Preset preset;
  preset.layers.resize(2);
  Layer &parent = preset.layers[0], &child = preset.layers[1];
  parent.count = 3;
  parent.lifetime_deviation_s = 0.0;
  parent.lifetime_mean_s = 4.0;
  child.name = "child";
  child.parent = "fragments";
  child.trigger = trigger;
  child.count = children;
  child.region_shape = RegionShape::point;
  child.speed_mean_mps = child.speed_deviation_mps = 0.0;
  child.trajectory = Trajectory::linear;
  child.lifetime_mean_s = 50.0;
  child.lifetime_deviation_s = 0.0;
  return preset;
}

TEST(Hierarchy, ChildrenOfABirthStartWhereAndWhenTheParentDoes) {
  const auto explosion = compiled(pair(Trigger::birth, 2));
  ASSERT_EQ(explosion->particleCount(), 9u);
  const ExactFrame now = exactAt(*explosion, 0.0);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(now.alive[3 + i], 1);
    EXPECT_NEAR(now.x[3 + i], now.x[i / 2], 1e-6);
  }
}

TEST(Hierarchy, ChildrenOfADeathStartThereWithTheInheritedVelocity) {
  Preset preset = pair(Trigger::death, 1);
  preset.layers[0].lifetime_mean_s = 1.0;
  preset.layers[1].inherit_velocity = 0.5;
  const auto explosion = compiled(preset);
  EXPECT_EQ(exactAt(*explosion, 0.999).alive[3], 0);
  const ExactFrame now = exactAt(*explosion, 1.0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(now.alive[i], 0);
    EXPECT_EQ(now.alive[3 + i], 1);
    EXPECT_NEAR(now.x[3 + i], now.x[i], 1e-5);
    EXPECT_NEAR(now.y[3 + i], now.y[i], 1e-5);
    EXPECT_NEAR(now.vx[3 + i], 0.5 * now.vx[i], 1.2e-7 * std::abs(now.vx[i]));  // a launch's velocity along the ground is a float
    EXPECT_NEAR(now.vy[3 + i], 0.5 * now.vy[i], 1e-12);
  }
}

TEST(Hierarchy, ChildrenOfBouncesStartAtEachContact) {
  Preset preset = pair(Trigger::bounce, 1);
  preset.layers[0].lifetime_mean_s = 60.0;
  const auto explosion = compiled(preset);
  const ExactFrame end = exactAt(*explosion, 30.0);
  const std::size_t contacts = std::size_t{end.bounces[0]} + end.bounces[1] + end.bounces[2];
  ASSERT_EQ(explosion->particleCount(), 3 + contacts);
  // Each child lies on the ground from the moment its parent's count goes up.
  std::size_t child = 3;
  for (std::size_t parent = 0; parent < 3; ++parent)
    for (int n = 1; n <= end.bounces[parent]; ++n, ++child) {
      EXPECT_EQ(end.y[child], 0.0);
      double low = 0.0, high = 30.0;
      for (int k = 0; k < 60; ++k) (exactAt(*explosion, 0.5 * (low + high)).alive[child] ? high : low) = 0.5 * (low + high);
      EXPECT_EQ(exactAt(*explosion, high).bounces[parent], n);
      EXPECT_EQ(exactAt(*explosion, high - 1e-6).bounces[parent], n - 1);
      EXPECT_NEAR(exactAt(*explosion, high).x[child], exactAt(*explosion, high).x[parent], 1e-4);
    }
}

TEST(Hierarchy, ChildrenAlongThePathLieOnIt) {
  Preset preset = pair(Trigger::path, 8);
  preset.layers[0].lifetime_mean_s = 2.0;
  const auto explosion = compiled(preset);
  for (int j = 0; j < 8; ++j) {
    const double t = 2.0 * (j + 0.5) / 8;
    const ExactFrame then = exactAt(*explosion, t);
    for (std::size_t parent = 0; parent < 3; ++parent) {
      const std::size_t child = 3 + 8 * parent + static_cast<std::size_t>(j);
      EXPECT_EQ(then.alive[child], 1);
      EXPECT_EQ(exactAt(*explosion, t - 1e-9).alive[child], 0);
      EXPECT_NEAR(then.x[child], then.x[parent], 1e-5);
      EXPECT_NEAR(then.y[child], then.y[parent], 1e-5);
    }
  }
}

TEST(Hierarchy, ADisabledParentStartsNoChildren) {
  Preset preset = pair(Trigger::birth, 2);
  preset.layers[0].enabled = false;
  EXPECT_EQ(compiled(preset)->particleCount(), 0u);
}

TEST(Hierarchy, AChildMayStandBeforeItsParentInTheList) {
  Preset preset = pair(Trigger::birth, 2);
  std::swap(preset.layers[0], preset.layers[1]);
  const auto explosion = compiled(preset);
  ASSERT_EQ(explosion->layers().size(), 2u);
  EXPECT_EQ(explosion->layers()[0].name, "child");
  EXPECT_EQ(explosion->layers()[0].count, 6u);
}

TEST(Hierarchy, OtherLayersComingAndGoingChangeNothingInALayer) {
  Preset alone;
  alone.layers.resize(1);
  Preset together = alone;
  together.layers.insert(together.layers.begin(), Layer{});
  together.layers[0].name = "new";
  const auto a = compiled(alone), b = compiled(together);
  const ExactFrame fa = exactAt(*a, 1.0), fb = exactAt(*b, 1.0);
  const std::size_t first = b->layers()[1].first;
  for (std::size_t i = 0; i < fa.count; ++i) {
    ASSERT_EQ(fa.x[i], fb.x[first + i]);
    ASSERT_NE(fa.x[i], fb.x[i]);
  }
}

TEST(Hierarchy, RenamingALayerKeepsItsPicture) {
  Preset preset;
  preset.layers.resize(1);
  const ExactFrame before = exactAt(*compiled(preset), 1.0);
  ASSERT_TRUE(renameLayer(preset, 0, "steel"));
  EXPECT_EQ(exactAt(*compiled(preset), 1.0).x, before.x);
}

TEST(Hierarchy, EachChildDrawsItsOwnNumbers) {
  Preset preset = pair(Trigger::birth, 1);
  preset.layers[1].speed_mean_mps = 10.0;
  const ExactFrame now = exactAt(*compiled(preset), 0.0);
  EXPECT_NE(now.vx[3], now.vx[4]);
  EXPECT_NE(now.vy[4], now.vy[5]);
}

}  // namespace
}  // namespace npsee
