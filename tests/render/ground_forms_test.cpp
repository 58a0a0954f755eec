// What lies on the ground, blast fronts, and the hour's light.

#include "tests/support/rendering.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace npsee::render::ground_forms {
namespace {

/// Sum of a pixel's three colours.
int brightness(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return p[0] + p[1] + p[2];
}

class GroundForms : public test::Rendering {
 protected:
  static Image draw(const test::HandMade& made, const Camera& camera, Sky sky = Sky::day, Background::Kind background = Background::Kind::sky) {
    Scene scene;
    scene.frame = &made.frame;
    scene.layers = made.layers;
    scene.ground_colour = {0.46, 0.44, 0.38};
    scene.sky = sky;
    scene.grid = false;
    scene.background = {background, {}};
    return picture(scene, camera, 320, 180);
  }
};

Camera looking(const Vec3& eye, const Vec3& target) {
  Camera camera;
  camera.eye = eye;
  camera.target = target;
  return camera;
}

/// Straight down on the origin: a pixel is 2 tan(20 deg) 40 m / 180 = 0.162 m.
const Camera kAbove = looking({0.0, 40.0, 0.0}, {0.0, 0.0, 0.0});
constexpr double kPixel_m = 2.0 * 0.36397 * 40.0 / 180.0;
const Camera kSide = looking({0.0, 3.0, 40.0}, {0.0, 3.0, 0.0});

int at(const Image& image, double x_m, double z_m) { return brightness(image, 160 + static_cast<int>(std::lround(x_m / kPixel_m)), 90 + static_cast<int>(std::lround(z_m / kPixel_m))); }

/// Sum of what differs between two pictures.
int differing(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) count += a.rgba[i] != b.rgba[i] || a.rgba[i + 1] != b.rgba[i + 1] || a.rgba[i + 2] != b.rgba[i + 2];
  return count;
}

TEST_F(GroundForms, AScorchDarkensTheGroundMostInItsMiddleAndNothingBeyondItsSize) {
  test::HandMade made, none;
  made.add(Form::scorch, {0.0, 0.0, 0.0}, 12.0, {0.07, 0.06, 0.05});
  const Image with = draw(made, kAbove), without = draw(none, kAbove);
  EXPECT_LT(at(with, 0.0, 0.0), at(without, 0.0, 0.0) / 2);
  int ring_sum = 0, ring_plain = 0;
  for (int k = 0; k < 24; ++k) {
    const double turn = 0.2618 * k;
    ring_sum += at(with, 3.6 * std::cos(turn), 3.6 * std::sin(turn));
    ring_plain += at(without, 3.6 * std::cos(turn), 3.6 * std::sin(turn));
    EXPECT_EQ(at(with, 6.6 * std::cos(turn), 6.6 * std::sin(turn)), at(without, 6.6 * std::cos(turn), 6.6 * std::sin(turn))) << "beyond the patch";
  }
  EXPECT_GT(ring_sum / 24, at(with, 0.0, 0.0)) << "it runs out towards its rim";
  EXPECT_LT(ring_sum, ring_plain);
}

TEST_F(GroundForms, AScorchHasARaggedRim) {
  test::HandMade made;
  made.add(Form::scorch, {0.0, 0.0, 0.0}, 12.0, {0.05, 0.05, 0.05});
  const Image image = draw(made, kAbove);
  int least = 1000, most = 0;
  for (int k = 0; k < 60; ++k) {
    const int value = at(image, 3.9 * std::cos(0.1047 * k), 3.9 * std::sin(0.1047 * k));
    least = std::min(least, value);
    most = std::max(most, value);
  }
  EXPECT_GT(most, least + 60) << "sum of three colours";
}

TEST_F(GroundForms, AScorchLiesUnderPiecesAndShadows) {
  test::HandMade scorch, piece, both;
  scorch.add(Form::scorch, {0.0, 0.0, 0.0}, 30.0, {0.06, 0.05, 0.05});
  both.add(Form::scorch, {0.0, 0.0, 0.0}, 30.0, {0.06, 0.05, 0.05});
  piece.add(Form::sphere, {0.0, 4.0, 0.0}, 4.0, {0.9, 0.2, 0.2});
  both.add(Form::sphere, {0.0, 4.0, 0.0}, 4.0, {0.9, 0.2, 0.2});
  const Image a = draw(piece, kAbove), b = draw(both, kAbove), bare = draw(scorch, kAbove);
  EXPECT_EQ(at(a, 0.0, 0.0), at(b, 0.0, 0.0)) << "the piece hides what lies under it";
  // The sphere's shadow falls 4 m * 0.74 to the east and 4 m * 0.66 to the north.
  EXPECT_LT(at(b, 3.0, -2.6), at(bare, 3.0, -2.6));
}

TEST_F(GroundForms, NothingOnTheGroundIsDrawnWhereThereIsNone) {
  test::HandMade scorch, shock;
  scorch.add(Form::scorch, {0.0, 0.0, 0.0}, 12.0, {0.05, 0.05, 0.05});
  const Image none = draw(scorch, kAbove, Sky::day, Background::Kind::transparent);
  for (std::size_t i = 3; i < none.rgba.size(); i += 4) ASSERT_EQ(none.rgba[i], 0);
  // A blast front's shell is in the air.
  shock.add(Form::shock, {0.0, 4.0, 0.0}, 12.0, {1.0, 1.0, 1.0});
  const Image shell = draw(shock, kSide, Sky::day, Background::Kind::transparent);
  int covered = 0;
  for (std::size_t i = 3; i < shell.rgba.size(); i += 4) covered += shell.rgba[i] > 0;
  EXPECT_GT(covered, 200);
}

TEST_F(GroundForms, AShockCoversARingAndNotItsMiddle) {
  test::HandMade made, none;
  // From below the ground, so that of the shell only a cap is left, whose outline is not seen from above.
  made.add(Form::shock, {0.0, -15.0, 0.0}, 34.0, {1.0, 1.0, 1.0});
  const Image with = draw(made, kAbove), without = draw(none, kAbove);
  for (int k = 0; k < 24; ++k) {
    const double x = std::cos(0.2618 * k), z = std::sin(0.2618 * k);
    EXPECT_GT(at(with, 8.0 * x, 8.0 * z), at(without, 8.0 * x, 8.0 * z) + 40) << "bright at the front";
    EXPECT_LT(at(with, 7.25 * x, 7.25 * z), at(without, 7.25 * x, 7.25 * z) - 30) << "darker behind it";
    EXPECT_EQ(at(with, 3.0 * x, 3.0 * z), at(without, 3.0 * x, 3.0 * z));
    EXPECT_EQ(at(with, 10.0 * x, 10.0 * z), at(without, 10.0 * x, 10.0 * z));
  }
  EXPECT_EQ(at(with, 0.0, 0.0), at(without, 0.0, 0.0));
}

TEST_F(GroundForms, AShockInTheAirMeetsTheGroundWhereItReachesIt) {
  test::HandMade high, low, none;
  high.add(Form::shock, {0.0, 9.0, 0.0}, 16.0, {1.0, 1.0, 1.0});
  low.add(Form::shock, {0.0, 4.8, 0.0}, 16.0, {1.0, 1.0, 1.0});
  const Image far = draw(high, kAbove), near = draw(low, kAbove), without = draw(none, kAbove);
  // At sqrt(8^2 - 4.8^2) = 6.4 m; the shell's outline is seen farther out.
  EXPECT_GT(at(near, 6.4, 0.0), at(without, 6.4, 0.0) + 40);
  EXPECT_EQ(at(far, 6.4, 0.0), at(without, 6.4, 0.0));
}

TEST_F(GroundForms, AShellIsBrightestAtItsOutlineAndCutByTheGround) {
  test::HandMade made, none;
  made.add(Form::shock, {0.0, 0.0, 0.0}, 16.0, {1.0, 1.0, 1.0});
  const Image with = draw(made, kSide, Sky::night), without = draw(none, kSide, Sky::night);
  const int centre_y = 90 + static_cast<int>(3.0 / kPixel_m);
  const auto added = [&](int x, int y) { return brightness(with, x, y) - brightness(without, x, y); };
  int outline = 0;
  for (int y = 20; y < 80; ++y) outline = std::max(outline, added(160, y));
  EXPECT_GT(outline, 4);
  EXPECT_EQ(added(160, centre_y - 12), 0) << "through the middle nothing is seen";
  for (int x = 0; x < 320; ++x) ASSERT_EQ(added(x, 175), 0) << "under the ground";
}

TEST_F(GroundForms, AShockHasNoDepthOfItsOwn) {
  test::HandMade made, none;
  made.add(Form::shock, {0.0, 0.0, 0.0}, 16.0);
  made.add(Form::scorch, {0.0, 0.0, 0.0}, 16.0);
  FloatImage with, without;
  for (auto [frame, image] : {std::pair(&made, &with), std::pair(&none, &without)}) {
    Scene scene;
    scene.frame = &frame->frame;
    scene.layers = frame->layers;
    FloatRequest request;
    request.colour = false;
    request.depth = request.motion = true;
    const auto drawn = renderer_->drawToFloats(scene, kSide, 320, 180, request, *image);
    ASSERT_TRUE(drawn) << drawn.error().text();
  }
  EXPECT_EQ(with.depth, without.depth);
  EXPECT_EQ(with.motion, without.motion);
}

TEST_F(GroundForms, ItGetsDarkerByTheHour) {
  test::HandMade made;
  made.add(Form::sphere, {0.0, 3.0, 0.0}, 5.0, {0.8, 0.8, 0.8});
  made.add(Form::smoke, {9.0, 3.0, 0.0}, 5.0, {0.8, 0.8, 0.8});
  const Image day = draw(made, kSide, Sky::day), dusk = draw(made, kSide, Sky::dusk), night = draw(made, kSide, Sky::night);
  const int smoke_x = 160 + static_cast<int>(9.0 / kPixel_m);
  for (const auto& [x, y, what] : {std::tuple(160, 90, "a piece"), std::tuple(smoke_x, 90, "smoke"), std::tuple(20, 5, "the sky"), std::tuple(20, 170, "the ground")}) {
    EXPECT_GT(brightness(day, x, y), brightness(dusk, x, y)) << what;
    EXPECT_GT(brightness(dusk, x, y), brightness(night, x, y)) << what;
    EXPECT_GT(brightness(night, x, y), 3) << what << " is not quite black";
  }
}

TEST_F(GroundForms, ShadowsLieWhereTheHoursSunOrMoonThrowsThemAndAreLongAtDusk) {
  test::HandMade made, none;
  made.add(Form::sphere, {0.0, 1.5, 0.0}, 2.4, {0.8, 0.8, 0.8});
  // Places on the ground behind the sphere, seen from the light: -k / k.y times the height of its middle.
  const struct {
    Sky sky;
    Vec3 towards;
  } hours[] = {{Sky::day, {-0.5263, 0.7105, 0.4671}}, {Sky::dusk, {-0.7341, 0.1908, 0.6516}}, {Sky::night, {0.5150, 0.6018, 0.6104}}};
  int dark[3] = {};
  for (std::size_t hour = 0; hour < 3; ++hour) {
    const Image with = draw(made, kAbove, hours[hour].sky), without = draw(none, kAbove, hours[hour].sky);
    for (const auto& other : hours) {
      const double x = -1.5 * other.towards.x / other.towards.y, z = -1.5 * other.towards.z / other.towards.y;
      const bool own = other.sky == hours[hour].sky;
      // Close to the sphere it hides the ground, or the long shadow of dusk begins.
      const bool apart = other.sky != Sky::day || hours[hour].sky == Sky::night;
      if (own) {
        EXPECT_LT(at(with, x, z), at(without, x, z) * 85 / 100) << hour;
      } else if (apart) {
        EXPECT_EQ(at(with, x, z), at(without, x, z)) << hour;
      }
    }
    for (int y = 0; y < 180; ++y)
      for (int x = 0; x < 320; ++x) dark[hour] += brightness(with, x, y) < brightness(without, x, y) - 1;
  }
  EXPECT_GT(dark[1], 2 * dark[0]) << "a low sun throws long shadows";
}

TEST_F(GroundForms, ThePieceIsLitFromWhereTheHoursLightStands) {
  test::HandMade made;
  made.add(Form::sphere, {0.0, 3.0, 0.0}, 6.0, {0.8, 0.8, 0.8});
  const int off = static_cast<int>(2.2 / kPixel_m);
  for (const Sky sky : {Sky::day, Sky::dusk, Sky::night}) {
    const Image image = draw(made, kSide, sky);
    // Looking north: the sun in the south-west is on the left, the moon in the south-east on the right.
    const int left = brightness(image, 160 - off, 90), right = brightness(image, 160 + off, 90);
    if (sky == Sky::night) {
      EXPECT_GT(right, left + 10);
    } else {
      EXPECT_GT(left, right + 60);
    }
  }
  // A low sun is red.
  const Image dusk = draw(made, kSide, Sky::dusk);
  const std::uint8_t* lit = dusk.pixel(160 - off, 90);
  EXPECT_GT(lit[0], lit[2] + 40);
}

TEST_F(GroundForms, AtNightWhatShinesLightsTheGroundFarMoreThanTheHourDoes) {
  test::HandMade made, none;
  made.add(Form::flash, {0.0, 4.0, 0.0}, 6.0, {1.0, 0.9, 0.7});
  const Image lit = draw(made, kAbove, Sky::night), dark = draw(none, kAbove, Sky::night), day = draw(none, kAbove, Sky::day);
  EXPECT_GT(at(lit, 7.0, 0.0), 2 * at(dark, 7.0, 0.0));
  EXPECT_GT(at(lit, 5.0, 5.0), at(day, 5.0, 5.0) / 2);
  EXPECT_LT(at(dark, 5.0, 5.0), at(day, 5.0, 5.0) / 3);
}

TEST_F(GroundForms, APlainBackgroundTakesThePlaceOfTheSkyAtAnyHour) {
  const test::HandMade none;
  EXPECT_EQ(differing(draw(none, kSide, Sky::night, Background::Kind::colour), draw(none, kSide, Sky::day, Background::Kind::colour)), 0);
}

TEST_F(GroundForms, LookingStraightUpOrDownIsNoTrouble) {
  const test::HandMade none;
  for (const Sky sky : {Sky::day, Sky::dusk, Sky::night})
    for (const double y : {-30.0, 60.0}) {
      const Image image = draw(none, looking({0.0, 10.0, 0.0}, {0.0, y, 0.0}), sky);
      // Neighbours in the middle are alike: no undefined colours.
      EXPECT_NEAR(brightness(image, 160, 90), brightness(image, 163, 92), 30);
    }
}

}  // namespace
}  // namespace npsee::render::ground_forms
