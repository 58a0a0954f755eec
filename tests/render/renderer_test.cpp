#include "app/gl/program.h"
#include "tests/support/rendering.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace npsee::render {
namespace {

class Rendering : public test::Rendering {
 protected:
  static Image draw(const Scene& scene, const Camera& camera, int width = 320, int height = 180) {
    return picture(scene, camera, width, height);
  }
};

using test::brightness;

Scene sceneOf(const test::HandMade& made, Background::Kind background = Background::Kind::sky, const Colour& colour = {}) {
  Scene scene;
  scene.frame = &made.frame;
  scene.layers = made.layers;
  scene.ground_colour = {0.36, 0.34, 0.29};
  scene.background = {background, colour};
  return scene;
}

Camera looking(const Vec3& eye, const Vec3& target) {
  Camera camera;
  camera.eye = eye;
  camera.target = target;
  return camera;
}

int coveredPixels(const Image& image) {
  int count = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) count += image.rgba[i] > 0;
  return count;
}

const Camera kFront = looking({0.0, 3.0, 20.0}, {0.0, 3.0, 0.0});

TEST_F(Rendering, ATransparentPictureHoldsTheParticleAloneWithStraightAlpha) {
  test::HandMade made;
  made.add(Form::sphere, {0.0, 3.0, 0.0}, 4.0, {0.8, 0.2, 0.2});
  const Image image = draw(sceneOf(made, Background::Kind::transparent), kFront);
  EXPECT_EQ(image.pixel(0, 0)[3], 0);
  EXPECT_EQ(image.pixel(160, 179)[3], 0) << "no ground and no shadow";
  EXPECT_EQ(image.pixel(160, 90)[3], 255);
  // Edge pixels keep the particle's own colour: straight alpha, nothing mixed in from outside.
  for (int x = 0; x < 320; ++x) {
    const std::uint8_t* p = image.pixel(x, 90);
    if (p[3] > 40) {
      EXPECT_GT(p[0], p[1] + 20) << x;
    }
  }
}

TEST_F(Rendering, EveryFormCoversAboutTheAreaOfItsSize) {
  for (const Form form : {Form::tetrahedron, Form::disc, Form::sphere, Form::shard, Form::streak, Form::smoke, Form::fire, Form::flash}) {
    test::HandMade made;
    made.add(form, {0.0, 3.0, 0.0}, 4.0);
    Scene scene = sceneOf(made, Background::Kind::transparent);
    scene.bloom = false;  // the form's own light
    const Image image = draw(scene, kFront);
    // Area of a disc of that diameter in pixels; forms fill between a fortieth (streak at rest) and all of it.
    const double radius_px = 2.0 / (20.0 * std::tan(0.5 * kFront.fov_y_rad)) * 90.0;
    const double share = coveredPixels(image) / (3.14159265 * radius_px * radius_px);
    EXPECT_GT(share, 0.025) << static_cast<int>(form);
    EXPECT_LT(share, 1.15) << static_cast<int>(form);
  }
}

TEST_F(Rendering, APieceOfFortyCentimetresIsSeenAtFortyMetres) {
  test::HandMade made, none;
  made.add(Form::tetrahedron, {0.0, 3.0, 0.0}, 0.4);
  const Camera camera = looking({0.0, 3.0, 40.0}, {0.0, 3.0, 0.0});
  const Image with = draw(sceneOf(made), camera, 1280, 720), without = draw(sceneOf(none), camera, 1280, 720);
  int changed = 0;
  for (std::size_t i = 0; i < with.rgba.size(); i += 4) changed += std::abs(with.rgba[i] - without.rgba[i]) > 25;
  EXPECT_GE(changed, 20);
}

TEST_F(Rendering, APieceIsNeverTooSmallToBeSeen) {
  test::HandMade made;
  made.add(Form::tetrahedron, {0.0, 3.0, 0.0}, 0.01);
  EXPECT_GE(coveredPixels(draw(sceneOf(made, Background::Kind::transparent), looking({0.0, 3.0, 400.0}, {0.0, 3.0, 0.0}))), 1);
}

TEST_F(Rendering, APlainBackgroundKeepsItsExactColour) {
  for (const Colour& colour : {Colour{1.0, 1.0, 1.0}, Colour{0.0, 0.0, 0.0}, Colour{18.0 / 255, 52.0 / 255, 250.0 / 255}}) {
    test::HandMade made;
    made.add(Form::tetrahedron, {0.0, 3.0, 0.0}, 1.0);
    const Image image = draw(sceneOf(made, Background::Kind::colour, colour), kFront);
    const std::uint8_t* p = image.pixel(3, 3);
    EXPECT_EQ(p[0], std::lround(255.0 * colour.r));
    EXPECT_EQ(p[1], std::lround(255.0 * colour.g));
    EXPECT_EQ(p[2], std::lround(255.0 * colour.b));
    EXPECT_EQ(p[3], 255);
  }
}

TEST_F(Rendering, DeadParticlesAreNotDrawn) {
  test::HandMade made;
  made.add(Form::tetrahedron, {0.0, 3.0, 0.0}, 0.0, {1.0, 1.0, 1.0}, 0.0);
  made.add(Form::smoke, {0.0, 3.0, 0.0}, 0.0, {1.0, 1.0, 1.0}, 0.0);
  EXPECT_EQ(coveredPixels(draw(sceneOf(made, Background::Kind::transparent), kFront)), 0);
}

TEST_F(Rendering, APieceDarkensTheGroundBesideItAndTheShadowFadesWithHeight) {
  const Camera above = looking({0.0, 30.0, 0.1}, {0.0, 0.0, 0.0});
  const auto darkest = [&](double height) {
    test::HandMade made, none;
    made.add(Form::sphere, {0.0, height, 0.0}, 1.0);
    Scene with = sceneOf(made), without = sceneOf(none);
    with.grid = without.grid = false;
    const Image a = draw(with, above), b = draw(without, above);
    double most = 0.0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) most = std::max(most, brightness(&b.rgba[i]) - brightness(&a.rgba[i]));
    return most;
  };
  const double near = darkest(0.0), higher = darkest(10.0), far = darkest(60.0);
  EXPECT_GT(near, 15.0);
  EXPECT_GT(near, higher + 3.0);
  EXPECT_GE(higher, far);
}

TEST_F(Rendering, ARestingPieceStandsOnTheGroundInsteadOfInIt) {
  for (const Form form : {Form::tetrahedron, Form::sphere, Form::shard, Form::disc}) {
    test::HandMade made;
    made.add(form, {0.0, 0.0, 0.0}, 4.0, {1.0, 0.1, 0.1});
    const Image image = draw(sceneOf(made), looking({0.0, 0.5, 20.0}, {0.0, 0.5, 0.0}));
    const Image free = draw(sceneOf(made, Background::Kind::transparent), looking({0.0, 0.5, 20.0}, {0.0, 0.5, 0.0}));
    int shown = 0;
    for (int i = 0; i < 320 * 180; ++i) shown += image.rgba[4u * i] > image.rgba[4u * i + 1] + 40;
    EXPECT_GT(shown, 0.80 * coveredPixels(free)) << static_cast<int>(form);
  }
}

TEST_F(Rendering, TheGroundHidesWhatIsBelowIt) {
  test::HandMade made, none;
  made.add(Form::sphere, {0.0, -6.0, 0.0}, 4.0, {1.0, 0.0, 0.0});
  EXPECT_EQ(draw(sceneOf(made), kFront).rgba, draw(sceneOf(none), kFront).rgba);
}

TEST_F(Rendering, TheGridHasALineEveryMetreNearbyAndNoneFarAway) {
  test::HandMade none;
  Scene with = sceneOf(none), without = sceneOf(none);
  without.grid = false;
  // Straight down from 5 m, north up: 180 rows span 2 * 5 m * tan(20 deg) = 3.64 m.
  const Camera down = looking({0.5, 5.0, 0.5}, {0.5, 0.0, 0.5});
  const Image lined = draw(with, down), plain = draw(without, down);
  int lines = 0;
  bool inside = false;
  for (int y = 0; y < 180; ++y) {
    const bool dark = brightness(lined.pixel(163, y)) < brightness(plain.pixel(163, y)) - 2.0;
    lines += dark && !inside;
    inside = dark;
  }
  EXPECT_EQ(lines, 4) << "z = -1, 0, 1 and 2 lie within 0.5 +- 1.82 m";
  const Camera flat = looking({0.0, 2.0, 0.0}, {0.0, 2.0, -10.0});
  const Image far_lined = draw(with, flat), far_plain = draw(without, flat);
  for (int x = 0; x < 320; ++x) EXPECT_NEAR(far_lined.pixel(x, 91)[0], far_plain.pixel(x, 91)[0], 1) << "just below the horizon";
}

TEST_F(Rendering, TheHorizonIsSoft) {
  test::HandMade none;
  const Image image = draw(sceneOf(none), looking({0.0, 2.0, 0.0}, {0.0, 2.0, -10.0}));
  for (int y = 80; y < 95; ++y) EXPECT_LT(std::abs(brightness(image.pixel(160, y)) - brightness(image.pixel(160, y + 1))), 12.0) << y;
  EXPECT_GT(brightness(image.pixel(160, 20)), brightness(image.pixel(160, 170))) << "sky over ground";
}

TEST_F(Rendering, FacetsTurnedToTheLightAreBrighter) {
  test::HandMade made;
  made.add(Form::sphere, {0.0, 3.0, 0.0}, 6.0, {0.6, 0.6, 0.6});
  const Image image = draw(sceneOf(made), kFront);
  // The key light comes from the upper left of this camera.
  EXPECT_GT(brightness(image.pixel(150, 75)), brightness(image.pixel(172, 108)) + 40.0);
}

TEST_F(Rendering, FireIsTheBrightestThing) {
  test::HandMade made;
  made.add(Form::fire, {0.0, 3.0, 0.0}, 6.0, {1.0, 0.6, 0.2});
  const Image image = draw(sceneOf(made), kFront);
  double brightest = 0.0, around = 0.0;
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 320; ++x) {
      double& most = std::abs(x - 160) < 45 && std::abs(y - 90) < 45 ? brightest : around;
      most = std::max(most, brightness(image.pixel(x, y)));
    }
  EXPECT_GT(brightest, around + 30.0);
}

TEST_F(Rendering, ANearerSmokeHidesAFartherOneWhateverTheirOrder) {
  test::HandMade a, b;
  a.add(Form::smoke, {0.0, 3.0, 5.0}, 4.0, {1.0, 0.0, 0.0});
  a.add(Form::smoke, {0.0, 3.0, -5.0}, 4.0, {0.0, 0.0, 1.0});
  b.add(Form::smoke, {0.0, 3.0, -5.0}, 4.0, {0.0, 0.0, 1.0});
  b.add(Form::smoke, {0.0, 3.0, 5.0}, 4.0, {1.0, 0.0, 0.0});
  for (const auto* made : {&a, &b}) {
    const Image image = draw(sceneOf(*made), kFront);
    EXPECT_GT(image.pixel(160, 90)[0], image.pixel(160, 90)[2] + 40);
  }
}

TEST_F(Rendering, ATranslucentSolidLetsTheBackgroundThrough) {
  test::HandMade made;
  made.add(Form::sphere, {0.0, 3.0, 0.0}, 4.0, {0.8, 0.2, 0.2}, 0.5);
  EXPECT_NEAR(draw(sceneOf(made, Background::Kind::transparent), kFront).pixel(160, 90)[3], 128, 2);
}

TEST_F(Rendering, TheSameSceneGivesTheSameBytesWhateverWasDrawnBefore) {
  test::HandMade made, other;
  made.addDome(Form::tetrahedron, 300, 12.0, 0.5);
  made.addDome(Form::smoke, 40, 6.0, 3.0, {0.5, 0.5, 0.5}, 0.4);
  other.addDome(Form::shard, 500, 15.0, 1.0);
  const Image first = draw(sceneOf(made), kFront);
  draw(sceneOf(other, Background::Kind::transparent), looking({9.0, 9.0, 9.0}, {}), 200, 100);
  EXPECT_EQ(draw(sceneOf(made), kFront).rgba, first.rgba);
}

TEST_F(Rendering, TextureAndImageHoldTheSamePictureTurnedOver) {
  test::HandMade made;
  made.addDome(Form::tetrahedron, 50, 6.0, 1.0);
  const Image image = draw(sceneOf(made), kFront, 64, 48);
  const auto texture = renderer_->drawToTexture(sceneOf(made), kFront, 64, 48, 2);
  ASSERT_TRUE(texture) << texture.error().text();
  std::vector<std::uint8_t> pixels(64 * 48 * 4);
  glBindTexture(GL_TEXTURE_2D, *texture);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  for (int y = 0; y < 48; ++y)
    EXPECT_TRUE(std::equal(image.pixel(0, y), image.pixel(0, y) + 64 * 4, pixels.begin() + (47 - y) * 64 * 4)) << y;
}

TEST_F(Rendering, ASizeOverTheLimitIsRefusedWithTheLimit) {
  test::HandMade none;
  for (const auto& [width, height] : {std::pair{0, 10}, {10, -1}, {kMaxPictureSize + 1, 10}}) {
    const auto image = renderer_->drawToImage(sceneOf(none), kFront, width, height);
    ASSERT_FALSE(image);
    EXPECT_NE(image.error().text().find("8192"), std::string::npos) << image.error().text();
  }
}

TEST_F(Rendering, AShaderThatDoesNotCompileIsAGraphicsErrorWithTheDriversWords) {
  // A vertex shader where a fragment shader belongs, and the other way round; also with the right ones in the driver's cache.
  ASSERT_TRUE(gl::Program::fromFiles("tiles.vert", "finish.frag"));
  const auto wrong = gl::Program::fromFiles("tiles.vert", "tiles.vert");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().kind, ErrorKind::graphics);
  EXPECT_TRUE(wrong.error().text().starts_with("shader tiles.vert does not compile: ")) << wrong.error().text();
  EXPECT_NE(wrong.error().text().find("error"), std::string::npos) << wrong.error().text();
  const auto other = gl::Program::fromFiles("finish.frag", "clear.frag");
  ASSERT_FALSE(other);
  EXPECT_TRUE(other.error().text().starts_with("shader finish.frag does not compile: ")) << other.error().text();
  const auto missing = gl::Program::fromFiles("tiles.vert", "no_such.frag");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().text().find("no_such.frag"), std::string::npos);
}

TEST(Context, WithoutTheLibraryTheMessageNamesThePackage) {
  ::setenv("NPSEE_OSMESA", "libNoSuchOSMesa.so.8", 1);
  const auto context = gl::makeOffscreenContext();
  ::unsetenv("NPSEE_OSMESA");
  ASSERT_FALSE(context);
  EXPECT_EQ(context.error().kind, ErrorKind::graphics);
  EXPECT_NE(context.error().text().find("libosmesa6"), std::string::npos) << context.error().text();
}

TEST(Context, WithoutADisplayTheMessageNamesTheHeadlessWay) {
  ::unsetenv("DISPLAY");
  ::unsetenv("WAYLAND_DISPLAY");
  const auto context = gl::makeWindowContext({});
  ASSERT_FALSE(context);
  EXPECT_EQ(context.error().kind, ErrorKind::graphics);
  EXPECT_EQ(context.error().text(),
            "cannot open a window: X11: The DISPLAY environment variable is missing.\n"
            "  To render without a display use `npsee render PRESET -o picture.png`.");
}

}  // namespace
}  // namespace npsee::render
