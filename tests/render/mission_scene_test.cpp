#include "app/gl/objects.h"
#include "app/render/mission_scene.h"
#include "app/render/renderer.h"
#include "tests/support/missions.h"

#include <gtest/gtest.h>

namespace npsee::render {
namespace {

class Missions : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = gl::makeOffscreenContext();
    ASSERT_TRUE(made) << made.error().text();
    context_ = made->release();
    auto renderer = Renderer::create();
    ASSERT_TRUE(renderer) << renderer.error().text();
    renderer_ = renderer->release();
  }
  static void TearDownTestSuite() {
    delete renderer_;
    delete context_;
  }
  void SetUp() override { ASSERT_NE(renderer_, nullptr); }
  void TearDown() override { EXPECT_EQ(gl::pendingError(), nullptr); }

  static Image draw(const Recording& recording, double time_s, const MissionView& view, int width = 480, int height = 270) {
    auto scene = MissionScene::make(recording);
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().text());
    Image image;
    if (scene) {
      const auto drawn = renderer_->drawToImage(**scene, recording, time_s, view, width, height, image);
      EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().text());
    }
    return image;
  }

  static gl::Context* context_;
  static Renderer* renderer_;
};
gl::Context* Missions::context_ = nullptr;
Renderer* Missions::renderer_ = nullptr;

double brightness(const std::uint8_t* p) { return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]; }

Terrain cone() {
  TerrainSource source;
  source.kind = TerrainKind::function;
  source.expression = "cone";
  source.params = {{"top_x", 2000.0}, {"top_z", 2000.0}, {"top_height", 500.0}, {"radius", 1200.0}, {"base_height", 20.0}};
  return test::terrainOf(source, 4000.0);
}

MissionView fromAbove(const Vec3& target, double span_m) {
  MissionView view;
  view.camera.kind = MissionCamera::Kind::plan;
  view.camera.target = target;
  view.camera.span_m = span_m;
  view.overlays.contours = false;
  view.overlays.icons = false;
  return view;
}

TEST_F(Missions, SlopesTurnedToTheSunAreBrighter) {
  const test::HandRecording made(cone());
  const Image image = draw(made.recording, 0.0, fromAbove({2000.0, 0.0, 2000.0}, 3000.0));
  // The sun stands in the south-west: the cone's flank there against the one in the north-east.
  double lit = 0.0, shaded = 0.0;
  for (int k = 20; k < 60; ++k) {
    lit += brightness(image.pixel(240 - k, 135 + k));
    shaded += brightness(image.pixel(240 + k, 135 - k));
  }
  EXPECT_GT(lit, 1.3 * shaded);
}

TEST_F(Missions, TheSeaCoversWhatLiesBelowItsLevel) {
  TerrainSource source;
  source.kind = TerrainKind::function;
  source.expression = "slope";
  source.params = {{"from", 1900.0}, {"to", 2100.0}, {"low", -30.0}, {"high", 30.0}};
  const test::HandRecording made(test::terrainOf(source, 4000.0));
  const Image image = draw(made.recording, 0.0, fromAbove({2000.0, 0.0, 2000.0}, 1000.0));
  // West of the shore at x = 2000 the sea is blue, east of it the land is not.
  for (int y = 20; y < 250; y += 10) {
    const std::uint8_t *sea = image.pixel(140, y), *land = image.pixel(340, y);
    EXPECT_GT(sea[2], sea[0] + 10) << y;
    EXPECT_GT(land[0], land[2]) << y;
  }
}

TEST_F(Missions, NoSkyIsSeenThroughTheGround) {
  TerrainSource source;
  source.kind = TerrainKind::hills;
  source.relief_m = 600.0;
  source.scale_m = 3000.0;
  source.sea_fraction = 0.0;
  source.seed = 3;
  const Terrain terrain = test::terrainOf(source, 15000.0, -100.0);
  const test::HandRecording made(terrain);
  MissionView view;
  view.camera.kind = MissionCamera::Kind::free;
  view.camera.eye = {7000.0, terrain.surface(7000.0, 7000.0) + 500.0, 7000.0};
  view.camera.target = view.camera.eye + Vec3{300.0, -400.0, -500.0};
  view.overlays = {};
  view.smooth = false;
  const Image image = draw(made.recording, 0.0, view);
  // The sky is the only thing here that is bluer than it is red.
  int holes = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) holes += image.pixel(x, y)[2] > image.pixel(x, y)[0] + 25;
  EXPECT_EQ(holes, 0);
}

TEST_F(Missions, TheSameMomentGivesTheSameBytesWhateverWasDrawnBefore) {
  test::HandRecording made(cone());
  made.vehicle(1500.0, 3300.0, Side::hostile);
  made.observer(800.0, 3600.0);
  made.burst({1500.0, made.recording.terrain.surface(1500.0, 3350.0), 3350.0}, 3.0, "air_burst");
  MissionView view;
  view.camera.target = {1500.0, 40.0, 3300.0};
  view.camera.distance_m = 200.0;
  const Image first = draw(made.recording, 3.5, view);
  auto scene = MissionScene::make(made.recording);
  ASSERT_TRUE(scene);
  Image image;
  for (const double t : {0.0, 10.0, 3.2}) ASSERT_TRUE(renderer_->drawToImage(**scene, made.recording, t, fromAbove({2000.0, 0.0, 2000.0}, 3000.0), 200, 200, image));
  view.threads = 3;
  ASSERT_TRUE(renderer_->drawToImage(**scene, made.recording, 3.5, view, 480, 270, image));
  EXPECT_EQ(image.rgba, first.rgba);
}

}  // namespace
}  // namespace npsee::render
