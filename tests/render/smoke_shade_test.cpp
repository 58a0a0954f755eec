#include "app/render/smoke_shade.h"

#include "app/render/smoke_shadow.h"
#include "tests/support/rendering.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace npsee::render {
namespace {

using test::brightness;

const Vec3 kUp{0.0, 1.0, 0.0};
const Vec3 kSun{-0.5263, 0.7105, 0.4671};

/// A ball of many puffs around a place.
test::HandMade ball(const Vec3& centre, double radius_m, double puff_m, double opacity, const Colour& colour = {0.6, 0.6, 0.6}) {
  test::HandMade made;
  const int n = 6;
  for (int x = -n; x <= n; ++x)
    for (int y = -n; y <= n; ++y)
      for (int z = -n; z <= n; ++z) {
        const Vec3 at = (radius_m / n) * Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        if (length(at) <= radius_m) made.add(Form::smoke, centre + at, puff_m, colour, opacity);
      }
  return made;
}

TEST(SmokeShade, NothingAbsorbsWhereThereIsNoSmoke) {
  test::HandMade made;
  made.add(Form::tetrahedron, {0.0, 3.0, 0.0}, 2.0);
  made.add(Form::flash, {0.0, 3.0, 0.0}, 2.0);
  SmokeShade shade;
  shade.build(made.frame, made.layers, kUp);
  EXPECT_TRUE(shade.empty());
  EXPECT_EQ(shade.at({0.0, 0.0, 0.0}, 1.0).sunward, 0.0f);
  EXPECT_EQ(shade.at({0.0, 0.0, 0.0}, 1.0).sky, 1.0f);
}

TEST(SmokeShade, OpticalDepthGrowsAwayFromTheSun) {
  const auto made = ball({0.0, 20.0, 0.0}, 10.0, 3.0, 0.4);
  for (const Vec3& sun : {kUp, kSun, Vec3{1.0, 0.0, 0.0}, Vec3{-0.8, 0.6, 0.0}, Vec3{0.0, 0.28, -0.96}}) {
    SmokeShade shade;
    shade.build(made.frame, made.layers, sun);
    double last = -1.0;
    for (double along = 11.0; along >= -11.0; along -= 2.0) {
      const double depth = static_cast<double>(shade.at(Vec3{0.0, 20.0, 0.0} + along * sun, 0.0).sunward);
      EXPECT_GE(depth, last - 1e-4) << "at " << along << " m towards the sun";
      last = depth;
    }
    EXPECT_GT(last, 2.0) << "behind the whole cloud";
    EXPECT_LT(shade.at(Vec3{0.0, 20.0, 0.0} + 11.0 * sun, 0.0).sunward, 0.15f) << "before it";
  }
}

TEST(SmokeShade, DepthThroughTheCloudIsThatOfItsMassOverItsLine) {
  // 0.8 t0 r^2 of each puff, projected along the sun: the mean depth over a wide disc is their sum over its area.
  const auto made = ball({0.0, 20.0, 0.0}, 8.0, 3.0, 0.3);
  SmokeShade shade;
  shade.build(made.frame, made.layers, kUp);
  double sum = 0.0;
  const double step = 0.25;
  for (double x = -12.0; x <= 12.0; x += step)
    for (double z = -12.0; z <= 12.0; z += step) sum += static_cast<double>(shade.at({x, 8.0, z}, 0.0).sunward) * step * step;
  const double mass = static_cast<double>(made.frame.count) * 0.8 * opticalDepthOf(0.3) * 1.5 * 1.5;
  EXPECT_NEAR(sum, mass, 0.05 * mass);
}

TEST(SmokeShade, TheInsideSeesLessSkyThanTheOutside) {
  const auto made = ball({0.0, 20.0, 0.0}, 10.0, 3.0, 0.5);
  SmokeShade shade;
  shade.build(made.frame, made.layers, kSun);
  const float inside = shade.at({0.0, 20.0, 0.0}, 1.0).sky, top = shade.at({0.0, 30.5, 0.0}, 1.0).sky, foot = shade.at({0.0, 10.0, 0.0}, 1.0).sky;
  EXPECT_LT(inside, 0.5f);
  EXPECT_GT(top, foot + 0.05f);
  EXPECT_LE(top, 1.0001f);
}

TEST(SmokeShade, HidesFromAnEyeWhatThickSmokeStandsBefore) {
  const auto thick = ball({0.0, 20.0, 0.0}, 10.0, 3.0, 1.0), thin = ball({0.0, 20.0, 0.0}, 10.0, 3.0, 0.004);
  for (const Vec3& eye : {Vec3{0.0, 20.0, 50.0}, Vec3{40.0, 30.0, -20.0}, Vec3{5.0, 80.0, 5.0}}) {
    SmokeShade shade;
    shade.build(thick.frame, thick.layers, kSun);
    const Vec3 right{1.0, 0.0, 0.0};
    EXPECT_FALSE(shade.hidden({0.0, 20.0, 0.0}, 1.5, right, kUp)) << "not asked for";
    shade.lookFrom(eye);
    const Vec3 way = (1.0 / length(eye - Vec3{0.0, 20.0, 0.0})) * (eye - Vec3{0.0, 20.0, 0.0});
    EXPECT_TRUE(shade.hidden(Vec3{0.0, 20.0, 0.0} - 3.0 * way, 1.5, right, kUp));
    EXPECT_FALSE(shade.hidden(Vec3{0.0, 20.0, 0.0} + 10.0 * way, 1.5, right, kUp)) << "the near side";
    EXPECT_FALSE(shade.hidden(Vec3{0.0, 20.0, 0.0}, 30.0, right, kUp)) << "it stands out on all sides";
    shade.build(thin.frame, thin.layers, kSun);
    shade.lookFrom(eye);
    EXPECT_FALSE(shade.hidden({0.0, 20.0, 0.0}, 1.5, right, kUp));
    shade.build(thick.frame, thick.layers, kSun);
    shade.lookFrom({1.0, 21.0, 0.0});
    EXPECT_FALSE(shade.hidden({0.0, 20.0, 0.0}, 1.5, right, kUp)) << "an eye inside";
  }
}

TEST(SmokeShade, EqualFramesGiveEqualBits) {
  const auto made = ball({3.0, 20.0, -1.0}, 10.0, 3.0, 0.5);
  SmokeShade first, second;
  first.build(made.frame, made.layers, kSun);
  // One that has seen another frame before.
  const auto other = ball({0.0, 5.0, 0.0}, 30.0, 7.0, 0.9);
  second.build(other.frame, other.layers, kUp);
  second.build(made.frame, made.layers, kSun);
  for (std::size_t i = 0; i < made.frame.count; ++i) {
    const Vec3 at{static_cast<double>(made.frame.x[i]), static_cast<double>(made.frame.y[i]), static_cast<double>(made.frame.z[i])};
    EXPECT_EQ(first.at(at, 1.5).sunward, second.at(at, 1.5).sunward);
    EXPECT_EQ(first.at(at, 1.5).averted, second.at(at, 1.5).averted);
    EXPECT_EQ(first.at(at, 1.5).sky, second.at(at, 1.5).sky);
  }
}

TEST(SmokeShade, PlacesFarApartAndOneSpotStayBoundedAndFinite) {
  for (const double apart : {0.0, 1e-6, 1e3, 1e5}) {
    test::HandMade made;
    for (int i = 0; i < 40; ++i) made.add(Form::smoke, {apart * i, 2.0, -apart * i}, 1.0, {0.5, 0.5, 0.5}, 1.0);
    SmokeShade shade;
    shade.build(made.frame, made.layers, kSun);
    const PuffLight light = shade.at({0.0, 2.0, 0.0}, 0.5);
    EXPECT_TRUE(std::isfinite(light.sunward) && std::isfinite(light.averted) && std::isfinite(light.sky)) << apart;
    EXPECT_GE(light.sunward, 0.0f);
  }
}

TEST(SmokeShadow, ItsDarknessIsTheSameHoweverFarTheGroundLiesBelowAndEmptyWithoutSmoke) {
  SmokeShadowMap map;
  test::HandMade none;
  none.add(Form::fire, {0.0, 3.0, 0.0}, 2.0);
  mapSmokeShadow(none.frame, none.layers, {}, kSun, map);
  EXPECT_TRUE(map.empty());
  double sums[2];
  for (int i = 0; i < 2; ++i) {
    test::HandMade made;
    // Thin, so that darkness is proportional to depth.
    made.add(Form::smoke, {0.0, 3.0 + 60.0 * i, 0.0}, 4.0, {0.2, 0.2, 0.2}, 0.05);
    mapSmokeShadow(made.frame, made.layers, {}, kSun, map);
    sums[i] = 0.0;
    for (const float dark : map.dark) sums[i] += static_cast<double>(dark) * map.cell_m * map.cell_m;
  }
  EXPECT_GT(sums[0], 0.0);
  EXPECT_NEAR(sums[1], sums[0], 0.03 * sums[0]);
}

class ShadedSmoke : public test::Rendering {
 protected:
  static Image draw(const test::HandMade& made, const Camera& camera, Background::Kind kind = Background::Kind::transparent) {
    Scene scene;
    scene.frame = &made.frame;
    scene.layers = made.layers;
    scene.grid = false;
    scene.ground_colour = {0.46, 0.44, 0.38};
    scene.background.kind = kind;
    return picture(scene, camera, 320, 180);
  }
  static Camera from(const Vec3& eye) {
    Camera camera;
    camera.eye = eye;
    camera.target = {0.0, 20.0, 0.0};
    return camera;
  }
  /// Mean brightness of a square around the middle, or left and right of it.
  static double mean(const Image& image, int centre_x, int centre_y) {
    double sum = 0.0;
    for (int y = centre_y - 6; y <= centre_y + 6; ++y)
      for (int x = centre_x - 6; x <= centre_x + 6; ++x) sum += brightness(image.pixel(x, y));
    return sum / 169.0;
  }
};

TEST_F(ShadedSmoke, TheSideOfTheSunIsBrighterThanTheOther) {
  const auto made = ball({0.0, 20.0, 0.0}, 10.0, 3.5, 0.6);
  const double lit = mean(draw(made, from(Vec3{0.0, 20.0, 0.0} + 60.0 * kSun)), 160, 90);
  const double shadowed = mean(draw(made, from(Vec3{0.0, 20.0, 0.0} - 60.0 * kSun)), 160, 90);
  EXPECT_GT(lit, 1.35 * shadowed);
}

TEST_F(ShadedSmoke, APuffBehindOthersTowardsTheSunIsDarker) {
  // Seen from aside: one puff, with and without a cloud between it and the sun, which stands outside the picture's middle.
  const auto pictured = [&](bool cloud) {
    test::HandMade made;
    made.add(Form::smoke, {0.0, 20.0, 0.0}, 6.0, {0.7, 0.7, 0.7}, 1.0);
    if (cloud)
      for (int i = 0; i < 60; ++i) made.add(Form::smoke, Vec3{0.0, 20.0, 0.0} + (8.0 + 0.2 * i) * kSun, 6.0, {0.7, 0.7, 0.7}, 0.9);
    // Along a line across the sun's, so that nothing of the cloud stands before the puff.
    return mean(draw(made, from(Vec3{0.0, 20.0, 0.0} + (40.0 / 0.7037) * Vec3{kSun.z, 0.0, -kSun.x})), 160, 90);
  };
  EXPECT_LT(pictured(true), 0.8 * pictured(false));
}

TEST_F(ShadedSmoke, FireLightsTheShadowedSide) {
  auto made = ball({0.0, 20.0, 0.0}, 6.0, 3.5, 0.6, {0.3, 0.3, 0.3});
  const Camera camera = from(Vec3{0.0, 20.0, 0.0} - 40.0 * kSun);
  const double before = mean(draw(made, camera), 160, 90);
  made.add(Form::fire, Vec3{0.0, 20.0, 0.0} - 50.0 * kSun, 20.0, {1.0, 0.7, 0.3}, 1.0);  // behind the eye
  EXPECT_GT(mean(draw(made, camera), 160, 90), before + 5.0);
}

TEST_F(ShadedSmoke, ItsShadowOnTheGroundIsWhereTheSunThrowsItAndSmooth) {
  const auto made = ball({0.0, 20.0, 0.0}, 6.0, 3.0, 0.08, {0.2, 0.2, 0.2});
  test::HandMade none;
  Camera camera;
  const Vec3 thrown{20.0 * 0.5263 / 0.7105, 0.0, -20.0 * 0.4671 / 0.7105};
  camera.eye = thrown + Vec3{0.0, 60.0, 0.1};  // from above, where the smoke stands beside its shadow
  camera.target = thrown;
  const Image with = draw(made, camera, Background::Kind::sky), without = draw(none, camera, Background::Kind::sky);
  EXPECT_LT(brightness(with.pixel(160, 90)), brightness(without.pixel(160, 90)) - 25.0);
  // No edges: neighbouring pixels along a row through it differ by little.
  for (int x = 110; x < 210; ++x) EXPECT_LT(std::abs(brightness(with.pixel(x, 90)) - brightness(with.pixel(x + 1, 90))), 6.0) << x;
}

}  // namespace
}  // namespace npsee::render
