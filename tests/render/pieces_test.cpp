// Pieces of models as they are drawn.

#include "app/render/image_compare.h"
#include "app/render/mission_scene.h"
#include "app/render/mission_wrecks.h"
#include "tests/support/explosions.h"
#include "tests/support/missions.h"
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

#include <cmath>

namespace npsee::render {
namespace {

Preset apart(const std::string& model, std::int64_t count) {
  Preset preset;
  preset.layers.emplace_back();
  Layer& layer = preset.layers[0];
  layer.form = Form::pieces;
  layer.count = count;
  layer.start_s = 1.0;
  layer.lifetime_mean_s = 30.0;
  layer.lifetime_deviation_s = 0.0;
  layer.colour = {0.5, 0.5, 0.4};
  layer.pieces_model = model;
  layer.pieces_density_kgpm3 = 400.0;
  layer.pieces_impulse_Pas = 6000.0;
  layer.pieces_burst_m = {0.2, 0.3, 0.1};
  return preset;
}

class PiecesRendering : public test::Rendering {
 protected:
  /// A still life of an explosion at a time.
  struct Still {
    std::shared_ptr<const Explosion> explosion;
    Frame frame;
    Scene scene;
  };
  static std::unique_ptr<Still> still(const Preset& preset, double t, Background::Kind background = Background::Kind::sky) {
    auto out = std::make_unique<Still>();
    out->explosion = test::compiled(preset);
    if (!out->explosion) return out;
    out->explosion->at(t, out->frame);
    out->scene.frame = &out->frame;
    out->scene.layers = out->explosion->layers();
    out->scene.ground_colour = {0.36, 0.34, 0.29};
    out->scene.background.kind = background;
    return out;
  }
  static Image draw(const Preset& preset, double t, Background::Kind background = Background::Kind::sky) {
    const auto from = still(preset, t, background);
    return picture(from->scene, camera(), 320, 200);
  }
  static Camera camera() {
    Camera out;
    out.eye = {9.0, 5.0, 11.0};
    out.target = {0.0, 1.0, 0.0};
    return out;
  }
  static int covered(const Image& image) {
    int count = 0;
    // A quarter of a pixel at nine tenths of the opacity counts.
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) count += image.rgba[i] > 40;
    return count;
  }
};

TEST_F(PiecesRendering, BeforeTheBurstManyPiecesLookLikeTheWholeModel) {
  for (const char* model : {"tank", "truck", "house"}) {
    const Image few = draw(apart(model, 1), 0.0), many = draw(apart(model, 250), 0.0);
    EXPECT_GT(structuralSimilarity(deepened(few), deepened(many)), 0.985) << model;
    EXPECT_GT(covered(draw(apart(model, 1), 0.0, Background::Kind::transparent)), 1500) << model;
  }
}

TEST_F(PiecesRendering, AfterTheBurstTheyAreSpread) {
  const Image before = draw(apart("truck", 120), 0.5), after = draw(apart("truck", 120), 2.0);
  EXPECT_LT(structuralSimilarity(deepened(before), deepened(after)), 0.97);
}

TEST_F(PiecesRendering, TheModelsOwnColoursAndTheLayersAreSeen) {
  Preset red = apart("truck", 60);
  red.layers[0].colour = {0.9, 0.1, 0.1};
  const Image image = draw(red, 0.0, Background::Kind::transparent);
  int reds = 0, others = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i + 3] < 255) continue;
    const bool is_red = image.rgba[i] > 2 * image.rgba[i + 1] + 20;
    ++(is_red ? reds : others);
  }
  EXPECT_GT(reds, 300) << "what is called body has the layer's colour";
  EXPECT_GT(others, 300) << "canvas and rubber have their own";
}

TEST_F(PiecesRendering, HotPiecesGlowAndCool) {
  for (const double opacity : {1.0, 0.9}) {
    Preset preset = apart("tank", 40);
    preset.layers[0].opacity = opacity;
    const auto red = [&](double temperature_k, double t) {
      preset.layers[0].temperature_k = temperature_k;
      preset.layers[0].cooling_s = 1.0;
      const Image image = draw(preset, t, Background::Kind::transparent);
      double sum = 0.0;
      for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += image.rgba[i + 3] > 40 ? image.rgba[i] - image.rgba[i + 2] : 0;
      return sum / std::max(covered(image), 1);
    };
    const double cold = red(0.0, 1.2), hot = red(1400.0, 1.2), late = red(1400.0, 9.0), late_cold = red(0.0, 9.0);
    EXPECT_GT(hot, cold + 60.0) << opacity;
    EXPECT_LT(late, late_cold + 10.0) << opacity << ": 770 K show no more by day";
  }
}

TEST_F(PiecesRendering, BlendedPiecesCoverWhatOpaqueOnesCover) {
  Preset faint = apart("tank", 40);
  const int opaque = covered(draw(faint, 1.6, Background::Kind::transparent));
  faint.layers[0].opacity = 0.9;
  const int blended = covered(draw(faint, 1.6, Background::Kind::transparent));
  EXPECT_GT(opaque, 1000);
  EXPECT_NEAR(blended, opaque, 0.02 * opaque);
}

TEST_F(PiecesRendering, TheShadowOfTheWholeIsDarkAndEven) {
  Preset preset = apart("block", 60);
  preset.layers[0].region_offset_m = {0.0, 4.0, 0.0};
  preset.layers[0].pieces_scale = 4.0;
  Camera above;
  above.eye = {0.0, 40.0, 0.01};
  above.target = {0.0, 0.0, 0.0};
  const auto with = still(preset, 0.0);
  Scene without = with->scene;
  without.frame = nullptr;
  const auto shaded = renderer_->drawToImage(with->scene, above, 320, 200), bare = renderer_->drawToImage(without, above, 320, 200);
  ASSERT_TRUE(shaded && bare);
  // Towards north-east of the block, where the afternoon sun throws it: (0.74, -0.66) m for each metre of height.
  int dark = 0;
  double darkest = 1.0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 320; ++x) {
      const double share = test::brightness(shaded->pixel(x, y)) / std::max(1.0, test::brightness(bare->pixel(x, y)));
      if (x > 175 && y < 95) {
        dark += share < 0.85;
        darkest = std::min(darkest, share);
      }
    }
  EXPECT_GT(dark, 300);
  EXPECT_GT(darkest, 0.4) << "sixty shadows on one another are as dark as one";
}

TEST_F(PiecesRendering, TheirShadowLiesOnBurntGroundToo) {
  Preset preset = apart("block", 60);
  preset.layers[0].region_offset_m = {0.0, 4.0, 0.0};
  preset.layers[0].pieces_scale = 4.0;
  preset.layers.emplace_back();
  Layer& burnt = preset.layers[1];
  burnt.name = "burnt";
  burnt.form = Form::scorch;
  burnt.count = 1;
  burnt.region_shape = RegionShape::point;
  burnt.size_mean_m = 60.0;
  burnt.size_deviation_m = 0.0;
  burnt.lifetime_mean_s = 30.0;
  burnt.lifetime_deviation_s = 0.0;
  burnt.colour = {0.3, 0.28, 0.26};
  burnt.opacity = 0.95;
  Preset bare = preset;
  bare.layers.erase(bare.layers.begin());
  Camera above;
  above.eye = {0.0, 40.0, 0.01};
  above.target = {0.0, 0.0, 0.0};
  const auto with = still(preset, 0.2), without = still(bare, 0.2);
  const auto shaded = renderer_->drawToImage(with->scene, above, 320, 200), lit = renderer_->drawToImage(without->scene, above, 320, 200);
  ASSERT_TRUE(shaded && lit);
  int dark = 0;
  for (int y = 0; y < 95; ++y)
    for (int x = 176; x < 320; ++x) dark += test::brightness(shaded->pixel(x, y)) < 0.85 * test::brightness(lit->pixel(x, y));
  EXPECT_GT(dark, 300);
}

TEST_F(PiecesRendering, DepthAndMotionAreThoseOfThePieces) {
  const auto from = still(apart("tank", 60), 1.5);
  FloatRequest request;
  request.colour = false;
  request.depth = request.motion = true;
  FloatImage image;
  ASSERT_TRUE(renderer_->drawToFloats(from->scene, camera(), 320, 200, request, image));
  const double whole = length(camera().eye - camera().target);
  int near = 0, moving = 0;
  for (std::size_t i = 0; i < image.depth.size(); ++i) {
    near += std::isfinite(image.depth[i]) && static_cast<double>(image.depth[i]) < whole - 0.5 && static_cast<double>(image.depth[i]) > 2.0;
    moving += std::abs(image.motion[2 * i]) + std::abs(image.motion[2 * i + 1]) > 0.5f;
  }
  EXPECT_GT(near, 200);
  EXPECT_GT(moving, 500);
  // Standing, nothing moves.
  const auto standing = still(apart("tank", 60), 0.5);
  ASSERT_TRUE(renderer_->drawToFloats(standing->scene, camera(), 320, 200, request, image));
  for (const float value : image.motion) EXPECT_EQ(value, 0.0f);
}

TEST_F(PiecesRendering, NoPieceAtRestIsInTheGround) {
  const Preset preset = apart("truck", 90);
  const auto from = still(preset, 25.0);
  const Fragments& fragments = *from->explosion->layers()[0].pieces;
  int lying = 0;
  for (std::size_t i = 0; i < from->frame.count; ++i) {
    // Panes of glass beside the burst are still in the air.
    if (from->frame.vx[i] != 0.0f || from->frame.vy[i] != 0.0f || from->frame.vz[i] != 0.0f) continue;
    const double q[4] = {from->frame.qx[i], from->frame.qy[i], from->frame.qz[i], from->frame.qw[i]};
    const Vec3 up{2.0 * (q[0] * q[1] + q[3] * q[2]), 1.0 - 2.0 * (q[0] * q[0] + q[2] * q[2]), 2.0 * (q[1] * q[2] - q[3] * q[0])};
    double lowest = 1e9;
    for (const Vec3& p : fragments.pieces[i].solid.points) lowest = std::min(lowest, static_cast<double>(from->frame.y[i]) + dot(up, p));
    // A piece lies on a face of its own: a share of its size at most is under the ground, and none of it hovers.
    EXPECT_GT(lowest, -0.03 * fragments.pieces[i].radius_m - 1e-4) << i;
    EXPECT_LT(lowest, 0.03 * fragments.pieces[i].radius_m + 1e-4) << i;
    lying += std::abs(lowest) < 0.02 * fragments.pieces[i].radius_m + 1e-4;
  }
  EXPECT_GT(lying, 80);
}

/// A tank on a plain, destroyed at 10 s by a shell beside it.
struct DeadTank {
  test::HandRecording made;
  explicit DeadTank(double miss_m, TargetClass kind = TargetClass::heavy_armor) : made(test::terrainOf({}, 2000.0)) {
    const int tank = made.vehicle(1000.0, 1000.0, Side::hostile, kind);
    const double y = made.recording.terrain.surface(1000.0 + miss_m, 1000.0);
    made.burst({1000.0 + miss_m, y, 1000.0}, 10.0, "impact_small");
    made.recording.vehicles[static_cast<std::size_t>(tank)].damage.push_back({10.0, 1.0, false, false});
  }
};

MissionView closeUp() {
  MissionView view;
  view.camera.kind = MissionCamera::Kind::free;
  view.camera.eye = {1014.0, 8.0, 1018.0};
  view.camera.target = {1000.0, 1.5, 1000.0};
  view.overlays = {};
  view.overlays.icons = view.overlays.scorch = view.overlays.contours = false;
  return view;
}

TEST_F(PiecesRendering, AVehicleDestroyedByACloseBurstComesApart) {
  const DeadTank tank(2.0);
  const Recording& recording = tank.made.recording;
  EXPECT_FALSE(undoingOf(recording, 0, 9.99));
  const auto undoing = undoingOf(recording, 0, 40.0);
  ASSERT_TRUE(undoing);
  EXPECT_EQ(undoing->time_s, 10.0);
  EXPECT_EQ(undoing->burst_m.x, 1002.0);
  auto scene = MissionScene::make(recording);
  ASSERT_TRUE(scene);
  Image image;
  ASSERT_TRUE(renderer_->drawToImage(**scene, recording, 9.9, closeUp(), 320, 200, image));
  EXPECT_EQ((*scene)->counts().models, 1u);
  ASSERT_TRUE(renderer_->drawToImage(**scene, recording, 12.0, closeUp(), 320, 200, image));
  EXPECT_EQ((*scene)->counts().models, 0u);
  EXPECT_GT((*scene)->counts().particles, 40u);
}

TEST_F(PiecesRendering, WhatAVehicleCarriesGoesOffWhereTheBurstIsNotThatClose) {
  const auto undoing = undoingOf(DeadTank(20.0).made.recording, 0, 40.0);
  ASSERT_TRUE(undoing);
  EXPECT_FALSE(undoing->shell);
  EXPECT_NEAR(undoing->burst_m.x, 1000.7, 1e-6) << "inside, on the burst's side";
}

TEST_F(PiecesRendering, OneDestroyedFromAfarAndFiguresStayWhole) {
  EXPECT_FALSE(undoingOf(DeadTank(40.0).made.recording, 0, 40.0));
  EXPECT_FALSE(undoingOf(DeadTank(2.0, TargetClass::personnel).made.recording, 0, 40.0));
}

TEST_F(PiecesRendering, SeekingToAWreckGivesTheBytesOfPlayingToIt) {
  const DeadTank tank(1.5);
  const Recording& recording = tank.made.recording;
  auto played = MissionScene::make(recording), sought = MissionScene::make(recording);
  ASSERT_TRUE(played && sought);
  Image a, b;
  for (const double t : {9.0, 10.2, 11.0, 12.4}) ASSERT_TRUE(renderer_->drawToImage(**played, recording, t, closeUp(), 320, 200, a));
  ASSERT_TRUE(renderer_->drawToImage(**sought, recording, 12.4, closeUp(), 320, 200, b));
  EXPECT_EQ(a.rgba, b.rgba);
}

}  // namespace
}  // namespace npsee::render
