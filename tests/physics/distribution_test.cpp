#include "tests/support/explosions.h"

#include <npsee/units.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace npsee {
namespace {

using test::compiled;
using test::exactAt;

constexpr std::int64_t kCount = 20000;

/// Largest distance between the sample's distribution and the given one, times the square root of the count
/// (Kolmogorov 1933); below 1.95 in 99.9 % of samples. Seeds are fixed, so this is no gamble.
double kolmogorovSmirnov(std::vector<double> sample, const std::function<double(double)>& cumulative) {
  std::ranges::sort(sample);
  double worst = 0.0;
  const auto n = static_cast<double>(sample.size());
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double c = cumulative(sample[i]);
    worst = std::max({worst, c - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - c});
  }
  return worst * std::sqrt(n);
}

constexpr double kLimit = 1.95;

double normalBelow(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

Preset many() {
  Preset preset;
  preset.layers.emplace_back();
  preset.layers[0].count = kCount;
  return preset;
}

/// One number per particle of the frame at the burst.
template <class Read>
std::vector<double> sampled(const Preset& preset, Read read) {
  const ExactFrame frame = exactAt(*compiled(preset), 0.0);
  std::vector<double> out(frame.count);
  for (std::size_t i = 0; i < frame.count; ++i) out[i] = read(frame, i);
  return out;
}

double speed(const ExactFrame& f, std::size_t i) { return std::sqrt(f.vx[i] * f.vx[i] + f.vy[i] * f.vy[i] + f.vz[i] * f.vz[i]); }
double angle(const ExactFrame& f, std::size_t i) { return std::acos(std::min(1.0, f.vy[i] / speed(f, i))); }

TEST(Distribution, SpeedIsNormal) {
  Preset preset = many();
  preset.layers[0].speed_mean_mps = 60.0;
  preset.layers[0].speed_deviation_mps = 8.0;
  EXPECT_LT(kolmogorovSmirnov(sampled(preset, speed), [](double v) { return normalBelow((v - 60.0) / 8.0); }), kLimit);
}

TEST(Distribution, SpeedCanBeUniformAboutItsMean) {
  Preset preset = many();
  preset.layers[0].speed_mean_mps = 60.0;
  preset.layers[0].speed_deviation_mps = 8.0;
  preset.layers[0].speed_distribution = Distribution::uniform;
  EXPECT_LT(kolmogorovSmirnov(sampled(preset, speed), [](double v) { return (v - 52.0) / 16.0; }), kLimit);
}

TEST(Distribution, SizeIsNormal) {
  Preset preset = many();
  preset.layers[0].size_mean_m = 2.0;
  preset.layers[0].size_deviation_m = 0.3;
  EXPECT_LT(kolmogorovSmirnov(sampled(preset, [](const ExactFrame& f, std::size_t i) { return f.size[i]; }), [](double s) { return normalBelow((s - 2.0) / 0.3); }), kLimit);
}

TEST(Distribution, AngleIsHalfNormalWithinTheEjectionAngle) {
  Preset preset = many();
  const double limit = preset.layers[0].ejection_angle_rad = 0.8;
  const auto angles = sampled(preset, angle);
  // Launch velocities along the ground are floats, rounded towards zero: a piece at the limit may stand steeper by that, but not flatter.
  EXPECT_LE(*std::ranges::max_element(angles), limit * (1 + 1e-12));
  EXPECT_LT(kolmogorovSmirnov(angles, [&](double a) { return std::erf(a / (0.5 * limit) / std::sqrt(2.0)) / std::erf(std::sqrt(2.0)); }), kLimit);
}

TEST(Distribution, UniformAnglesAreUniformInSolidAngle) {
  Preset preset = many();
  const double limit = preset.layers[0].ejection_angle_rad = 1.9;
  preset.layers[0].angle_distribution = AngleDistribution::uniform;
  preset.layers[0].collide = false;  // a piece thrown into the ground bounces at once
  EXPECT_LT(kolmogorovSmirnov(sampled(preset, angle), [&](double a) { return (1 - std::cos(a)) / (1 - std::cos(limit)); }), kLimit);
}

TEST(Distribution, LeaningByPlaceFollowsTheTemplatesSides) {
  Preset preset = many();
  preset.layers[0].ejection_angle_rad = 0.9;
  preset.layers[0].region_radius_m = 4.0;
  preset.layers[0].angle_distribution = AngleDistribution::place;
  for (const double wrong : sampled(preset, [](const ExactFrame& f, std::size_t i) {
         const double r = std::hypot(f.x[i], f.z[i]);
         return std::tan(angle(f, i)) - r / 4.0 * std::tan(0.9);
       }))
    ASSERT_NEAR(wrong, 0.0, 1e-6);
}

TEST(Distribution, ParticlesLeanAwayFromTheCentre) {
  for (const double wrong : sampled(many(), [](const ExactFrame& f, std::size_t i) { return f.x[i] * f.vz[i] - f.z[i] * f.vx[i]; })) ASSERT_NEAR(wrong, 0.0, 1e-4);
}

TEST(Distribution, AnAirBurstThrowsInAllDirections) {
  Preset preset = many();
  preset.burst = BurstKind::air;
  preset.burst_height_m = 50.0;
  EXPECT_LT(kolmogorovSmirnov(sampled(preset, angle), [](double a) { return 0.5 * (1 - std::cos(a)); }), kLimit);
  EXPECT_LT(kolmogorovSmirnov(sampled(preset, [](const ExactFrame& f, std::size_t i) { return std::atan2(f.vx[i], f.vz[i]); }), [](double a) { return (a + kPi) / kTwoPi; }), kLimit);
}

TEST(Distribution, PlacesAreUniformByAreaOverTheDisc) {
  Preset preset = many();
  preset.layers[0].region_radius_m = 5.0;
  EXPECT_LT(kolmogorovSmirnov(sampled(preset, [](const ExactFrame& f, std::size_t i) { return std::hypot(f.x[i], f.z[i]); }), [](double r) { return r * r / 25.0; }), kLimit);
  EXPECT_LT(kolmogorovSmirnov(sampled(preset, [](const ExactFrame& f, std::size_t i) { return std::atan2(f.z[i], f.x[i]); }), [](double a) { return (a + kPi) / kTwoPi; }), kLimit);
}

TEST(Distribution, OtherRegionsAreFilledUniformly) {
  Preset preset = many();
  preset.burst = BurstKind::air;
  Layer& layer = preset.layers[0];
  layer.collide = false;
  layer.region_radius_m = 4.0;
  layer.region_inner_radius_m = 2.0;
  const auto radius = [](const ExactFrame& f, std::size_t i) { return std::sqrt(f.x[i] * f.x[i] + f.y[i] * f.y[i] + f.z[i] * f.z[i]); };
  const auto flat_radius = [](const ExactFrame& f, std::size_t i) { return std::hypot(f.x[i], f.z[i]); };
  const auto height = [](const ExactFrame& f, std::size_t i) { return f.y[i]; };
  layer.region_shape = RegionShape::sphere;
  EXPECT_LT(kolmogorovSmirnov(sampled(preset, radius), [](double r) { return r * r * r / 64.0; }), kLimit);
  layer.region_shape = RegionShape::hemisphere;
  EXPECT_LT(kolmogorovSmirnov(sampled(preset, height), [](double y) { return 1.5 * (y / 4 - y * y * y / 192); }), kLimit);
  layer.region_shape = RegionShape::ring;
  EXPECT_LT(kolmogorovSmirnov(sampled(preset, flat_radius), [](double r) { return (r * r - 4) / 12; }), kLimit);
  layer.region_shape = RegionShape::cylinder;
  layer.region_height_m = 6.0;
  EXPECT_LT(kolmogorovSmirnov(sampled(preset, height), [](double y) { return (y + 3) / 6; }), kLimit);
  layer.region_shape = RegionShape::line;
  layer.region_length_m = 8.0;
  EXPECT_LT(kolmogorovSmirnov(sampled(preset, [](const ExactFrame& f, std::size_t i) { return f.x[i]; }), [](double x) { return (x + 4) / 8; }), kLimit);
  layer.region_shape = RegionShape::sphere;
  layer.region_fill = RegionFill::surface;
  for (const double r : sampled(preset, radius)) ASSERT_NEAR(r, 4.0, 1e-6);
}

TEST(Distribution, DensityTimesAreaIsTheCount) {
  Preset preset = many();
  Layer& layer = preset.layers[0];
  layer.count = 0;
  layer.density = 12.0;
  layer.region_radius_m = 5.0;
  EXPECT_EQ(compiled(preset)->particleCount(), static_cast<std::size_t>(std::round(12.0 * kPi * 25.0)));
}

TEST(Distribution, BirthsAreSpreadEvenlyOverTheDuration) {
  Preset preset = many();
  Layer& layer = preset.layers[0];
  layer.start_s = 1.0;
  layer.duration_s = 4.0;
  layer.lifetime_mean_s = 100.0;
  const auto explosion = compiled(preset);
  for (const double t : {1.5, 2.0, 4.5}) {
    const ExactFrame frame = exactAt(*explosion, t);
    EXPECT_NEAR(static_cast<double>(std::ranges::count(frame.alive, 1)), kCount * (t - 1.0) / 4.0, 2.0);
  }
}

TEST(Distribution, AxisSymmetricDirectionsTurnWithThePrincipalDirection) {
  Preset preset = many();
  Layer& layer = preset.layers[0];
  layer.region_shape = RegionShape::point;
  layer.ejection_angle_rad = 0.6;
  layer.collide = false;
  for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{-1, 2, 3}}) {
    layer.direction = axis;
    const double size = length(axis);
    for (const double cosine : sampled(preset, [&](const ExactFrame& f, std::size_t i) { return (axis.x * f.vx[i] + axis.y * f.vy[i] + axis.z * f.vz[i]) / (size * speed(f, i)); }))
      ASSERT_GE(cosine, std::cos(0.6) - 1e-12);
  }
}

}  // namespace
}  // namespace npsee
