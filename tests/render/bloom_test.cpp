#include "app/render/bloom.h"

#include "tests/support/rendering.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace npsee::render {
namespace {

class Blooming : public test::Rendering {
 protected:
  /// Seen straight from the front; a metre is kPixels pixels.
  static constexpr double kPixels = 4.0;
  static Camera front(int height) {
    Camera camera;
    camera.eye = {0.0, 20.0, 60.0};
    camera.target = {0.0, 20.0, 0.0};
    camera.fov_y_rad = 2.0 * std::atan(0.5 * height / kPixels / 60.0);
    return camera;
  }
  static Scene sceneOf(const test::HandMade& made, bool bloom, Background::Kind background = Background::Kind::colour) {
    Scene scene;
    scene.frame = &made.frame;
    scene.layers = made.layers;
    scene.background.kind = background;
    scene.bloom = bloom;
    return scene;
  }
  static Image draw(const test::HandMade& made, bool bloom, Background::Kind background = Background::Kind::colour, int width = 320, int height = 180, double zoom = 1.0) {
    Camera camera = front(180);
    camera.fov_y_rad = 2.0 * std::atan(zoom * std::tan(0.5 * camera.fov_y_rad));
    return picture(sceneOf(made, bloom, background), camera, width, height);
  }
  static test::HandMade flash(double size_m = 3.0) {
    test::HandMade made;
    made.add(Form::flash, {0.0, 20.0, 0.0}, size_m, {1.0, 0.9, 0.8});
    return made;
  }
};

/// Linear light of a coded component that was rolled off.
double lightOf(std::uint8_t coded) {
  const double c = coded / 255.0, shown = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  const double over = std::clamp((shown - 0.8) / 0.2, 0.0, 0.99);
  return std::min(shown, 0.8) + 0.2 * over / (1.0 - over);
}

TEST_F(Blooming, SpreadsABrightLightEvenlyAroundIt) {
  const Image without = draw(flash(), false), with = draw(flash(), true);
  int last = 255;
  for (const int d : {10, 14, 18, 24}) {
    const int more[] = {with.pixel(160 + d, 90)[0] - without.pixel(160 + d, 90)[0], with.pixel(159 - d, 90)[0] - without.pixel(159 - d, 90)[0],
                        with.pixel(160, 90 + d)[0] - without.pixel(160, 90 + d)[0], with.pixel(160, 89 - d)[0] - without.pixel(160, 89 - d)[0]};
    for (const int one : more) {
      EXPECT_GT(one, 0) << d;
      EXPECT_LE(std::abs(one - more[0]), 4) << d << ": as far to all sides";
    }
    EXPECT_LT(more[0], last) << d << ": less with distance";
    last = more[0];
  }
}

TEST_F(Blooming, MovesLightAndMakesNone) {
  // In the middle of a wide picture nothing is lost at its borders. 16 bits, so that the faint far light counts; a rim that is not rolled off.
  const auto made = flash(1.5);
  double sums[2];
  for (int on = 0; on < 2; ++on) {
    FloatImage image;
    auto drawn = renderer_->drawToFloats(sceneOf(made, on == 1), front(180), 320, 180, {.linear = false}, image);
    ASSERT_TRUE(drawn) << drawn.error().text();
    sums[on] = 0.0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
      if (i % 4 == 3) continue;
      const double c = static_cast<double>(image.rgba[i]), shown = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
      const double over = std::clamp((shown - 0.8) / 0.2, 0.0, 0.999999);
      sums[on] += std::min(shown, 0.8) + 0.2 * over / (1.0 - over);
    }
  }
  EXPECT_GT(sums[0], 20.0);
  EXPECT_NEAR(sums[1], sums[0], 0.04 * sums[0]);
}

TEST_F(Blooming, WhatDoesNotSpreadKeepsItsLightWhileSomethingElseDoes) {
  // A white ball in the sun is brighter than a picture can show, and no light of its own; the flash is farther off than light spreads.
  test::HandMade made;
  made.add(Form::sphere, {-30.0, 20.0, 0.0}, 8.0, {1.0, 1.0, 1.0});
  made.add(Form::flash, {32.0, 20.0, 0.0}, 3.0, {1.0, 0.9, 0.8});
  const Image without = draw(made, false), with = draw(made, true);
  EXPECT_NE(with.rgba, without.rgba) << "the flash blooms";
  int bright = 0;
  for (int y = 60; y < 120; ++y)
    for (int x = 15; x < 70; ++x) {
      bright += without.pixel(x, y)[0] > 235;
      for (int c = 0; c < 3; ++c) ASSERT_EQ(with.pixel(x, y)[c], without.pixel(x, y)[c]) << x << ", " << y;
    }
  EXPECT_GT(bright, 50);
}

TEST_F(Blooming, APieceThatGlowsSpreadsItsLight) {
  test::HandMade made;
  made.add(Form::sphere, {0.0, 20.0, 0.0}, 6.0, {0.2, 0.2, 0.2});
  made.frame.age.assign(made.frame.count, 0.0f);
  EXPECT_EQ(draw(made, true).rgba, draw(made, false).rgba) << "cold";
  made.layers.back().temperature_k = 1900.0;
  const Image without = draw(made, false), with = draw(made, true);
  EXPECT_GT(with.pixel(160 + 15, 90)[0], without.pixel(160 + 15, 90)[0]) << "beside it";
}

TEST_F(Blooming, WithoutBrightLightNothingChangesToTheLastBit) {
  test::HandMade made;
  made.add(Form::smoke, {0.0, 20.0, 0.0}, 12.0, {0.9, 0.9, 0.9});
  made.add(Form::sphere, {8.0, 20.0, 0.0}, 4.0, {1.0, 1.0, 1.0});
  made.add(Form::streak, {-8.0, 20.0, 0.0}, 2.0, {0.3, 0.2, 0.1}, 1.0, {10.0, 0.0, 0.0});
  EXPECT_EQ(draw(made, true, Background::Kind::sky).rgba, draw(made, false, Background::Kind::sky).rgba);
}

TEST_F(Blooming, FarFromTheLightThePictureStaysToTheLastBit) {
  auto made = flash(1.0);
  const Image with = draw(made, true, Background::Kind::sky, 640, 180), without = draw(made, false, Background::Kind::sky, 640, 180);
  for (int y = 0; y < 180; y += 5) EXPECT_TRUE(std::equal(with.pixel(0, y), with.pixel(40, y), without.pixel(0, y))) << y;
}

TEST_F(Blooming, ShowsTheSameAtAnySize) {
  // The same field of view in pictures of two, three and five times the pixels.
  const auto made = flash();
  const Image small = draw(made, true), plain = draw(made, false);
  for (const int factor : {2, 3, 5}) {
    const Image large = draw(made, true, Background::Kind::colour, 320 * factor, 180 * factor);
    for (const int d : {12, 18, 26}) {
      const double at_small = lightOf(small.pixel(160 + d, 90)[0]), at_large = lightOf(large.pixel(factor * (160 + d) + factor / 2, factor * 90 + factor / 2)[0]);
      EXPECT_NEAR(at_large, at_small, 0.25 * at_small + 0.01) << factor << " times, " << d << " aside; without " << lightOf(plain.pixel(160 + d, 90)[0]);
    }
  }
}

TEST_F(Blooming, ATransparentPictureHasAlphaForTheLightThatSpread) {
  const Image with = draw(flash(), true, Background::Kind::transparent), without = draw(flash(), false, Background::Kind::transparent);
  EXPECT_EQ(without.pixel(160 + 14, 90)[3], 0);
  EXPECT_GT(with.pixel(160 + 14, 90)[3], 0);
  EXPECT_GT(with.pixel(160 + 14, 90)[0], 200) << "straight alpha: the light's own colour";
  EXPECT_EQ(with.pixel(2, 2)[3], 0);
}

TEST_F(Blooming, TheSameAfterAnyOtherPicture) {
  const Image first = draw(flash(), true);
  draw(flash(9.0), true, Background::Kind::sky, 333, 211);
  draw(flash(9.0), true);
  EXPECT_EQ(draw(flash(), true).rgba, first.rgba);
}

TEST_F(Blooming, LinearLightSpreadsWithoutMoreCover) {
  const auto made = flash(1.5);
  FloatImage images[2];
  double light[2] = {}, cover[2] = {};
  for (int on = 0; on < 2; ++on) {
    ASSERT_TRUE(renderer_->drawToFloats(sceneOf(made, on == 1, Background::Kind::transparent), front(180), 320, 180, {}, images[on]));
    for (std::size_t i = 0; i < images[on].rgba.size(); ++i) (i % 4 == 3 ? cover : light)[on] += static_cast<double>(images[on].rgba[i]);
  }
  EXPECT_NE(images[0].rgba, images[1].rgba);
  EXPECT_NEAR(light[1], light[0], 0.03 * light[0]);
  EXPECT_EQ(cover[1], cover[0]);
}

TEST_F(Blooming, TinyPicturesAreDrawn) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 40), std::pair(40, 1), std::pair(7, 9), std::pair(33, 17)}) {
    const Image image = draw(flash(), true, Background::Kind::sky, width, height);
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
  }
}

}  // namespace
}  // namespace npsee::render
