#include "tests/support/explosions.h"

#include <npsee/units.h>

#include <gtest/gtest.h>

#include <cmath>

namespace npsee {
namespace {

using test::compiled;
using test::exactAt;
using test::onePiece;

constexpr double g = kStandardGravity_mps2;

Preset bouncer(double restitution, double friction) {
  Preset preset = onePiece();
  Layer& layer = preset.layers[0];
  layer.restitution = restitution;
  layer.friction = friction;
  layer.rest_speed_mps = 0.0;
  layer.bounce_limit = 20;
  layer.lifetime_mean_s = 100.0;
  return preset;
}

TEST(Bounce, ContactTimesAreAGeometricSeries) {
  const double e = 0.7;
  const auto explosion = compiled(bouncer(e, 0.1));
  const ExactFrame start = exactAt(*explosion, 0.0);
  double contact = 0.0, flight = 2.0 * start.vy[0] / g;
  for (int n = 0; n < 15; ++n, flight *= e) {
    contact += flight;
    EXPECT_EQ(exactAt(*explosion, contact * (1 - 1e-12)).bounces[0], n);
    EXPECT_EQ(exactAt(*explosion, contact * (1 + 1e-12)).bounces[0], n + 1);
  }
}

TEST(Bounce, ApexesShrinkByTheSquareOfTheRestitution) {
  const double e = 0.6;
  const auto explosion = compiled(bouncer(e, 0.0));
  const double speed = exactAt(*explosion, 0.0).vy[0];
  double from = 0.0, v = speed;
  for (int n = 0; n < 10; ++n, v *= e) {
    EXPECT_NEAR(exactAt(*explosion, from + v / g).y[0], v * v / (2 * g), 1e-12 * speed * speed);
    from += 2.0 * v / g;
  }
}

/// An arc keeps its velocity along the ground as a float rounded towards zero.
constexpr double kFloatStep = 1.2e-7;

TEST(Bounce, TheSpeedAlongTheGroundLosesTheFrictionsShareEachTime) {
  const double f = 0.35, e = 0.5;
  const auto explosion = compiled(bouncer(e, f));
  const ExactFrame start = exactAt(*explosion, 0.0);
  double contact = 0.0, flight = 2.0 * start.vy[0] / g, kept = 1.0;
  for (int n = 0; n < 8; ++n, flight *= e, kept *= 1 - f) {
    const ExactFrame middle = exactAt(*explosion, contact + 0.5 * flight);
    for (const auto& [now, launched] : {std::pair(middle.vx[0], start.vx[0]), std::pair(middle.vz[0], start.vz[0])}) {
      EXPECT_LE(std::fabs(now), kept * std::fabs(launched) * (1 + 1e-13));
      EXPECT_GE(std::fabs(now), kept * std::fabs(launched) * (1 - kFloatStep * n) * (1 - 1e-13));
      EXPECT_EQ(std::signbit(now), std::signbit(launched));
    }
    contact += flight;
  }
}

TEST(Bounce, RestsBelowTheThresholdAndStaysThere) {
  Preset preset = bouncer(0.5, 0.2);
  preset.layers[0].rest_speed_mps = 1.0;
  const auto explosion = compiled(preset);
  const double speed = exactAt(*explosion, 0.0).vy[0];
  // The speed after contact n is speed 0.5^n; the first one below 1 m/s rests.
  const int expected = static_cast<int>(std::floor(std::log2(speed))) + 1;
  const ExactFrame now = exactAt(*explosion, 50.0), later = exactAt(*explosion, 80.0);
  EXPECT_EQ(now.bounces[0], expected);
  EXPECT_EQ(now.y[0], 0.0);
  EXPECT_EQ(now.vx[0], 0.0);
  EXPECT_EQ(now.vy[0], 0.0);
  EXPECT_EQ(now.x[0], later.x[0]);
}

TEST(Bounce, StaysAtTheContactAfterTheLastAllowedBounce) {
  Preset preset = bouncer(0.9, 0.0);
  preset.layers[0].bounce_limit = 3;
  const ExactFrame now = exactAt(*compiled(preset), 60.0);
  EXPECT_EQ(now.bounces[0], 4);
  EXPECT_EQ(now.vy[0], 0.0);
  preset.layers[0].bounce_limit = 0;
  EXPECT_EQ(exactAt(*compiled(preset), 60.0).bounces[0], 1);
}

TEST(Bounce, EnergyNeverRisesAndNothingIsUnderTheGround) {
  for (const double drag : {0.0, 1e-4, 0.4, 5.0}) {
    Preset preset = bouncer(0.8, 0.1);
    preset.layers[0].count = 64;
    preset.layers[0].drag_ps = drag;
    preset.ground_height_m = 12.0;
    const auto explosion = compiled(preset);
    std::vector<double> last(64, 1e300);
    for (int k = 0; k < 2000; ++k) {
      const ExactFrame now = exactAt(*explosion, 0.01 * k);
      for (std::size_t i = 0; i < now.count; ++i) {
        EXPECT_GE(now.y[i], 12.0 - 1e-9) << drag;
        const double energy = 0.5 * (now.vx[i] * now.vx[i] + now.vy[i] * now.vy[i] + now.vz[i] * now.vz[i]) + g * (now.y[i] - 12.0);
        EXPECT_LE(energy, last[i] * (1 + 1e-12) + 1e-9) << drag << " at " << 0.01 * k;
        last[i] = energy;
      }
    }
  }
}

TEST(Bounce, ContactsUnderDragSolveTheEquationOfMotion) {
  // For each strength, the first contact must be where the closed form, written out here once more, crosses zero.
  for (const double k : {1e-5, 1e-3, 0.05, 0.7, 8.0, 90.0}) {
    Preset preset = bouncer(0.5, 0.2);
    preset.burst = BurstKind::air;
    preset.burst_height_m = 30.0;
    preset.layers[0].count = 40;
    preset.layers[0].drag_ps = k;
    preset.layers[0].lifetime_mean_s = 500.0;
    const auto explosion = compiled(preset);
    const ExactFrame start = exactAt(*explosion, 0.0);
    for (std::size_t i = 0; i < start.count; ++i) {
      const auto height = [&](double t) {
        const double reach = -std::expm1(-k * t) / k;
        const double fallen = k * t < 1e-4 ? t * t * (0.5 - k * t / 6) : (t - reach) / k;
        return start.y[i] + start.vy[i] * reach - g * fallen;
      };
      double low = 0.0, high = 400.0;
      for (int n = 0; n < 200; ++n) (height(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
      EXPECT_EQ(exactAt(*explosion, low * (1 - 1e-8)).bounces[i], 0) << k;
      EXPECT_GE(exactAt(*explosion, high * (1 + 1e-8)).bounces[i], 1) << k;
    }
  }
}

TEST(Bounce, HotPiecesThatRiseForEverNeverLand) {
  for (const double drag : {0.0, 0.5}) {
    Preset preset = bouncer(0.5, 0.2);
    preset.layers[0].buoyancy_mps2 = 12.0;
    preset.layers[0].drag_ps = drag;
    const ExactFrame now = exactAt(*compiled(preset), 90.0);
    EXPECT_EQ(now.bounces[0], 0);
    EXPECT_GT(now.y[0], 0.0);
  }
}

TEST(Bounce, APieceThrownDownFasterThanItFallsLandsOnce) {
  Preset preset = bouncer(0.0, 1.0);
  preset.burst = BurstKind::air;
  preset.burst_height_m = 20.0;
  Layer& layer = preset.layers[0];
  layer.directionality = Directionality::cone;
  layer.direction = {0, -1, 0};
  layer.ejection_angle_rad = 0.0;
  layer.drag_ps = 3.0;  // terminal velocity 3.3 m/s, launched at 15
  const ExactFrame now = exactAt(*compiled(preset), 90.0);
  EXPECT_EQ(now.bounces[0], 1);
  EXPECT_EQ(now.y[0], 0.0);
}

/// A flat surface that does not say so, to send the general search over known answers.
class UnadmittedFlat : public Ground {
 public:
  double height(double, double) const override { return 3.0; }
};

TEST(Bounce, OverAHeightFunctionFlatGroundGivesTheSameFlight) {
  Preset preset = bouncer(0.6, 0.2);
  preset.layers[0].count = 20;
  preset.layers[0].rest_speed_mps = 0.5;
  preset.layers[0].drag_ps = 0.1;
  const UnadmittedFlat rough;
  const FlatGround flat(3.0);
  const auto a = compiled(preset, &rough), b = compiled(preset, &flat);
  for (const double t : {0.5, 3.0, 5.0, 9.0, 30.0}) {
    const ExactFrame fa = exactAt(*a, t), fb = exactAt(*b, t);
    for (std::size_t i = 0; i < fa.count; ++i) {
      EXPECT_EQ(fa.bounces[i], fb.bounces[i]);
      EXPECT_NEAR(fa.y[i], fb.y[i], 1e-7);
      EXPECT_NEAR(fa.x[i], fb.x[i], 1e-4);
    }
  }
}

class Slope : public Ground {
 public:
  double height(double x, double) const override { return -0.5 * x; }
};

TEST(Bounce, OnASlopeTheVelocityTurnsAboutTheNormal) {
  Preset preset = bouncer(0.5, 0.25);
  Layer& layer = preset.layers[0];
  layer.region_shape = RegionShape::point;
  layer.ejection_angle_rad = 0.0;
  layer.speed_deviation_mps = 0.0;
  const Slope slope;
  const auto explosion = compiled(preset, &slope);
  // Straight up and down again at 15 m/s, onto ground that falls towards east.
  const double back = 2.0 * 15.0 / g;
  const ExactFrame after = exactAt(*explosion, back + 1e-9);
  ASSERT_EQ(after.bounces[0], 1);
  const double n = 1.0 / std::sqrt(1.25), nx = 0.5 * n, ny = n;
  const double towards = -15.0 * ny, away = -0.5 * towards;
  EXPECT_NEAR(after.vx[0], 0.75 * (0.0 - towards * nx) + away * nx, 1e-6);
  EXPECT_NEAR(after.vy[0], 0.75 * (-15.0 - towards * ny) + away * ny, 1e-6);
}

TEST(Bounce, OverHillsNothingIsEverUnderTheGround) {
  struct Hills : Ground {
    double height(double x, double z) const override { return 3.0 * std::sin(0.3 * x) * std::cos(0.2 * z); }
  } hills;
  Preset preset = bouncer(0.5, 0.2);
  preset.layers[0].count = 50;
  preset.layers[0].rest_speed_mps = 0.3;
  preset.layers[0].lifetime_mean_s = 20.0;
  const auto explosion = compiled(preset, &hills);
  for (int k = 0; k < 400; ++k) {
    const ExactFrame now = exactAt(*explosion, 0.05 * k);
    for (std::size_t i = 0; i < now.count; ++i) ASSERT_GE(now.y[i], hills.height(now.x[i], now.z[i]) - 1e-4) << 0.05 * k << " " << i;
  }
}

}  // namespace
}  // namespace npsee
