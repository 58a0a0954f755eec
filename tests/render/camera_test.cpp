#include "app/render/camera.h"
#include "app/render/view.h"

#include <npsee/units.h>

#include <gtest/gtest.h>

#include <cmath>

namespace npsee::render {
namespace {

const Extent kEffect{{-20.0, 0.0, -14.0}, {26.0, 19.0, 14.0}};

/// Normalised device coordinates of a world point.
std::array<double, 2> projected(const Camera& camera, double aspect, const Vec3& p) {
  const int width = static_cast<int>(1000.0 * aspect), height = 1000;
  const View view = makeView(camera, width, height);
  double clip[4];
  const double point[4] = {p.x, p.y, p.z, 1.0};
  for (int row = 0; row < 4; ++row) {
    clip[row] = 0.0;
    for (int column = 0; column < 4; ++column) clip[row] += static_cast<double>(view.view_projection[4 * column + row]) * point[column];
  }
  EXPECT_GT(clip[3], 0.0) << "the point is behind the eye";
  return {clip[0] / clip[3], clip[1] / clip[3]};
}

TEST(Camera, EveryNamedViewHasTheWholeEffectInThePictureAndFillsIt) {
  for (const char* name : {"auto", "front", "back", "side", "left", "top"}) {
    for (const double aspect : {0.5, 1.0, 16.0 / 9.0, 3.0}) {
      const auto camera = parseCamera(name, kEffect, aspect);
      ASSERT_TRUE(camera) << camera.error().text();
      // The dome in the extent's box, walked over its surface.
      const Vec3 size = kEffect.max - kEffect.min;
      double most = 0.0;
      for (double tilt = 0.0; tilt <= 90.0; tilt += 3.0)
        for (double turn = 0.0; turn < 360.0; turn += 3.0) {
          const double t = tilt / 180.0 * kPi, u = turn / 180.0 * kPi;
          const Vec3 point = kEffect.centre() + Vec3{0.5 * size.x * std::cos(t) * std::cos(u), size.y * (std::sin(t) - 0.5), 0.5 * size.z * std::cos(t) * std::sin(u)};
          for (const double at : projected(*camera, aspect, point)) most = std::max(most, std::abs(at));
        }
      EXPECT_LE(most, 0.97) << name << " at aspect " << aspect;
      EXPECT_GE(most, 0.93) << name << " at aspect " << aspect;
    }
  }
}

TEST(Camera, TheDefaultLooksFromTheSouthSouthEastAndAbove) {
  const Camera camera = framing(kEffect, 1.5);
  EXPECT_GT(camera.eye.z, camera.target.z);
  EXPECT_GT(camera.eye.x, camera.target.x);
  EXPECT_GT(camera.eye.y, camera.target.y);
  EXPECT_GT(camera.eye.z - camera.target.z, camera.eye.x - camera.target.x);
}

TEST(Camera, AnEffectWithoutExtentStillGetsACamera) {
  const Camera camera = framing({{1.0, 2.0, 3.0}, {1.0, 2.0, 3.0}}, 1.0);
  EXPECT_NEAR(length(camera.eye - camera.target), 2.0, 1e-9);
  EXPECT_NEAR(camera.target.y, 2.0, 1e-9);
}

TEST(Camera, TextReadsBackToTheSameCamera) {
  Camera camera;
  camera.eye = {1.0 / 3.0, 2.25, -1e-7};
  camera.target = {-4.0, 0.1, 1e4};
  camera.fov_y_rad = 0.7;
  const auto back = parseCamera(cameraText(camera), kEffect, 1.0);
  ASSERT_TRUE(back) << back.error().text();
  EXPECT_EQ(*back, camera);
}

TEST(Camera, PartsMayComeInAnyOrderAndBeLeftOut) {
  const auto camera = parseCamera("fov=60deg; eye=0,5,40", kEffect, 1.0);
  ASSERT_TRUE(camera) << camera.error().text();
  EXPECT_EQ(camera->eye, (Vec3{0.0, 5.0, 40.0}));
  EXPECT_NEAR(camera->fov_y_rad, 1.0471975511965976, 1e-15);
  EXPECT_EQ(camera->target, framing(kEffect, 1.0).target);
}

TEST(Camera, WhatCannotBeACameraIsRefusedWithTheWayToWriteOne) {
  for (const char* text : {"", "  ", "nowhere", "eye=1,2", "eye=1,2,nan", "eye=1,2,1e9", "fov=0", "fov=170deg", "eye=1,2,3 target=1,2,3", "eye=1,2,3 roll=4", "eye"}) {
    const auto camera = parseCamera(text, kEffect, 1.0);
    ASSERT_FALSE(camera) << text;
    EXPECT_EQ(camera.error().kind, ErrorKind::usage);
    EXPECT_NE(camera.error().text().find("eye=X,Y,Z target=X,Y,Z fov=40deg"), std::string::npos) << camera.error().text();
  }
}

TEST(View, RayThroughAPixelMeetsTheWorldPointThatProjectsThere) {
  const Camera camera = framing(kEffect, 2.0);
  const View view = makeView(camera, 1000, 500);
  const Vec3 ray = view.ray_origin + 700.0 * view.ray_x + 400.0 * view.ray_y;
  const auto at = projected(camera, 2.0, camera.eye + 30.0 * ray);
  EXPECT_NEAR(at[0], 2.0 * 700.0 / 1000.0 - 1.0, 1e-5);
  EXPECT_NEAR(at[1], 2.0 * 400.0 / 500.0 - 1.0, 1e-5);
}

}  // namespace
}  // namespace npsee::render
