#include "sim/core/nurbs.h"

#include <npsee/units.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>

namespace npsee::nurbs {
namespace {

// Coordinates are of the order of 1 and a point is a short sum of products, so a few units in the last place (2.2e-16) remain.
constexpr double kExact = 1e-14;

/// Uniform in a..b from a fixed engine; std::uniform_real_distribution would differ between libraries.
double between(std::mt19937_64& random, double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; }

Vec3 anyPoint(std::mt19937_64& random) { return {between(random, -3, 3), between(random, -3, 3), between(random, -3, 3)}; }

KnotVector anyKnots(std::mt19937_64& random) {
  const int degree = 1 + static_cast<int>(random() % 4);
  KnotVector out = uniformKnots(degree, degree + 1 + static_cast<int>(random() % 5));
  // Uneven inner knots: any increasing map that keeps the ends.
  for (double& knot : out.knots) knot = 2.0 * knot * knot + knot - 1.0;
  return out;
}

Surface anySurface(std::mt19937_64& random) {
  const KnotVector u = anyKnots(random), v = anyKnots(random);
  std::vector<ControlPoint> net;
  for (int i = 0; i < u.points() * v.points(); ++i) net.push_back({anyPoint(random), between(random, 0.2, 3.0)});
  return Surface(u, v, net);
}

void expectNear(const Vec3& a, const Vec3& b, double tolerance) { EXPECT_LE(length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y << ' ' << b.z; }

TEST(Nurbs, BasisFunctionsArePositiveAndSumToOneWithDerivativesThatSumToZero) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 500; ++trial) {
    const KnotVector knots = anyKnots(random);
    for (const double u : {knots.first(), between(random, knots.first(), knots.last()), knots.knots[knots.degree + 1], knots.last()}) {
      const Basis basis = basisAt(knots, u);
      ASSERT_EQ(basis.value.size(), static_cast<std::size_t>(knots.degree + 1));
      for (const double value : basis.value) EXPECT_GE(value, -kExact);
      EXPECT_NEAR(std::accumulate(basis.value.begin(), basis.value.end(), 0.0), 1.0, kExact);
      EXPECT_NEAR(std::accumulate(basis.derivative.begin(), basis.derivative.end(), 0.0), 0.0, 1e-11);
      EXPECT_GE(basis.first, 0);
      EXPECT_LE(basis.first + knots.degree, knots.points() - 1);
    }
  }
}

TEST(Nurbs, BothCirclesStayOnTheUnitCircleAndRunAroundItOnce) {
  for (const Curve& circle : {unitCircle(), unitCircleOfSeven()}) {
    double turned = 0.0;
    Vec3 before = circle.at(0.0).point;
    expectNear(before, {1, 0, 0}, kExact);
    for (int i = 1; i <= 1000; ++i) {
      const CurveSample sample = circle.at(i / 1000.0);
      EXPECT_NEAR(std::hypot(sample.point.x, sample.point.z), 1.0, kExact);
      EXPECT_EQ(sample.point.y, 0.0);
      EXPECT_NEAR(dot(sample.point, sample.derivative), 0.0, 1e-13);  // derivatives are about 2 pi long
      // From +x towards -z is the positive turn about y.
      turned += std::asin(std::clamp(cross(before, sample.point).y, -1.0, 1.0));
      before = sample.point;
    }
    EXPECT_NEAR(turned, kTwoPi, 1e-11);
  }
}

TEST(Nurbs, SpherePointsAndNormalsMeetTheirClosedFormPolesIncluded) {
  const Vec3 centre{0.5, -1.0, 2.0};
  const double radius = 0.75;
  const Surface ball = sphere(centre, radius);
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 60; ++j) {
      const SurfaceSample sample = ball.at(i / 60.0, j / 60.0);
      const Vec3 outward = (1.0 / radius) * (sample.point - centre);
      EXPECT_NEAR(length(outward), 1.0, kExact);
      // Beside the poles the tangent along u is short, and with it the digits of the normal.
      expectNear(sample.normal, outward, 1e-12);
    }
  expectNear(ball.at(0.3, 0.0).normal, {0, -1, 0}, 1e-13);
  expectNear(ball.at(0.3, 1.0).normal, {0, 1, 0}, 1e-13);
}

TEST(Nurbs, AConeOfRevolutionHasTheConesPointsAndNormals) {
  const double lean = 0.7, foot = 0.4, slant = 2.0;
  const Surface cone = revolved(Curve(uniformKnots(1, 2), {{{foot, 0, 0}, 1}, {{foot + slant * std::sin(lean), slant * std::cos(lean), 0}, 1}}));
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 10; ++j) {
      const SurfaceSample sample = cone.at(i / 40.0, j / 10.0);
      const double radius = std::hypot(sample.point.x, sample.point.z);
      EXPECT_NEAR(radius, foot + sample.point.y * std::tan(lean), kExact);
      const Vec3 normal{std::cos(lean) * sample.point.x / radius, -std::sin(lean), std::cos(lean) * sample.point.z / radius};
      expectNear(sample.normal, normal, kExact);
    }
}

TEST(Nurbs, RingsOfTwoRadiiAreExactEllipses) {
  const Surface tube = ringSurface(uniformKnots(1, 2), {{2.0, 0.5, 0.0, 1.0}, {2.0, 0.5, 1.0, 1.0}});
  for (int i = 0; i <= 100; ++i) {
    const Vec3 p = tube.at(i / 100.0, 0.5).point;
    EXPECT_NEAR(p.x * p.x / 4.0 + p.z * p.z / 0.25, 1.0, 4 * kExact);
    EXPECT_NEAR(p.y, 0.5, kExact);
  }
}

TEST(Nurbs, DerivativesAgreeWithDifferences) {
  std::mt19937_64 random(2);
  const double step = 1e-5;
  for (int trial = 0; trial < 100; ++trial) {
    const Surface surface = anySurface(random);
    // Within one span, where the surface is smooth.
    const double u = between(random, surface.u().first() + 0.01, surface.u().knots[surface.u().degree + 1] - 0.01);
    const double v = between(random, surface.v().first() + 0.01, surface.v().knots[surface.v().degree + 1] - 0.01);
    const SurfaceSample sample = surface.at(u, v);
    const Vec3 du = (0.5 / step) * (surface.at(u + step, v).point - surface.at(u - step, v).point);
    const Vec3 dv = (0.5 / step) * (surface.at(u, v + step).point - surface.at(u, v - step).point);
    // Truncation grows with the third derivative, which uneven weights make large.
    expectNear(sample.du, du, 1e-4 * (1.0 + length(du)));
    expectNear(sample.dv, dv, 1e-4 * (1.0 + length(dv)));
    EXPECT_NEAR(length(sample.normal), 1.0, kExact);
    EXPECT_NEAR(dot(sample.normal, sample.du), 0.0, 1e-10 * (1.0 + length(sample.du)));
    EXPECT_NEAR(dot(sample.normal, sample.dv), 0.0, 1e-10 * (1.0 + length(sample.dv)));
  }
}

TEST(Nurbs, EveryPointLiesInTheConvexHullOfItsControlPoints) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const Surface surface = anySurface(random);
    // A point is in the hull exactly if no direction separates it from the control points; try many directions.
    for (int probe = 0; probe < 10; ++probe) {
      const Vec3 p = surface.at(between(random, surface.u().first(), surface.u().last()), between(random, surface.v().first(), surface.v().last())).point;
      const Vec3 direction = anyPoint(random);
      double furthest = -1e300;
      for (const ControlPoint& point : surface.net()) furthest = std::max(furthest, dot(direction, point.position));
      EXPECT_LE(dot(direction, p), furthest + 1e-12);
    }
  }
}

TEST(Nurbs, MappingTheControlPointsMapsTheSurface) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const Surface surface = anySurface(random);
    const Affine map{anyPoint(random), anyPoint(random), anyPoint(random), anyPoint(random)};
    const Surface mapped = surface.mapped(map);
    const double u = between(random, surface.u().first(), surface.u().last()), v = between(random, surface.v().first(), surface.v().last());
    expectNear(mapped.at(u, v).point, map(surface.at(u, v).point), 1e-12);  // entries up to 3 multiply rounding
  }
}

TEST(Nurbs, EqualWeightsOfAnySizeGiveThePlainSpline) {
  std::mt19937_64 random(5);
  const Surface plain = anySurface(random);
  std::vector<ControlPoint> ones = plain.net(), sevens = plain.net();
  for (ControlPoint& point : ones) point.weight = 1.0;
  for (ControlPoint& point : sevens) point.weight = 7.0;
  const Surface a(plain.u(), plain.v(), ones), b(plain.u(), plain.v(), sevens);
  for (int i = 0; i <= 20; ++i) expectNear(a.at(i / 20.0, 1.0 - i / 20.0).point, b.at(i / 20.0, 1.0 - i / 20.0).point, kExact);
}

TEST(Nurbs, TheGridHoldsTheSameSamplesAsSinglePoints) {
  const Surface ball = sphere({}, 1.0);
  const std::vector<double> us{0.0, 0.2, 0.25, 0.9, 1.0}, vs{0.0, 0.4, 1.0};
  const auto grid = ball.grid(us, vs);
  ASSERT_EQ(grid.size(), us.size() * vs.size());
  for (std::size_t j = 0; j < vs.size(); ++j)
    for (std::size_t i = 0; i < us.size(); ++i) {
      EXPECT_EQ(grid[j * us.size() + i].point, ball.at(us[i], vs[j]).point);
      EXPECT_EQ(grid[j * us.size() + i].normal, ball.at(us[i], vs[j]).normal);
    }
}

TEST(Nurbs, ASurfaceShrunkToAPointHasAZeroNormal) {
  const SurfaceSample sample = sphere({1, 2, 3}, 0.0).at(0.3, 0.4);
  expectNear(sample.point, {1, 2, 3}, kExact);
  EXPECT_LE(length(sample.normal), 1.0);
}

TEST(Nurbs, ParametersOutsideTheKnotsAreClamped) {
  const Curve circle = unitCircle();
  EXPECT_EQ(circle.at(-3.0).point, circle.at(0.0).point);
  EXPECT_EQ(circle.at(7.0).point, circle.at(1.0).point);
}

TEST(Nurbs, KnotsPointsAndWeightsThatDoNotFitAreRefused) {
  const std::vector<ControlPoint> two{{{0, 0, 0}, 1}, {{1, 0, 0}, 1}};
  EXPECT_NO_THROW(Curve({1, {0, 0, 1, 1}}, two));
  EXPECT_THROW(Curve({1, {0, 0, 1, 1}}, {two[0]}), std::invalid_argument);
  EXPECT_THROW(Curve({1, {0, 1, 0, 1}}, two), std::invalid_argument);
  EXPECT_THROW(Curve({1, {0, 0.1, 0.9, 1}}, two), std::invalid_argument);
  EXPECT_THROW(Curve({1, {0, 0, 0, 0}}, two), std::invalid_argument);
  EXPECT_THROW(Curve({1, {0, 0, NAN, 1}}, two), std::invalid_argument);
  EXPECT_THROW(Curve({0, {0, 1, 2}}, two), std::invalid_argument);
  EXPECT_THROW(Curve({2, {0, 0, 1, 1}}, two), std::invalid_argument);
  EXPECT_THROW(Curve({1, {0, 0, 1, 1}}, {two[0], {{1, 0, 0}, 0.0}}), std::invalid_argument);
  EXPECT_THROW(Curve({1, {0, 0, 1, 1}}, {two[0], {{INFINITY, 0, 0}, 1.0}}), std::invalid_argument);
  EXPECT_THROW(Surface({1, {0, 0, 1, 1}}, {1, {0, 0, 1, 1}}, two), std::invalid_argument);
}

}  // namespace
}  // namespace npsee::nurbs
