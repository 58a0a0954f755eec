#include "app/render/effect_tiles.h"
#include "app/render/renderer.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

namespace npsee::render {
namespace {

TEST(Tiles, AMarkTouchesExactlyTheTilesItOverlaps) {
  TileMask mask;
  mask.reset(100, 50);
  EXPECT_EQ(mask.columns(), 7);
  EXPECT_EQ(mask.rows(), 4);
  EXPECT_TRUE(mask.empty());
  mask.mark({15.0, 40.0, 33.0, 90.0});
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 7; ++column) EXPECT_EQ(mask.touched(column, row), row >= 2 && column <= 2) << column << ' ' << row;
}

TEST(Tiles, MarksOutsideThePictureTouchNothing) {
  TileMask mask;
  mask.reset(100, 50);
  mask.mark({-30.0, 0.0, -1.0, 10.0});
  mask.mark({100.0, 0.0, 130.0, 10.0});
  mask.mark({0.0, 50.0, 10.0, 60.0});
  EXPECT_TRUE(mask.empty());
}

/// Draws one particle at a time and compares the pixels that changed with the tiles foretold.
TEST(Tiles, NothingIsDrawnOutsideTheTilesForetold) {
  auto context = gl::makeOffscreenContext();
  ASSERT_TRUE(context) << context.error().text();
  auto renderer = Renderer::create();
  ASSERT_TRUE(renderer) << renderer.error().text();
  constexpr int kWidth = 320, kHeight = 180;
  Camera camera;
  camera.eye = {3.0, 4.0, 25.0};
  camera.target = {0.0, 3.0, 0.0};
  Scene scene;
  // Grey: light on the ground shows on it as well as shadows do.
  scene.background = {Background::Kind::colour, {0.5, 0.5, 0.5}};
  const View view = makeView(camera, kWidth, kHeight);
  int seen = 0;
  for (const Form form : {Form::tetrahedron, Form::disc, Form::sphere, Form::shard, Form::streak, Form::smoke, Form::fire, Form::flash})
    for (const Vec3& at : {Vec3{0.0, 5.0, 0.0}, {0.0, 0.0, 0.0}, {-9.0, 8.0, -6.0}, {7.0, 0.3, 12.0}, {2.0, 3.0, 22.0}, {0.0, 60.0, 0.0}, {0.0, -0.2, 3.0}})
      for (const double size : {0.02, 0.5, 3.0}) {
        test::HandMade made;
        made.add(form, at, size, {0.1, 0.1, 0.1}, 1.0, {20.0, -30.0, 10.0});
        scene.frame = &made.frame;
        scene.layers = made.layers;
        TileMask mask;
        mask.reset(kWidth, kHeight);
        GroundLevel ground;
        ground.glow = glowOf(made.frame, made.layers);
        markEffect(mask, made.frame, made.layers, view, ground, true);
        // The tiles foretold are all the renderer draws in; a particle added that marks every tile shows what it would draw.
        const auto cut = (*renderer)->drawToImage(scene, camera, kWidth, kHeight);
        made.add(form, camera.eye, 0.001, {1.0, 1.0, 1.0}, 0.0);
        scene.frame = &made.frame;
        scene.layers = made.layers;
        const auto whole = (*renderer)->drawToImage(scene, camera, kWidth, kHeight);
        ASSERT_TRUE(cut && whole);
        EXPECT_EQ(cut->rgba, whole->rgba) << "form " << static_cast<int>(form) << " at " << at.x << ' ' << at.y << ' ' << at.z << " size " << size;
        for (int i = 0; i < kWidth * kHeight; ++i) seen += whole->rgba[4u * i] != 128;
      }
  EXPECT_GT(seen, 10'000) << "the comparison saw something";
}

}  // namespace
}  // namespace npsee::render
