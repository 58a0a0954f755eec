#include "app/render/glow.h"

#include "tests/support/rendering.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace npsee::render {
namespace {

constexpr int kWidth = 320, kHeight = 180;

/// Seen from straight above, so that pixels are places: the picture's middle is the burst.
Camera above() {
  Camera camera;
  camera.eye = {0.0, 200.0, 0.0};
  camera.target = {0.0, 0.0, 0.0};
  return camera;
}

Scene outdoors(const test::HandMade& made) {
  Scene scene;
  scene.frame = &made.frame;
  scene.layers = made.layers;
  scene.grid = false;
  scene.ground_colour = {0.46, 0.44, 0.38};
  return scene;
}

struct Glowing : test::Rendering {
  Image draw(const Scene& scene, const Camera& camera) {
    return picture(scene, camera, kWidth, kHeight);
  }
};

int brightness(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return p[0] + p[1] + p[2];
}

TEST(Glow, OneFlashShinesFromItsPlaceWithItsAreaAndColour) {
  test::HandMade made;
  made.add(Form::flash, {3.0, 4.0, -5.0}, 6.0, {1.0, 1.0, 1.0}, 0.5);
  const Glow glow = glowOf(made.frame, made.layers);
  ASSERT_TRUE(glow.shines());
  EXPECT_EQ(glow.place, (Vec3{3.0, 4.0, -5.0}));
  EXPECT_NEAR(glow.radius_m, 3.0, 1e-12);
  EXPECT_NEAR(glow.light_m2.x, 7.0 * 9.0 * 0.5, 1e-5) << "seven times white, over the squared radius, half there";
  // At its reach a facing surface gets exactly the least light that counts.
  EXPECT_NEAR(glow.light_m2.x / (glow.reach() * glow.reach()), kLeastGlow, 1e-12);
}

TEST(Glow, WhatDoesNotBurnDoesNotShine) {
  test::HandMade made;
  for (const Form form : {Form::tetrahedron, Form::disc, Form::sphere, Form::shard, Form::streak, Form::smoke}) made.add(form, {1.0, 1.0, 1.0}, 2.0);
  EXPECT_FALSE(glowOf(made.frame, made.layers).shines());
  made.add(Form::flash, {1.0, 1.0, 1.0}, 2.0, {1.0, 1.0, 1.0}, 0.0);
  EXPECT_FALSE(glowOf(made.frame, made.layers).shines()) << "a flash that is over";
}

TEST(Glow, FlamesInOnePlaceShineAsOneAndFlamesApartAddUp) {
  test::HandMade once, heaped, apart;
  once.add(Form::fire, {0.0, 2.0, 0.0}, 2.0);
  for (int i = 0; i < 50; ++i) heaped.add(Form::fire, {0.0, 2.0, 0.0}, 2.0);
  for (int i = 0; i < 4; ++i) apart.add(Form::fire, {i % 2 == 0 ? -40.0 : 40.0, 2.0, i < 2 ? -40.0 : 40.0}, 2.0);
  const double one = glowOf(once.frame, once.layers).light_m2.x;
  EXPECT_NEAR(glowOf(heaped.frame, heaped.layers).light_m2.x, one, 1e-9 * one);
  EXPECT_NEAR(glowOf(apart.frame, apart.layers).light_m2.x, 4.0 * one, 1e-9 * one);
}

TEST_F(Glowing, AFlashLightsTheGroundLessAndLessWithDistance) {
  test::HandMade dark, made;
  dark.add(Form::flash, {0.0, 12.0, 0.0}, 16.0, {1.0, 0.9, 0.7}, 0.0);
  made.add(Form::flash, {0.0, 12.0, 0.0}, 16.0, {1.0, 0.9, 0.7}, 1.0);
  const Image before = draw(outdoors(dark), above()), lit = draw(outdoors(made), above());
  int last = 1000, compared = 0;
  // From outside the flash itself to the picture's edge.
  for (int x = kWidth / 2 + 16; x < kWidth; x += 8, ++compared) {
    const int more = brightness(lit, x, kHeight / 2) - brightness(before, x, kHeight / 2);
    EXPECT_LE(more, last) << "at column " << x;
    EXPECT_GE(more, 0) << "at column " << x;
    last = more;
  }
  EXPECT_GE(compared, 15);
  EXPECT_GT(brightness(lit, kWidth / 2 + 16, kHeight / 2), brightness(before, kWidth / 2 + 16, kHeight / 2) + 60);
}

TEST_F(Glowing, PiecesAndSmokeNearAFlashAreBrighterThanWithoutIt) {
  for (const Form form : {Form::sphere, Form::smoke}) {
    test::HandMade dark, made;
    Scene scenes[2];
    // From beside, so that neither the flash nor lit ground stands behind what is looked at.
    Camera camera;
    camera.eye = {0.0, 32.0, 60.0};
    camera.target = {0.0, 30.0, 0.0};
    Image images[2];
    for (int on = 0; on < 2; ++on) {
      test::HandMade& one = on ? made : dark;
      one.add(form, {0.0, 30.0, 0.0}, 4.0, {0.3, 0.3, 0.3});
      one.add(Form::flash, {0.0, 30.0, 25.0}, 4.0, {1.0, 1.0, 1.0}, 0.0);
      // Behind the eye's back: its light counts, it is not in the picture.
      one.add(Form::flash, {0.0, 30.0, 80.0}, 24.0, {1.0, 1.0, 1.0}, on ? 1.0 : 0.0);
      scenes[on] = outdoors(one);
      images[on] = draw(scenes[on], camera);
    }
    EXPECT_GT(brightness(images[1], kWidth / 2, kHeight / 2), brightness(images[0], kWidth / 2, kHeight / 2) + 8) << "form " << static_cast<int>(form);
  }
}

TEST_F(Glowing, WithoutABackgroundThereIsNoGroundToLight) {
  test::HandMade made;
  made.add(Form::flash, {0.0, 6.0, 0.0}, 8.0);
  Scene scene = outdoors(made);
  scene.background.kind = Background::Kind::transparent;
  const Image image = draw(scene, above());
  EXPECT_EQ(image.pixel(4, 4)[3], 0);
  EXPECT_EQ(image.pixel(kWidth / 2 + 60, kHeight / 2)[3], 0);
  EXPECT_GT(image.pixel(kWidth / 2, kHeight / 2)[3], 200);
}

}  // namespace
}  // namespace npsee::render
