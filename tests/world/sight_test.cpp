#include "tests/world/terrain_support.h"

#include <algorithm>
#include <cmath>

namespace npsee {
namespace {

using test::Numbers;
using test::terrain;

/// Least clearance by sampling the ground every `step` metres along the ray.
double sampledClearance(const Terrain& ground, const Vec3& a, const Vec3& b, double step) {
  const double dx = b.x - a.x, dz = b.z - a.z, distance = std::sqrt(dx * dx + dz * dz);
  const int n = std::max(1, static_cast<int>(std::ceil(distance / step)));
  double least = INFINITY;
  for (int i = 0; i <= n; ++i) {
    const Vec3 p = a + (static_cast<double>(i) / n) * (b - a);
    least = std::min(least, p.y - ground.height(p.x, p.z));
  }
  return least;
}

Vec3 overGround(const Terrain& ground, double x, double z, double above) { return {x, ground.height(x, z) + above, z}; }

TEST(Sight, AgreesWithSamplingEveryQuarterMetreOnRandomTerrain) {
  Numbers random(7);
  int clear = 0;
  for (int map = 0; map < 4; ++map) {
    auto source = test::hills(map + 1, 30.0);
    source.scale_m = 1500.0;
    const Terrain ground = terrain(source, 8000.0, 6000.0);
    for (int i = 0; i < 500; ++i) {
      const Vec3 a = overGround(ground, random.between(0.0, 8000.0), random.between(0.0, 6000.0), random.between(0.5, 20.0));
      const Vec3 b = overGround(ground, std::clamp(a.x + random.between(-2500.0, 2500.0), 0.0, 8000.0), std::clamp(a.z + random.between(-2500.0, 2500.0), 0.0, 6000.0), random.between(0.5, 20.0));
      const Sight sight = ground.sight(a, b);
      const double sampled = sampledClearance(ground, a, b, 0.25);
      // Sampling can only miss the lowest point: the slope of the ground times half a step bounds by how much.
      EXPECT_LE(sight.clearance_m, sampled + 1e-9);
      EXPECT_GE(sight.clearance_m, sampled - 0.125);
      if (std::fabs(sampled) > 0.01) {
        EXPECT_EQ(sight.clear, sampled > 0.0) << "ray " << i << " of map " << map << ", clearance " << sight.clearance_m << " against " << sampled;
      }
      EXPECT_EQ(ground.sees(a, b), sight.clear);
      clear += sight.clear ? 1 : 0;
    }
  }
  // The test means something only if both happen often.
  EXPECT_GT(clear, 300);
  EXPECT_LT(clear, 1700);
}

TEST(Sight, TheWorstPointIsWhereTheClearanceIs) {
  const Terrain ground = terrain(test::hills(3, 30.0), 9000.0, 9000.0);
  Numbers random(11);
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = overGround(ground, random.between(0, 9000), random.between(0, 9000), 2.0), b = overGround(ground, random.between(0, 9000), random.between(0, 9000), 2.0);
    const Sight sight = ground.sight(a, b);
    const double dx = b.x - a.x, dz = b.z - a.z, share = sight.worst_m / std::sqrt(dx * dx + dz * dz);
    const Vec3 p = a + share * (b - a);
    EXPECT_NEAR(p.y - ground.height(p.x, p.z), sight.clearance_m, 1e-7);
  }
}

TEST(Sight, IsTheSameFromBothEndsToTheBit) {
  const Terrain ground = terrain(test::hills(5, 40.0), 12000.0, 12000.0);
  Numbers random(13);
  for (int i = 0; i < 2000; ++i) {
    // Ends outside the world, too.
    const Vec3 a = overGround(ground, random.between(-1000, 13000), random.between(-1000, 13000), random.between(0, 10));
    const Vec3 b = overGround(ground, random.between(-1000, 13000), random.between(-1000, 13000), random.between(0, 10));
    const Sight there = ground.sight(a, b), back = ground.sight(b, a);
    EXPECT_EQ(there.clear, back.clear);
    EXPECT_EQ(there.clearance_m, back.clearance_m);
    EXPECT_EQ(ground.sees(a, b), there.clear);
    EXPECT_EQ(ground.sees(b, a), there.clear);
    const double dx = b.x - a.x, dz = b.z - a.z;
    EXPECT_NEAR(there.worst_m + back.worst_m, std::sqrt(dx * dx + dz * dz), 1e-6);
  }
}

TEST(Sight, AlongGridLinesAndThroughCornersAgreesWithSampling) {
  const Terrain ground = terrain(test::hills(2, 50.0), 5000.0, 5000.0);
  Numbers random(17);
  const auto line = [&] { return 50.0 * std::floor(random.between(0.0, 101.0)); };
  for (int i = 0; i < 500; ++i) {
    const double x = line(), z = line(), far = line();
    const int kind = i % 4;
    const double reach = std::min({far, 5000.0 - x, 5000.0 - z});
    const Vec3 a = overGround(ground, x, z, 3.0);
    const Vec3 b = kind == 0 ? overGround(ground, far, z, 3.0) : kind == 1 ? overGround(ground, x, far, 3.0) : kind == 2 ? overGround(ground, x + reach, z + reach, 3.0) : overGround(ground, x, z, 9.0);
    const double sampled = sampledClearance(ground, a, b, 0.25);
    const Sight sight = ground.sight(a, b);
    EXPECT_LE(sight.clearance_m, sampled + 1e-9);
    EXPECT_GE(sight.clearance_m, sampled - 0.125);
  }
}

/// Scenario G's ridge: 20 m wide at its foot, 40 m high.
Terrain narrowRidge() {
  return terrain(test::function("ridge", {{"crest_x", 25000}, {"crest_height", 40}, {"foot_before", 10}, {"foot_after", 10}}), 50000.0, 50000.0);
}

/// Breadth of that ridge along a ray that passes its crest at a height.
double breadthAt(double height_m) { return 20.0 * (1.0 - height_m / 40.0); }

TEST(Sight, ANarrowRidgeHidesWhatTheSampledTestSees) {
  const Terrain ground = narrowRidge();
  EXPECT_LT(ground.heights().size(), 1'000'000u);
  Numbers random(19);
  int seen_by_samples = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 eye{random.between(22000.0, 24900.0), 2.5, random.between(24000.0, 26000.0)};
    const Vec3 target{eye.x + random.between(3500.0, 4000.0), 1.5, random.between(24000.0, 26000.0)};
    if (target.x < 25020.0) continue;
    const Sight sight = ground.sight(eye, target);
    EXPECT_FALSE(sight.clear);
    // Blocked by the whole height of the crest, at the crest.
    const double share = (25000.0 - eye.x) / (target.x - eye.x);
    EXPECT_NEAR(sight.clearance_m, eye.y + share * (target.y - eye.y) - 40.0, 1e-6);
    seen_by_samples += ground.sightSampled(eye, target) ? 1 : 0;
  }
  EXPECT_GT(seen_by_samples, 100);
}

TEST(Sight, SamplesMissARidgeByItsBreadthOverTheirSpacing) {
  // Along a ray of random length the samples lie at random about the ridge, so one of them meets it with a chance of its breadth at the
  // ray's height over the spacing, whatever the distance: level rays at heights from the foot to the crest.
  const Terrain ground = narrowRidge();
  for (const double height : {1.0, 2.5, 10.0, 20.0, 30.0, 39.0}) {
    Numbers random(23);
    int seen = 0;
    constexpr int kRays = 4000;
    double expected = 0.0;
    for (int i = 0; i < kRays; ++i) {
      const double before = random.between(300.0, 2000.0), after = random.between(300.0, 2000.0);
      const Vec3 eye{25000.0 - before, height, 25000.0}, target{25000.0 + after, height, 25000.0};
      seen += ground.sightSampled(eye, target) ? 1 : 0;
      EXPECT_FALSE(ground.sees(eye, target));
      expected += 1.0 - breadthAt(height) / ((before + after) / std::ceil((before + after) / 40.0));
    }
    // Four standard deviations of a count of 4,000.
    EXPECT_NEAR(seen, expected, 4.0 * std::sqrt(0.25 * kRays)) << height;
  }
}

TEST(Sight, TheSampledTestTakesNoMoreThanAHundredPlacesFortyMetresApart) {
  // A wall 1 m wide, met by a sample only where one is.
  const auto met = [](double wall, double distance) {
    const Terrain ground = terrain(test::function("ridge", {{"crest_x", wall}, {"crest_height", 40}, {"foot_before", 0.5}, {"foot_after", 0.5}}), 12000.0, 1000.0);
    return !ground.sightSampled({0.0, 2.0, 500.0}, {distance, 2.0, 500.0});
  };
  EXPECT_TRUE(met(400.0, 2000.0));
  EXPECT_FALSE(met(420.0, 2000.0));
  EXPECT_TRUE(met(400.0, 4000.0));
  EXPECT_FALSE(met(420.0, 4000.0));
  // A hundred places cut 10.1 km into 101 pieces of 100 m.
  EXPECT_TRUE(met(1000.0, 10100.0));
  EXPECT_FALSE(met(1040.0, 10100.0));
  // Nothing lies between nearer ones.
  EXPECT_FALSE(met(20.0, 40.0));
}

TEST(Sight, AnEyeOrATargetBelowTheGroundIsBlocked) {
  const Terrain ground = terrain(test::hills(1, 80.0), 20000.0, 20000.0);
  const Vec3 high{10000.0, 2000.0, 10000.0};
  for (const double depth : {0.01, 1.0, 100.0}) {
    const Vec3 below = overGround(ground, 4000.0, 7000.0, -depth);
    const Sight up = ground.sight(below, high), down = ground.sight(high, below);
    EXPECT_FALSE(up.clear);
    EXPECT_FALSE(down.clear);
    EXPECT_LE(up.clearance_m, -depth + 1e-9);
    EXPECT_GE(up.worst_m, 0.0);
  }
  EXPECT_TRUE(ground.sight(overGround(ground, 4000.0, 7000.0, 0.0), overGround(ground, 4000.0, 7000.0, 500.0)).clear);
}

TEST(Sight, PointsPutOnLevelGroundSeeEachOther) {
  TerrainSource source;
  source.height_m = 12.5;
  const Terrain ground = terrain(source, 1000.0, 1000.0);
  EXPECT_TRUE(ground.sight({10.0, 12.5, 20.0}, {900.0, 12.5, 700.0}).clear);
  EXPECT_TRUE(ground.sight({10.0, 12.5, 20.0}, {10.0, 12.5, 20.0}).clear);
  EXPECT_FALSE(ground.sight({10.0, 12.4, 20.0}, {900.0, 20.0, 700.0}).clear);
}

TEST(Sight, OutsideTheWorldTheEdgeGoesOnLevel) {
  const Terrain ground = terrain(test::hills(4, 40.0), 4000.0, 4000.0);
  Numbers random(23);
  for (int i = 0; i < 300; ++i) {
    const Vec3 a = overGround(ground, random.between(-3000, 7000), random.between(-3000, 7000), random.between(1, 30));
    const Vec3 b = overGround(ground, random.between(-3000, 7000), random.between(-3000, 7000), random.between(1, 30));
    const double sampled = sampledClearance(ground, a, b, 0.5);
    const double exact = ground.sight(a, b).clearance_m;
    EXPECT_LE(exact, sampled + 1e-9);
    EXPECT_GE(exact, sampled - 0.25);
  }
  EXPECT_TRUE(ground.sight({-1e9, 5000.0, -1e9}, {1e9, 5000.0, 1e9}).clear);
}

TEST(Sight, WhatIsNoNumberIsNeverSeen) {
  const Terrain ground = terrain(test::hills(4, 80.0), 4000.0, 4000.0);
  EXPECT_FALSE(ground.sight({NAN, 9000.0, 0.0}, {1.0, 9000.0, 1.0}).clear);
  EXPECT_FALSE(ground.sight({0.0, 9000.0, 0.0}, {1.0, INFINITY, 1.0}).clear);
  EXPECT_FALSE(ground.sightSampled({0.0, 9000.0, 0.0}, {1.0, NAN, 1.0}));
  EXPECT_FALSE(ground.raycast({0.0, 9000.0, 0.0}, {0.0, NAN, 0.0}, 1e4).has_value());
  EXPECT_FALSE(ground.raycast({0.0, 9000.0, 0.0}, {0.0, 0.0, 0.0}, 1e4).has_value());
  EXPECT_FALSE(ground.raycast({0.0, 9000.0, 0.0}, {0.0, -1.0, 0.0}, NAN).has_value());
  EXPECT_TRUE(std::isfinite(ground.height(NAN, -INFINITY)));
  EXPECT_FALSE(ground.sees({NAN, 9000.0, 0.0}, {1.0, 9000.0, 1.0}));
}

TEST(Raycast, FirstHitIsOnTheGroundAndNothingBeforeItIs) {
  const Terrain ground = terrain(test::hills(6, 30.0), 6000.0, 6000.0);
  Numbers random(29);
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 from = overGround(ground, random.between(0, 6000), random.between(0, 6000), random.between(1, 300));
    const Vec3 direction{random.between(-1, 1), random.between(-0.3, 0.05), random.between(-1, 1)};
    const auto hit = ground.raycast(from, direction, 3000.0);
    const double reach = hit ? length(*hit - from) : 3000.0;
    const Vec3 unit = (1.0 / length(direction)) * direction;
    for (double s = 0.0; s < reach - 0.01; s += 0.5) {
      const Vec3 p = from + s * unit;
      ASSERT_GT(p.y - ground.height(p.x, p.z), -1e-6) << "passes through the ground " << s << " m on";
    }
    if (!hit) continue;
    ++hits;
    EXPECT_NEAR(length(cross(*hit - from, unit)), 0.0, 1e-6);
    EXPECT_EQ(hit->y, ground.height(hit->x, hit->z));
  }
  EXPECT_GT(hits, 150);
}

TEST(Raycast, StraightDownFindsTheGroundAndAStartOnTheGroundMayLeaveIt) {
  const Terrain ground = terrain(test::hills(6, 30.0), 6000.0, 6000.0);
  const auto hit = ground.raycast({1234.0, 900.0, 4321.0}, {0.0, -2.0, 0.0}, 5000.0);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->y, ground.height(1234.0, 4321.0));
  EXPECT_FALSE(ground.raycast({1234.0, 900.0, 4321.0}, {0.0, -1.0, 0.0}, 100.0).has_value());
  const Vec3 on = overGround(ground, 1234.0, 4321.0, 0.0);
  EXPECT_FALSE(ground.raycast(on, {0.0, 1.0, 0.0}, 5000.0).has_value());
  EXPECT_TRUE(ground.raycast(on, {0.0, -1.0, 0.0}, 5000.0).has_value());
  const auto buried = ground.raycast(overGround(ground, 1234.0, 4321.0, -5.0), {0.0, 1.0, 0.0}, 5000.0);
  ASSERT_TRUE(buried);
  EXPECT_EQ(buried->y, ground.height(1234.0, 4321.0));
}

}  // namespace
}  // namespace npsee
