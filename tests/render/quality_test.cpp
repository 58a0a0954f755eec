#include "app/render/fine_frames.h"
#include "app/render/image_compare.h"
#include "tests/support/rendering.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace npsee::render {
namespace {

class Qualities : public test::Rendering {
 protected:
  static Image draw(const test::HandMade& made, Quality quality, int width = 640, int height = 360, Background::Kind background = Background::Kind::sky) {
    Scene scene;
    scene.frame = &made.frame;
    scene.layers = made.layers;
    scene.ground_colour = {0.46, 0.44, 0.38};
    scene.background.kind = background;
    scene.quality = quality;
    Camera camera;
    camera.eye = {0.0, 12.0, 60.0};
    camera.target = {0.0, 10.0, 0.0};
    return picture(scene, camera, width, height);
  }
  static test::HandMade burst() {
    test::HandMade made;
    made.addDome(Form::smoke, 120, 14.0, 6.0, {0.5, 0.48, 0.44}, 0.6);
    made.addDome(Form::tetrahedron, 150, 18.0, 0.6);
    made.addDome(Form::fire, 30, 6.0, 4.0, {1.0, 0.6, 0.2}, 0.8);
    return made;
  }
};

TEST_F(Qualities, ADraftResemblesTheNormalPicture) {
  const auto made = burst();
  for (const auto background : {Background::Kind::sky, Background::Kind::transparent, Background::Kind::colour}) {
    const auto d = compareImages(deepened(draw(made, Quality::normal, 640, 360, background)), deepened(draw(made, Quality::draft, 640, 360, background)));
    EXPECT_GT(d.ssim, 0.85);
    EXPECT_LT(d.mean, 6.0);
    EXPECT_GT(d.max, 0.0) << "it is another picture";
  }
}

TEST_F(Qualities, ADraftOfAnyOddSizeLiesWhereTheNormalPictureDoes) {
  test::HandMade made;
  made.add(Form::sphere, {0.0, 10.0, 0.0}, 10.0, {1.0, 1.0, 1.0});
  for (const auto& [width, height] : {std::pair(321, 181), std::pair(320, 181), std::pair(321, 180), std::pair(64, 33)}) {
    double centre[2][2] = {};
    for (int q = 0; q < 2; ++q) {
      const Image image = draw(made, q == 0 ? Quality::draft : Quality::normal, width, height, Background::Kind::transparent);
      double sum = 0.0;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const double a = image.pixel(x, y)[3];
          sum += a, centre[q][0] += a * x, centre[q][1] += a * y;
        }
      ASSERT_GT(sum, 0.0);
      for (double& c : centre[q]) c /= sum;
    }
    EXPECT_NEAR(centre[0][0], centre[1][0], 0.35) << width << " x " << height;
    EXPECT_NEAR(centre[0][1], centre[1][1], 0.35) << width << " x " << height;
  }
}

TEST_F(Qualities, ADraftDoesNotDependOnThePictureBeforeIt) {
  test::HandMade small;
  small.add(Form::smoke, {0.0, 10.0, 0.0}, 4.0, {1.0, 1.0, 1.0});
  const Image first = draw(small, Quality::draft);
  for (const Quality quality : {Quality::draft, Quality::normal, Quality::fine}) {
    draw(burst(), quality);
    EXPECT_EQ(draw(small, Quality::draft).rgba, first.rgba);
  }
}

TEST(FineFrames, LooksAreSpreadEvenlyOverThePixelAndTheShutter) {
  std::set<long> times;
  double sum = 0.0;
  for (int look = 0; look < FineFrames::kLooks; ++look) {
    const double t = FineFrames::timeOf(look);
    EXPECT_LT(std::abs(t), 0.5 * kShutter_s);
    times.insert(std::lround((t / kShutter_s + 0.5) * FineFrames::kLooks - 0.5));
    sum += t;
  }
  EXPECT_EQ(times.size(), 16u);
  EXPECT_NEAR(sum, 0.0, 1e-12);
}

TEST_F(Qualities, FineIsTheNormalPictureWhereNothingMoves) {
  test::HandMade made;
  made.add(Form::sphere, {0.0, 10.0, 0.0}, 8.0, {0.8, 0.3, 0.2});
  const auto d = compareImages(deepened(draw(made, Quality::normal)), deepened(draw(made, Quality::fine)));
  EXPECT_GT(d.ssim, 0.99);
  EXPECT_LT(d.mean, 0.5);
}

TEST_F(Qualities, FineEdgesHaveMoreSteps) {
  test::HandMade made;
  made.add(Form::disc, {0.0, 10.0, 0.0}, 16.0, {1.0, 1.0, 1.0});
  std::set<int> steps[2];
  for (int q = 0; q < 2; ++q) {
    const Image image = draw(made, q == 0 ? Quality::normal : Quality::fine, 320, 180, Background::Kind::transparent);
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) steps[q].insert(image.rgba[i]);
  }
  EXPECT_LE(steps[0].size(), 5u) << "four samples";
  EXPECT_GT(steps[1].size(), 10u) << "sixteen";
}

TEST_F(Qualities, FineBlursAPieceAlongItsWayAsFarAsTheShutterIsOpen) {
  for (const double speed : {0.0, 400.0}) {
    test::HandMade made;
    made.add(Form::sphere, {0.0, 10.0, 0.0}, 2.0, {1.0, 1.0, 1.0}, 1.0, {speed, 0.0, 0.0});
    const Image normal = draw(made, Quality::normal, 640, 360, Background::Kind::transparent), fine = draw(made, Quality::fine, 640, 360, Background::Kind::transparent);
    const auto width = [](const Image& image) {
      int low = image.width, high = 0;
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
          if (image.pixel(x, y)[3] > 4) low = std::min(low, x), high = std::max(high, x);
      return high - low + 1;
    };
    const double pixel_m = 2.0 * std::tan(0.5 * Camera{}.fov_y_rad) * 60.0 / 360.0;
    // 15 of 16 parts of the way, from the middle of the first to that of the last.
    EXPECT_NEAR(width(fine) - width(normal), 15.0 / 16.0 * speed * kShutter_s / pixel_m, 3.0) << speed;
  }
}

TEST_F(Qualities, BandsOfRowsShowTheSameAsTheWholePicture) {
  auto made = burst();
  made.addDome(Form::flash, 3, 4.0, 5.0, {1.0, 0.9, 0.7});
  Camera camera;
  camera.eye = {0.0, 12.0, 60.0};
  camera.target = {0.0, 10.0, 0.0};
  for (const Quality quality : {Quality::draft, Quality::normal}) {
    Scene scene;
    scene.frame = &made.frame;
    scene.layers = made.layers;
    scene.quality = quality;
    for (const bool linear : {false, true}) {
      const FloatRequest request{.linear = linear, .depth = true, .motion = true};
      FloatImage whole, rows;
      ASSERT_TRUE(renderer_->drawToFloats(scene, camera, 321, 181, request, whole));
      int next = 0;
      ASSERT_TRUE(renderer_->drawToRows(scene, camera, 321, 181, request, [&](int first, FloatImage& band) {
        EXPECT_EQ(first, next);
        EXPECT_EQ(band.width, 321);
        next += band.height;
        for (const auto& [from, to] : {std::pair(&band.rgba, &rows.rgba), std::pair(&band.depth, &rows.depth), std::pair(&band.motion, &rows.motion)}) to->insert(to->end(), from->begin(), from->end());
        return Expected<void>();
      }, 48));
      EXPECT_EQ(next, 181);
      EXPECT_EQ(rows.rgba, whole.rgba);
      ASSERT_EQ(rows.depth.size(), whole.depth.size());
      ASSERT_EQ(rows.motion.size(), whole.motion.size());
      // At a rim rounding may give a pixel to what lies behind; towards the horizon the ground's depth goes up steeply.
      std::size_t other = 0;
      for (std::size_t i = 0; i < rows.depth.size(); ++i) other += !(rows.depth[i] == whole.depth[i] || std::abs(rows.depth[i] - whole.depth[i]) < 0.001f * whole.depth[i]);
      for (std::size_t i = 0; i < rows.motion.size(); ++i) other += std::abs(rows.motion[i] - whole.motion[i]) > 0.01f;
      EXPECT_LT(other, 20u);
    }
  }
}

TEST_F(Qualities, AnErrorOfWhoTakesTheRowsEndsThePicture) {
  int bands = 0;
  const auto drawn = renderer_->drawToRows({}, {}, 64, 64, {}, [&](int, FloatImage&) -> Expected<void> { ++bands; return fail(ErrorKind::output, "no room"); }, 16);
  ASSERT_FALSE(drawn);
  EXPECT_EQ(drawn.error().kind, ErrorKind::output);
  EXPECT_EQ(bands, 1);
}

TEST_F(Qualities, PassesAreToldInOrder) {
  std::vector<std::string> told;
  renderer_->watchPasses([&](std::string_view pass) { told.emplace_back(pass); });
  draw(burst(), Quality::normal);
  renderer_->watchPasses({});
  EXPECT_EQ(told, (std::vector<std::string>{"backdrop", "clear", "scorch", "shadow", "glow", "ring", "solid", "settle", "blended", "shell", "bloom", "finish", "read"}));
}

}  // namespace
}  // namespace npsee::render
