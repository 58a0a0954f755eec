#include "tests/support/random_preset.h"
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace npsee::render {
namespace {

class TemplatePixels : public test::Rendering {
 protected:
  void SetUp() override {
    test::Rendering::SetUp();
    preset_.layers.emplace_back();
    scene_.preset = &preset_;
  }

  Layer& layer() { return preset_.layers[0]; }
  Image draw(int width = 240, int height = 200) const {
    return picture(scene_, width, height);
  }

  Preset preset_;
  TemplateScene scene_;
};

/// Share of pixels that differ by more than 8 of 255 in a component.
double difference(const Image& a, const Image& b) {
  EXPECT_EQ(a.rgba.size(), b.rgba.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t k = 0; k < 4; ++k) most = std::max(most, std::abs(a.rgba[i + k] - b.rgba[i + k]));
    count += most > 8;
  }
  return 4.0 * static_cast<double>(count) / static_cast<double>(a.rgba.size());
}

struct Box {
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;
  int width() const { return right - left + 1; }
  int height() const { return bottom - top + 1; }
};

/// Bounds of the pixels that the template's blue dominates, above a row.
Box blueBox(const Image& image, int below) {
  Box box;
  for (int y = 0; y < std::min(below, image.height); ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.pixel(x, y);
      if (p[2] < p[0] + 28) continue;
      box = {std::min(box.left, x), std::max(box.right, x), std::min(box.top, y), std::max(box.bottom, y)};
    }
  return box;
}

TEST_F(TemplatePixels, EachViewDrawsAShapeOnTheQuietBackground) {
  for (const TemplateView view : {TemplateView::splines, TemplateView::polygons, TemplateView::surface}) {
    scene_.view = view;
    const Image image = draw();
    const std::uint8_t* corner = image.pixel(0, 0);
    EXPECT_EQ(corner[0], 0x1e);
    EXPECT_EQ(corner[1], 0x21);
    EXPECT_EQ(corner[2], 0x27);
    const Box box = blueBox(image, image.height);
    EXPECT_GT(box.width(), image.width / 4);
    EXPECT_LT(box.width(), image.width);
    EXPECT_GT(box.height(), image.height / 5);
  }
}

TEST_F(TemplatePixels, TheThreeViewsDiffer) {
  std::vector<Image> images;
  for (const TemplateView view : {TemplateView::splines, TemplateView::polygons, TemplateView::surface}) {
    scene_.view = view;
    images.push_back(draw());
  }
  EXPECT_GT(difference(images[0], images[1]), 0.02);
  EXPECT_GT(difference(images[1], images[2]), 0.02);
  EXPECT_GT(difference(images[0], images[2]), 0.02);
}

TEST_F(TemplatePixels, EverySettingThatTheShapeEncodesChangesThePicture) {
  const Image before = draw();
  const auto changed = [&](auto change) {
    const Layer kept = layer();
    change(layer());
    const double share = difference(before, draw());
    layer() = kept;
    return share;
  };
  EXPECT_GT(changed([](Layer& l) { l.ejection_angle_rad *= 0.7; }), 0.01);
  EXPECT_GT(changed([](Layer& l) { l.speed_mean_mps *= 2.0; }), 0.01);
  EXPECT_GT(changed([](Layer& l) { l.size_mean_m *= 3.0; }), 0.01);
  EXPECT_GT(changed([](Layer& l) { l.region_radius_m *= 3.0; }), 0.01);
  EXPECT_GT(changed([](Layer& l) { l.directionality = Directionality::neutral; }), 0.05);
  EXPECT_EQ(changed([](Layer& l) { l.restitution = 0.9; }), 0.0);
}

TEST_F(TemplatePixels, ALargerEjectionAngleMakesAWiderPictureAndAHigherSpeedATallerOne) {
  const Box before = blueBox(draw(), 1000);
  layer().ejection_angle_rad = 1.4;
  const Box leaning = blueBox(draw(), 1000);
  EXPECT_GT(leaning.width(), before.width() + 4);
  layer().ejection_angle_rad = Layer().ejection_angle_rad;
  layer().speed_mean_mps = 150.0;
  EXPECT_GT(blueBox(draw(), 1000).height(), before.height() + 10);
}

TEST_F(TemplatePixels, AnAirBurstIsRoundFromEverySide) {
  preset_.burst = BurstKind::air;
  layer().speed_mean_mps = 60.0;
  // Without a background only the ball itself is opaque; lines and base plane let light through.
  scene_.background.kind = Background::Kind::transparent;
  for (const double yaw : {0.0, 0.6, 2.5})
    for (const double pitch : {-0.5, 0.0, 0.35, 1.2}) {
      scene_.yaw_rad = yaw;
      scene_.pitch_rad = pitch;
      const Image image = draw(400, 400);
      Box box;
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
          if (image.pixel(x, y)[3] > 250) box = {std::min(box.left, x), std::max(box.right, x), std::min(box.top, y), std::max(box.bottom, y)};
      EXPECT_GT(box.width(), 100);
      EXPECT_NEAR(box.width(), box.height(), 2) << "yaw " << yaw << " pitch " << pitch;
      EXPECT_NEAR(box.left + box.right, 399, 3);
      EXPECT_NEAR(box.top + box.bottom, 399, 3);
    }
}

TEST_F(TemplatePixels, ATransparentBackgroundLeavesTheCornersClear) {
  scene_.background.kind = Background::Kind::transparent;
  const Image image = draw();
  EXPECT_EQ(image.pixel(0, 0)[3], 0);
  EXPECT_EQ(image.pixel(image.width / 2, image.height / 2)[3], 255);
}

TEST_F(TemplatePixels, ABackgroundColourIsKeptAndTurnsLinesDarkOnLight) {
  scene_.background = {Background::Kind::colour, {1.0, 1.0, 1.0}};
  scene_.view = TemplateView::splines;
  const Image image = draw();
  EXPECT_EQ(image.pixel(0, 0)[0], 255);
  EXPECT_EQ(image.pixel(0, 0)[2], 255);
  int darkest = 255;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) darkest = std::min<int>(darkest, image.rgba[i]);
  EXPECT_LT(darkest, 80);
}

TEST_F(TemplatePixels, HandlesAreDrawnWhenAskedForAndTheActiveOneInTheAccentColour) {
  const Image without = draw();
  scene_.handles = true;
  const Image with = draw();
  scene_.active = TemplateHandle::rim;
  const Image active = draw();
  EXPECT_GT(difference(without, with), 0.0);
  const auto amber = [](const Image& image) {
    int count = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) count += image.rgba[i] > 220 && image.rgba[i + 2] < 100;
    return count;
  };
  EXPECT_EQ(amber(with), 0);
  EXPECT_GT(amber(active), 20);
}

TEST_F(TemplatePixels, TheSameSceneGivesTheSameBytesWhateverWasDrawnBefore) {
  const Image first = draw();
  scene_.view = TemplateView::splines;
  preset_.burst = BurstKind::air;
  draw(100, 300);
  scene_.view = TemplateView::surface;
  preset_.burst = BurstKind::ground;
  EXPECT_EQ(draw().rgba, first.rgba);
}

TEST_F(TemplatePixels, AnyPresetAndAnySizeIsDrawnWithoutADriverError) {
  std::mt19937_64 random(21);
  for (int trial = 0; trial < 40; ++trial) {
    preset_ = test::randomPreset(random);
    scene_.view = static_cast<TemplateView>(trial % 3);
    scene_.yaw_rad = test::between(random, -4, 4);
    scene_.pitch_rad = test::between(random, -1.6, 1.6);
    const int width = 1 + static_cast<int>(random() % 200), height = 1 + static_cast<int>(random() % 200);
    EXPECT_EQ(draw(width, height).rgba.size(), static_cast<std::size_t>(width) * height * 4);
  }
}

TEST_F(TemplatePixels, AMissingLayerIsRefusedByName) {
  scene_.layer = 3;
  const auto image = renderer_->drawToImage(scene_, 64, 64);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().kind, ErrorKind::usage);
  EXPECT_NE(image.error().text().find("there is no layer 3"), std::string::npos);
  scene_.preset = nullptr;
  EXPECT_FALSE(renderer_->drawToTexture(scene_, 64, 64));
}

/// Mean difference per component, of 255, between a picture and one of half its size.
double meanDifference(const Image& large, const Image& small) {
  double sum = 0.0;
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x)
      for (int k = 0; k < 3; ++k) {
        const int four = large.pixel(2 * x, 2 * y)[k] + large.pixel(2 * x + 1, 2 * y)[k] + large.pixel(2 * x, 2 * y + 1)[k] + large.pixel(2 * x + 1, 2 * y + 1)[k];
        sum += std::abs(0.25 * four - small.pixel(x, y)[k]);
      }
  return sum / (3.0 * small.width * small.height);
}

TEST_F(TemplatePixels, WithTwiceTheScaleLinesAndDotsOfAPictureTwiceAsLargeGrowAlong) {
  scene_.handles = true;
  for (const TemplateView view : {TemplateView::splines, TemplateView::polygons, TemplateView::surface}) {
    scene_.view = view;
    scene_.scale = 1.0;
    const Image small = draw(320, 240), thin = draw(640, 480);
    scene_.scale = 2.0;
    const Image large = draw(640, 480);
    EXPECT_LT(meanDifference(large, small), 0.5 * meanDifference(thin, small)) << static_cast<int>(view);
    // The dot on top is opaque text colour in its middle: its diameter of 8 grows to 16 pixels.
    const TemplateShape shape = templateShape(preset_, 0);
    const TemplateCamera camera(shape, scene_.yaw_rad, scene_.pitch_rad, 640, 480);
    const auto at = camera.project(shape.handle(TemplateHandle::top));
    for (const int away : {0, 3, 6}) {
      const int x = static_cast<int>(at.x) + away, y = static_cast<int>(at.y);
      EXPECT_GT(large.pixel(x, y)[0], 180) << away;
      EXPECT_EQ(thin.pixel(x, y)[0] > 180, away < 4) << away;
    }
  }
}

}  // namespace
}  // namespace npsee::render
