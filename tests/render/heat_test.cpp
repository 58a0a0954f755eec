// Hot particles: how they cool, what they give off, and what is seen of it.
#include "app/render/heat.h"

#include "tests/support/rendering.h"
#include "tests/support/scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace npsee::render {
namespace {

LayerSpan hotLayer(double temperature_k, double cooling_s) {
  LayerSpan out{"hot", 0, 0, Form::tetrahedron};
  out.temperature_k = temperature_k;
  out.cooling_s = cooling_s;
  return out;
}

TEST(Heat, ABodyCoolsByTheFourthPowerOfItsTemperature) {
  const LayerSpan layer = hotLayer(1600.0, 2.0);
  EXPECT_EQ(temperatureAt(layer, 0.0), 1600.0);
  EXPECT_NEAR(temperatureAt(layer, 2.0) / 1600.0, 0.63, 0.001);
  // dT/dt = -k T^4 with one k for all times.
  const auto k = [&](double t) { return -(temperatureAt(layer, t + 1e-4) - temperatureAt(layer, t - 1e-4)) / 2e-4 / std::pow(temperatureAt(layer, t), 4.0); };
  EXPECT_NEAR(k(5.0) / k(0.5), 1.0, 1e-5);
  EXPECT_EQ(temperatureAt(hotLayer(0.0, 2.0), 1.0), 0.0);
}

TEST(Heat, TheLightHasABlackBodysColour) {
  // Planck's law, beside which Wien's is within a part in a thousand at these temperatures.
  const auto planck = [](double wavelength_m, double t) { return 1.0 / (std::exp(0.014387769 / (wavelength_m * t)) - 1.0); };
  const auto beside_white = [&](double wavelength_m, double t) { return planck(wavelength_m, t) / planck(wavelength_m, 6500.0); };
  for (const double t : {1100.0, 1500.0, 2200.0}) {
    const Vec3 light = emittedLight(t);
    // Planck's white is up to 3 % brighter in the red than Wien's.
    EXPECT_NEAR(light.y / light.x, beside_white(550e-9, t) / beside_white(610e-9, t), 0.03 * light.y / light.x) << t;
    EXPECT_NEAR(light.z / light.x, beside_white(465e-9, t) / beside_white(610e-9, t), 0.03 * light.z / light.x + 1e-6) << t;
  }
  EXPECT_EQ(emittedLight(650.0), Vec3{});
  double before = 0.0;
  for (double t = 700.0; t < 4000.0; t += 50.0) {
    EXPECT_GE(emittedLight(t).x, before - 1e-12) << t;
    before = emittedLight(t).x;
    EXPECT_LE(before, 2.5);
  }
}

TEST(Heat, ASoftFormTakesTheColourOfItsHeatAndThenItsOwn) {
  const Colour soot{0.12, 0.11, 0.10};
  EXPECT_EQ(hotColour(soot, 600.0), soot);
  const Colour white = hotColour(soot, 6500.0);
  EXPECT_NEAR(white.r, 1.0, 1e-9);
  EXPECT_NEAR(white.b, 1.0, 1e-9);
  const Colour flame = hotColour(soot, 1900.0);
  EXPECT_GT(flame.r, flame.g);
  EXPECT_GT(flame.g, flame.b);
}

struct Heated : test::Rendering {
  /// A large piece in the middle of a picture, at a temperature.
  Image piece(double temperature_k, double opacity = 1.0) {
    test::HandMade made;
    made.add(Form::tetrahedron, {0.0, 5.0, 0.0}, 4.0, {0.2, 0.2, 0.2}, opacity);
    made.frame.age.assign(1, 0.0f);
    made.layers.front().temperature_k = temperature_k;
    Scene scene;
    scene.frame = &made.frame;
    scene.layers = made.layers;
    Camera camera;
    camera.eye = {0.0, 5.0, 12.0};
    camera.target = {0.0, 5.0, 0.0};
    return picture(scene, camera, 96, 64);
  }
};

TEST_F(Heated, AHotPieceGlowsRedAndAHotterOneYellow) {
  const Image cold = piece(0.0), red = piece(1250.0), yellow = piece(1700.0);
  const std::uint8_t *c = cold.pixel(48, 32), *r = red.pixel(48, 32), *y = yellow.pixel(48, 32);
  EXPECT_GT(r[0], c[0] + 60);
  EXPECT_LT(r[1] - c[1], (r[0] - c[0]) / 2);
  EXPECT_GE(y[0], r[0]);
  EXPECT_GT(y[1], r[1] + 60);
  EXPECT_EQ(cold.pixel(2, 2)[0], red.pixel(2, 2)[0]) << "what is not hot stays as it is";
}

TEST_F(Heated, APieceThatOneSeesThroughGlowsToo) {
  const Image cold = piece(0.0, 0.5), hot = piece(1500.0, 0.5);
  EXPECT_GT(hot.pixel(48, 32)[0], cold.pixel(48, 32)[0] + 40);
}

TEST_F(Heated, HeatIsForgottenWithTheFrameThatHadIt) {
  const Image before = piece(0.0);
  piece(1500.0);
  EXPECT_EQ(piece(0.0).rgba, before.rgba);
}

}  // namespace
}  // namespace npsee::render
