#include "tests/world/terrain_support.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace npsee {
namespace {

using test::Numbers;
using test::terrain;

TEST(Terrain, GridPointsHaveTheirSamplesHeightsAndCentresTheMean) {
  const Terrain ground = terrain(test::hills(1, 100.0), 5000.0, 3000.0);
  ASSERT_EQ(ground.columns(), 51);
  ASSERT_EQ(ground.rows(), 31);
  EXPECT_EQ((ground.columns() - 1) * ground.cellX(), ground.sizeX());
  const auto sample = [&](int c, int r) { return static_cast<double>(ground.heights()[static_cast<std::size_t>(r * ground.columns() + c)]); };
  for (int r = 0; r < 30; ++r)
    for (int c = 0; c < 50; ++c) {
      EXPECT_EQ(ground.height(100.0 * c, 100.0 * r), sample(c, r));
      EXPECT_NEAR(ground.height(100.0 * c + 50.0, 100.0 * r + 50.0), 0.25 * (sample(c, r) + sample(c + 1, r) + sample(c, r + 1) + sample(c + 1, r + 1)), 1e-9);
    }
  EXPECT_EQ(ground.height(5000.0, 3000.0), sample(50, 30));
  EXPECT_EQ(ground.height(9000.0, -10.0), sample(50, 0));
}

TEST(Terrain, NormalIsThatOfTheSurfaceAndPointsUp) {
  const Terrain ground = terrain(test::hills(1, 50.0), 5000.0, 5000.0);
  Numbers random(3);
  for (int i = 0; i < 500; ++i) {
    const double x = 50.0 * std::floor(random.between(0, 100)) + random.between(1, 49), z = 50.0 * std::floor(random.between(0, 100)) + random.between(1, 49);
    const Vec3 n = ground.normal(x, z);
    EXPECT_NEAR(length(n), 1.0, 1e-12);
    EXPECT_NEAR(-n.x / n.y, (ground.height(x + 0.5, z) - ground.height(x - 0.5, z)), 1e-6);
    EXPECT_NEAR(-n.z / n.y, (ground.height(x, z + 0.5) - ground.height(x, z - 0.5)), 1e-6);
  }
  EXPECT_EQ(ground.normal(-10.0, 100.0).x, 0.0);
}

TEST(Terrain, FlatIsFlatAndMayLieUnderTheSea) {
  TerrainSource source;
  source.height_m = -7.0;
  const Terrain ground = terrain(source, 1000.0, 2000.0, 3.0);
  EXPECT_TRUE(ground.flat());
  EXPECT_EQ(ground.height(123.0, 456.0), -7.0);
  EXPECT_TRUE(ground.sea(123.0, 456.0));
  EXPECT_EQ(ground.surface(123.0, 456.0), 3.0);
  EXPECT_EQ(ground.seaLevel(), 3.0);
  EXPECT_TRUE(ground.inside(1000.0, 0.0));
  EXPECT_FALSE(ground.inside(0.0, 2000.1));
}

TEST(Terrain, RidgeHasItsFeetAndItsCrestExactly) {
  const Terrain ground = terrain(test::function("ridge", {{"crest_x", 25000}, {"crest_height", 200}, {"foot_before", 400}, {"foot_after", 300}}), 50000.0, 50000.0);
  for (const double z : {0.0, 12345.6, 50000.0}) {
    EXPECT_EQ(ground.height(25000.0, z), 200.0);
    EXPECT_EQ(ground.height(24600.0, z), 0.0);
    EXPECT_EQ(ground.height(25300.0, z), 0.0);
    EXPECT_NEAR(ground.height(24750.0, z), 75.0, 1e-9);
    EXPECT_NEAR(ground.height(25100.0, z), 200.0 * 2.0 / 3.0, 1e-4);
    EXPECT_EQ(ground.height(100.0, z), 0.0);
  }
  EXPECT_EQ(ground.highest(), 200.0);
}

TEST(Terrain, FunctionsAreWhatTheirParametersSayAtAnyOffset) {
  // Bends off round numbers, along both axes.
  const Terrain across = terrain(test::function("ridge", {{"crest_z", 1003.25}, {"crest_height", 40}, {"foot_before", 10.5}, {"foot_after", 9.75}, {"base_height", 5}}, "x"), 3000.0, 2000.0);
  EXPECT_NEAR(across.height(77.0, 1003.25), 40.0, 1e-6);
  EXPECT_NEAR(across.height(77.0, 1003.25 - 10.5), 5.0, 1e-6);
  EXPECT_NEAR(across.height(2000.0, 1003.25 + 9.75 / 2), 22.5, 1e-4);
  const Terrain slope = terrain(test::function("slope", {{"from", 500}, {"to", 1500}, {"low", -10}, {"high", 90}}), 2000.0, 2000.0);
  EXPECT_NEAR(slope.height(100.0, 3.0), -10.0, 1e-9);
  EXPECT_NEAR(slope.height(1000.0, 3.0), 40.0, 1e-5);
  EXPECT_NEAR(slope.height(1900.0, 3.0), 90.0, 1e-9);
  const Terrain step = terrain(test::function("step", {{"at", 700}, {"high", 30}}), 2000.0, 2000.0);
  EXPECT_NEAR(step.height(699.5, 10.0), 0.0, 1e-9);
  EXPECT_NEAR(step.height(700.5, 10.0), 30.0, 1e-9);
  const Terrain plane = terrain(test::function("plane", {{"height", 10}, {"slope_x", 0.1}, {"slope_z", -0.05}}), 2000.0, 1000.0);
  EXPECT_NEAR(plane.height(333.0, 777.0), 10.0 + 33.3 - 38.85, 1e-4);
  const Terrain cone = terrain(test::function("cone", {{"top_x", 1000}, {"top_z", 1000}, {"top_height", 100}, {"radius", 500}}), 2000.0, 2000.0);
  EXPECT_NEAR(cone.height(1000.0, 1250.0), 50.0, 0.5);
  EXPECT_EQ(cone.height(1000.0, 1600.0), 0.0);
}

TEST(Terrain, HillsHaveTheSeaAndTheReliefAskedFor) {
  for (const double share : {0.0, 0.1, 0.4}) {
    TerrainSource source = test::hills(11, 60.0);
    source.sea_fraction = share;
    source.relief_m = 300.0;
    const Terrain ground = terrain(source, 30000.0, 20000.0, 50.0);
    std::vector<float> land(ground.heights().begin(), ground.heights().end());
    const auto wet = std::count_if(land.begin(), land.end(), [](float h) { return h < 50.0f; });
    EXPECT_NEAR(static_cast<double>(wet) / static_cast<double>(land.size()), share, 0.02);
    std::sort(land.begin(), land.end());
    // The highest half per cent of the land stands over the relief; the frame around the world takes part in the scale.
    EXPECT_NEAR(land[land.size() * 995 / 1000] - 50.0, 300.0, 60.0);
  }
}

TEST(Terrain, HillsAreSmoothCountryAtTheirCells) {
  const Terrain ground = terrain(test::hills(21, 30.0), 9000.0, 9000.0);
  double steepest = 0.0, bend = 0.0;
  for (double z = 60.0; z < 8900.0; z += 60.0)
    for (double x = 60.0; x < 8900.0; x += 30.0) {
      const double west = ground.height(x - 30.0, z), here = ground.height(x, z), east = ground.height(x + 30.0, z);
      steepest = std::max(steepest, std::fabs(east - here) / 30.0);
      bend = std::max(bend, std::fabs(west - 2.0 * here + east) / 30.0);
    }
  EXPECT_LT(steepest, 0.6);
  EXPECT_LT(bend, 0.25);
  EXPECT_GT(steepest, 0.1);
}

TEST(Terrain, AnotherSeedIsAnotherCountryAndTheSameSeedTheSame) {
  const auto equal = [](const Terrain& a, const Terrain& b) { return std::equal(a.heights().begin(), a.heights().end(), b.heights().begin(), b.heights().end()); };
  const Terrain one = terrain(test::hills(1, 60.0), 8000.0, 8000.0);
  EXPECT_TRUE(equal(one, terrain(test::hills(1, 60.0), 8000.0, 8000.0)));
  for (const std::int64_t seed : {std::int64_t{2}, std::int64_t{-1}, (std::int64_t{1} << 40) + 1}) EXPECT_FALSE(equal(one, terrain(test::hills(seed, 60.0), 8000.0, 8000.0))) << seed;
}

TEST(Terrain, HillsHaveTheSameBitsOnAnyNumberOfThreads) {
  const auto one = Terrain::make(test::hills(9, 60.0), 9000.0, 12000.0, 0.0, 1);
  ASSERT_TRUE(one);
  for (const int threads : {2, 3, 8}) {
    const auto many = Terrain::make(test::hills(9, 60.0), 9000.0, 12000.0, 0.0, threads);
    ASSERT_TRUE(many);
    ASSERT_EQ(one->heights().size(), many->heights().size());
    EXPECT_EQ(std::memcmp(one->heights().data(), many->heights().data(), one->heights().size_bytes()), 0) << threads;
  }
}

TEST(Terrain, HillsOfEveryExtremeAreFinite) {
  for (const double scale : {100.0, 6000.0, 1e6})
    for (const double size : {20.0, 1500.0})
      for (const double valley : {0.0, 1.0}) {
        TerrainSource source = test::hills(3);
        source.scale_m = scale;
        source.valley = valley;
        source.sea_fraction = 0.9;
        const Terrain ground = terrain(source, size, 2.0 * size);
        EXPECT_TRUE(std::isfinite(ground.lowest()) && std::isfinite(ground.highest())) << scale << " " << size;
        EXPECT_GT(ground.highest(), ground.lowest());
      }
}

TEST(Terrain, ProfileRunsFromEndToEnd) {
  const Terrain ground = terrain(test::hills(2, 50.0), 10000.0, 10000.0, 20.0);
  const auto profile = ground.profile({1000.0, 0.0, 2000.0}, {4000.0, 0.0, 6000.0}, 101);
  ASSERT_EQ(profile.size(), 101u);
  EXPECT_EQ(profile.front().x, 1000.0);
  EXPECT_NEAR(profile.back().z, 6000.0, 1e-9);
  EXPECT_NEAR(profile.back().distance_m, 5000.0, 1e-9);
  for (const ProfilePoint& p : profile) {
    EXPECT_EQ(p.ground_m, ground.height(p.x, p.z));
    EXPECT_EQ(p.surface_m, ground.surface(p.x, p.z));
  }
  EXPECT_EQ(ground.profile({}, {}, -5).size(), 2u);
}

TEST(Terrain, CopiesShareTheirSamples) {
  const Terrain ground = terrain(test::hills(2, 50.0), 10000.0, 10000.0);
  const Terrain copy = ground;  // NOLINT: the copy is the point
  EXPECT_EQ(copy.heights().data(), ground.heights().data());
}

TEST(Terrain, WithoutASourceIsALevelSquareKilometre) {
  const Terrain ground;
  EXPECT_TRUE(ground.flat());
  EXPECT_EQ(ground.sizeX(), 1000.0);
  EXPECT_EQ(ground.height(500.0, 500.0), 0.0);
  EXPECT_TRUE(ground.sight({0.0, 1.0, 0.0}, {1000.0, 1.0, 1000.0}).clear);
}

TEST(Terrain, KindsHaveNames) {
  for (const TerrainKind kind : {TerrainKind::flat, TerrainKind::hills, TerrainKind::function, TerrainKind::hgt, TerrainKind::png}) EXPECT_EQ(terrainKindFrom(terrainKindName(kind)), kind);
  EXPECT_FALSE(terrainKindFrom("mountains").has_value());
}

}  // namespace
}  // namespace npsee
