#include "app/render/template_drawing.h"
#include "tests/support/random_preset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

using test::between;

constexpr double kRight = kPi / 2.0;

Preset groundBurst(double speed_mps = 25.0, double angle_rad = 0.9, double size_m = 0.4, double radius_m = 3.0) {
  Preset preset;
  Layer& layer = preset.layers.emplace_back();
  layer.speed_mean_mps = speed_mps;
  layer.ejection_angle_rad = angle_rad;
  layer.size_mean_m = size_m;
  layer.region_radius_m = radius_m;
  return preset;
}

TemplateMesh meshOf(const Preset& preset) { return smoothMesh(templateShape(preset, 0).surface, 64, 32); }

double topOf(const TemplateMesh& mesh) {
  double top = -1e300;
  for (const auto& vertex : mesh.vertices) top = std::max(top, static_cast<double>(vertex.position[1]));
  return top;
}

double widthOf(const TemplateMesh& mesh) {
  double width = 0.0;
  for (const auto& vertex : mesh.vertices) width = std::max(width, 2.0 * std::hypot(static_cast<double>(vertex.position[0]), static_cast<double>(vertex.position[2])));
  return width;
}

/// Angle between the principal direction and the side, measured on the lowest row of a tessellation at one place around it.
double measuredLean(const TemplateShape& shape, double u) {
  const Vec3 low = shape.surface.at(u, 0.0).point, next = shape.surface.at(u, 1.0 / kFacetsAlong).point;
  const Vec3 side = next - low;
  return std::acos(std::clamp(dot(side, shape.frame.y) / (length(side) * length(shape.frame.y)), -1.0, 1.0));
}

/// Positions are floats, hence the tolerance.
void expectWithinBounds(const TemplateShape& shape, const Vec3& point) {
  const Vec3 p = point - shape.origin;
  if (shape.ball) {
    EXPECT_LE(length(p), kLargestBall + 1e-6);
    return;
  }
  const Vec3 axis = (1.0 / length(shape.frame.y)) * shape.frame.y;
  const double y = dot(p, axis);
  EXPECT_GE(y, -1e-6);
  EXPECT_LE(y, kLargestCupHeight + 1e-6);
  EXPECT_LE(length(p - y * axis), kLargestCupRadius + 1e-6);
}

TEST(TemplateGeometry, HeightGrowsWithTheMeanSpeedAndStaysBounded) {
  double before = 0.0;
  for (double speed = 0.0; speed <= 3000.0; speed = speed * 1.1 + 1.0) {
    const double top = topOf(meshOf(groundBurst(speed)));
    EXPECT_GT(top, before) << speed;
    before = top;
  }
  EXPECT_LT(before, kLargestCupHeight);
}

TEST(TemplateGeometry, TheRimStandsAtTheSameHeightForEveryEjectionAngle) {
  const double upright = topOf(meshOf(groundBurst(60.0, 0.0)));
  for (double angle = 0.1; angle < kPi; angle += 0.1) EXPECT_NEAR(topOf(meshOf(groundBurst(60.0, angle))), upright, 1e-6);
}

TEST(TemplateGeometry, TheSideLeansAtTheEjectionAngleFromThePrincipalDirection) {
  std::mt19937_64 random(11);
  for (int trial = 0; trial < 300; ++trial) {
    const Preset preset = test::randomPreset(random);
    const TemplateShape shape = templateShape(preset, 0);
    if (shape.ball) continue;
    const double wanted = std::min(preset.layers[0].ejection_angle_rad, kRight);
    // The sections along x and z are exact for every region; those of round regions are everywhere.
    for (const double u : {0.0, 0.25, 0.5, 0.75}) EXPECT_NEAR(measuredLean(shape, u), wanted, 1e-6);
    if (shape.foot_x == shape.foot_z) {
      EXPECT_NEAR(measuredLean(shape, 0.137), wanted, 1e-6);
    }
  }
}

TEST(TemplateGeometry, TheSideIsStraightOverMostOfItsRiseAndTurnsUprightAtTheRim) {
  for (const double angle : {0.2, 0.6, 0.9}) {
    const TemplateShape shape = templateShape(groundBurst(25.0, angle), 0);
    const Vec3 foot = shape.surface.at(0.0, 0.0).point;
    for (int j = 1; j <= 6; ++j) {
      const Vec3 p = shape.surface.at(0.0, j / 10.0).point - foot;
      EXPECT_NEAR(std::atan2(p.x, p.y), angle, 1e-12);
    }
    EXPECT_GT(shape.surface.at(0.0, 0.6).point.y, 0.55 * shape.scale * shape.height);
    const Vec3 rim = shape.surface.at(0.0, 1.0).dv;
    EXPECT_NEAR(rim.x / rim.y, 0.0, 1e-12);
  }
}

TEST(TemplateGeometry, ASideAtZeroIsAnUprightCylinder) {
  const TemplateShape shape = templateShape(groundBurst(40.0, 0.0), 0);
  for (int j = 0; j <= 10; ++j) {
    const Vec3 p = shape.surface.at(0.3, j / 10.0).point;
    EXPECT_NEAR(std::hypot(p.x, p.z), shape.scale * shape.foot_x, 1e-14);
  }
}

TEST(TemplateGeometry, TheRimWidensWithTheEjectionAngleAndStopsAtARightAngle) {
  double before = 0.0;
  for (int degree = 0; degree <= 90; degree += 3) {
    const double width = widthOf(meshOf(groundBurst(25.0, degree * kPi / 180.0)));
    EXPECT_GT(width, before) << degree;
    before = width;
  }
  EXPECT_EQ(widthOf(meshOf(groundBurst(25.0, 2.5))), widthOf(meshOf(groundBurst(25.0, kRight))));
}

TEST(TemplateGeometry, ParticleSizeScalesTheWholeShape) {
  const TemplateMesh small = meshOf(groundBurst(25.0, 0.9, 0.1)), large = meshOf(groundBurst(25.0, 0.9, 2.0));
  const double factor = templateScale(2.0) / templateScale(0.1);
  EXPECT_GT(factor, 1.2);
  for (std::size_t i = 0; i < small.vertices.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(large.vertices[i].position[k], factor * small.vertices[i].position[k], 1e-6);
}

TEST(TemplateGeometry, TheFootShowsTheRegionsRadius) {
  double before = 0.0;
  for (const double radius : {0.0, 0.5, 3.0, 10.0, 30.0, 1000.0}) {
    const TemplateShape shape = templateShape(groundBurst(25.0, 0.9, 0.4, radius), 0);
    const Vec3 p = shape.surface.at(0.1, 0.0).point;
    EXPECT_NEAR(p.y, 0.0, 1e-15);
    EXPECT_GT(std::hypot(p.x, p.z), before);
    before = std::hypot(p.x, p.z);
  }
}

TEST(TemplateGeometry, ALineMakesAFootLongAlongXAndNarrowAlongZ) {
  Preset preset = groundBurst();
  preset.layers[0].region_shape = RegionShape::line;
  preset.layers[0].region_length_m = 20.0;
  const TemplateShape shape = templateShape(preset, 0);
  EXPECT_GT(shape.surface.at(0.0, 0.0).point.x, 2.0 * -shape.surface.at(0.25, 0.0).point.z);
}

TEST(TemplateGeometry, AnAirBurstIsASphereWhoseRadiusGrowsWithSpeedAndSize) {
  Preset preset = groundBurst();
  preset.burst = BurstKind::air;
  const TemplateShape shape = templateShape(preset, 0);
  ASSERT_TRUE(shape.ball);
  for (const auto& vertex : smoothMesh(shape.surface, 48, 24).vertices) {
    const Vec3 p{vertex.position[0], vertex.position[1], vertex.position[2]};
    EXPECT_NEAR(length(p - shape.origin), shape.ballRadius(), 1e-6);
  }
  preset.layers[0].speed_mean_mps *= 2.0;
  const double faster = templateShape(preset, 0).ballRadius();
  preset.layers[0].size_mean_m *= 2.0;
  EXPECT_GT(faster, shape.ballRadius());
  EXPECT_GT(templateShape(preset, 0).ballRadius(), faster);
}

TEST(TemplateGeometry, TheLayersDirectionalityDecidesBetweenSphereAndCup) {
  Preset preset = groundBurst();
  EXPECT_FALSE(templateShape(preset, 0).ball);
  preset.layers[0].directionality = Directionality::neutral;
  EXPECT_TRUE(templateShape(preset, 0).ball);
  preset.burst = BurstKind::air;
  preset.layers[0].directionality = Directionality::cone;
  EXPECT_FALSE(templateShape(preset, 0).ball);
}

TEST(TemplateGeometry, EveryValidPresetFitsTheBoundsWithFiniteUnitNormalsOutward) {
  std::mt19937_64 random(12);
  for (int trial = 0; trial < 300; ++trial) {
    const TemplateShape shape = templateShape(test::randomPreset(random), 0);
    for (const TemplateMesh& mesh : {smoothMesh(shape.surface, 24, 12), flatMesh(shape.surface, kFacetsAround, kFacetsAlong)}) {
      for (const auto& vertex : mesh.vertices) {
        const Vec3 p{vertex.position[0], vertex.position[1], vertex.position[2]}, n{vertex.normal[0], vertex.normal[1], vertex.normal[2]};
        expectWithinBounds(shape, p);
        ASSERT_NEAR(length(n), 1.0, 1e-5);
      }
      for (const std::uint32_t index : mesh.triangles) ASSERT_LT(index, mesh.vertices.size());
    }
    // Half way up the side, away from the axis.
    const nurbs::SurfaceSample side = shape.surface.at(0.4, 0.3);
    const Vec3 local = side.point - shape.origin;
    const Vec3 out = local - (dot(local, shape.frame.y) / dot(shape.frame.y, shape.frame.y)) * shape.frame.y;
    EXPECT_GE(dot(side.normal, out), -1e-12);
  }
}

TEST(TemplateGeometry, ExtremesOfTheTableFitTheBounds) {
  for (const bool most : {false, true})
    for (const std::string_view shape_key : {"disc", "box", "line", "point"}) {
      Preset preset = groundBurst();
      for (const Parameter& row : parameters(Scope::layer))
        if (row.type == ParameterType::number) row.assign(preset.layers[0], toSi(row.unit, most ? row.hard.max : row.hard.min));
      findParameter(Scope::layer, "region.shape")->assign(preset.layers[0], std::string(shape_key));
      const TemplateShape shape = templateShape(preset, 0);
      for (const auto& vertex : smoothMesh(shape.surface, 24, 12).vertices) expectWithinBounds(shape, {vertex.position[0], vertex.position[1], vertex.position[2]});
    }
}

TEST(TemplateHandles, LieOnTheShape) {
  std::mt19937_64 random(13);
  for (int trial = 0; trial < 200; ++trial) {
    const TemplateShape shape = templateShape(test::randomPreset(random), 0);
    if (shape.ball) {
      EXPECT_NEAR(length(shape.handle(TemplateHandle::top) - shape.origin), shape.ballRadius(), 1e-12);
      EXPECT_FALSE(shape.hasHandle(TemplateHandle::rim));
      continue;
    }
    EXPECT_LE(length(shape.handle(TemplateHandle::rim, 0.0) - shape.surface.at(0.0, 1.0).point), 1e-12);
    EXPECT_LE(length(shape.handle(TemplateHandle::rim, kRight) - shape.surface.at(0.25, 1.0).point), 1e-12);
    EXPECT_LE(length(shape.handle(TemplateHandle::foot, 0.0) - shape.surface.at(0.5, 0.0).point), 1e-12);
  }
}

TEST(TemplateHandles, GiveBackTheValuesTheyShow) {
  std::mt19937_64 random(14);
  for (int trial = 0; trial < 500; ++trial) {
    const Preset preset = test::randomPreset(random);
    const TemplateShape shape = templateShape(preset, 0);
    const double azimuth = between(random, -kPi, kPi);
    for (const TemplateHandle which : {TemplateHandle::rim, TemplateHandle::top, TemplateHandle::foot}) {
      if (!shape.hasHandle(which)) continue;
      // The foot of an oblong region is dragged along x.
      const double around = which == TemplateHandle::foot && shape.foot_x != shape.foot_z ? 0.0 : azimuth;
      const Parameter& row = *findParameter(Scope::layer, parameterOf(which, shape));
      const double limit = which == TemplateHandle::rim ? kRight : 1e300;
      const double value = std::min(std::get<double>(row.get(preset.layers[0])), limit);
      // The encoding saturates, so large values lose digits.
      EXPECT_NEAR(shape.valueAt(which, shape.handle(which, around), around), value, 1e-7 * (1.0 + value)) << row.key;
    }
  }
}

TEST(TemplateHandles, AnyPointGivesAValueWithinTheParametersRange) {
  std::mt19937_64 random(15);
  for (int trial = 0; trial < 500; ++trial) {
    const TemplateShape shape = templateShape(test::randomPreset(random), 0);
    const Vec3 point{between(random, -9, 9), between(random, -9, 9), between(random, -9, 9)};
    for (const TemplateHandle which : {TemplateHandle::rim, TemplateHandle::top, TemplateHandle::foot}) {
      if (!shape.hasHandle(which)) continue;
      const Parameter& row = *findParameter(Scope::layer, parameterOf(which, shape));
      EXPECT_EQ(checkValue(row, shape.valueAt(which, point, between(random, -4, 4))), "");
    }
  }
}

TEST(TemplateCamera, ShowsEveryShapeWholeInEveryDirection) {
  std::mt19937_64 random(16);
  for (int trial = 0; trial < 200; ++trial) {
    const TemplateShape shape = templateShape(test::randomPreset(random), 0);
    const int width = 40 + static_cast<int>(random() % 900), height = 40 + static_cast<int>(random() % 900);
    const TemplateCamera camera(shape, between(random, -4, 4), between(random, -kRight, kRight), width, height);
    for (const auto& vertex : smoothMesh(shape.surface, 16, 8).vertices) {
      const auto pixel = camera.project({vertex.position[0], vertex.position[1], vertex.position[2]});
      ASSERT_GT(pixel.x, 0.0);
      ASSERT_LT(pixel.x, width);
      ASSERT_GT(pixel.y, 0.0);
      ASSERT_LT(pixel.y, height);
    }
  }
}

TEST(TemplateCamera, ItsMatrixPutsPointsWhereItProjectsThem) {
  const TemplateShape shape = templateShape(groundBurst(), 0);
  const TemplateCamera camera(shape, 0.6, 0.35, 640, 480);
  const auto m = camera.viewProjection();
  for (const auto& vertex : smoothMesh(shape.surface, 16, 8).vertices) {
    const auto& p = vertex.position;
    const auto row = [&](std::size_t r) { return m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r]; };
    const auto pixel = camera.project({p[0], p[1], p[2]});
    EXPECT_NEAR((0.5 + 0.5 * row(0) / row(3)) * 640, pixel.x, 1e-3);
    EXPECT_NEAR((0.5 - 0.5 * row(1) / row(3)) * 480, pixel.y, 1e-3);
    EXPECT_LT(std::abs(row(2)), row(3));
  }
}

TEST(TemplateCamera, DraggingAHandleToWhereItWouldBeGivesThatValue) {
  std::mt19937_64 random(17);
  for (int trial = 0; trial < 200; ++trial) {
    const double speed = between(random, 1, 150), angle = between(random, 0.05, 1.5), radius = between(random, 0.2, 30);
    const double yaw = between(random, -3, 3), pitch = between(random, 0.1, 0.7);
    const TemplateShape now = templateShape(groundBurst(), 0);
    const TemplateCamera camera(now, yaw, pitch, 600, 500);
    const auto dragTo = [&](TemplateHandle which, const Preset& wanted) {
      const auto at = camera.project(templateShape(wanted, 0).handle(which, camera.azimuth()));
      return camera.dragged(now, which, at.x, at.y);
    };
    EXPECT_NEAR(dragTo(TemplateHandle::rim, groundBurst(25.0, angle)), angle, 1e-3);
    EXPECT_NEAR(dragTo(TemplateHandle::top, groundBurst(speed)), speed, 1e-3 * speed + 1e-3);
    EXPECT_NEAR(dragTo(TemplateHandle::foot, groundBurst(25.0, 0.9, 0.4, radius)), radius, 1e-3 * radius + 1e-3);
  }
}

TEST(TemplateCamera, FindsTheHandleUnderThePointer) {
  const TemplateShape shape = templateShape(groundBurst(), 0);
  const TemplateCamera camera(shape, 0.6, 0.35, 600, 500);
  for (const TemplateHandle which : {TemplateHandle::rim, TemplateHandle::top, TemplateHandle::foot}) {
    const auto at = camera.project(shape.handle(which, camera.azimuth()));
    EXPECT_EQ(camera.handleNear(shape, at.x + 3.0, at.y - 3.0), which);
  }
  EXPECT_EQ(camera.handleNear(shape, 2.0, 2.0), TemplateHandle::none);
}

TEST(TemplateStrokes, AreFiniteTrianglesOfTheirWidthInEveryView) {
  std::mt19937_64 random(18);
  for (int trial = 0; trial < 60; ++trial) {
    const Preset preset = test::randomPreset(random);
    TemplateScene scene;
    scene.preset = &preset;
    scene.view = static_cast<TemplateView>(trial % 3);
    scene.handles = true;
    const TemplateShape shape = templateShape(preset, 0);
    const TemplateCamera camera(shape, between(random, -4, 4), between(random, -kRight, kRight), 320, 240);
    const auto triangles = strokeTriangles(drawingOf(shape, scene, camera).strokes, camera, 320, 240);
    ASSERT_GT(triangles.size(), 300u);
    ASSERT_EQ(triangles.size() % 3, 0u);
    for (const StrokeVertex& vertex : triangles) {
      for (const float value : vertex.clip) ASSERT_TRUE(std::isfinite(value));
      ASSERT_GT(vertex.clip[3], 0.0f);
      ASSERT_TRUE(std::isfinite(vertex.along_px));
    }
  }
}

}  // namespace
}  // namespace npsee::render
