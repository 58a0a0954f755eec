#include "app/render/heat.h"

#include "app/render/frame_particles.h"
#include "app/render/srgb.h"
#include "app/render/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace npsee::render {
namespace {

/// Second radiation constant, m K.
constexpr double kC2 = 0.014387769;
constexpr std::array<double, 3> kWavelengths_m{610e-9, 550e-9, 465e-9};
constexpr double kWhite_K = 6500.0;
constexpr double kDaylight_K = 1300.0;
constexpr double kMost = 2.5;

// As in heat.glsl.
constexpr double kFirst_K = 700.0, kStep_K = 100.0;
constexpr std::size_t kSteps = 32;

/// Light at a wavelength at T beside that at `beside`, by Wien's law.
double wien(double wavelength_m, double temperature_k, double beside_k) { return std::exp(-kC2 / wavelength_m * (1.0 / temperature_k - 1.0 / beside_k)); }

/// Colour with a largest component of 1.
Vec3 chroma(double temperature_k) {
  const Vec3 light{wien(kWavelengths_m[0], temperature_k, kWhite_K), wien(kWavelengths_m[1], temperature_k, kWhite_K), wien(kWavelengths_m[2], temperature_k, kWhite_K)};
  return (1.0 / std::max({light.x, light.y, light.z})) * light;
}

double brightness(double temperature_k) { return temperature_k < kFirst_K ? 0.0 : std::min(wien(kWavelengths_m[0], temperature_k, kDaylight_K), kMost); }

}  // namespace

double temperatureAt(const LayerSpan& layer, double age_s) {
  return layer.temperature_k > 0.0 ? layer.temperature_k / std::cbrt(1.0 + 3.0 * std::max(age_s, 0.0) / layer.cooling_s) : 0.0;
}

double temperatureAt(const LayerSpan& layer, const Frame& frame, std::size_t i) { return frame.age.size() > i ? temperatureAt(layer, static_cast<double>(frame.age[i])) : 0.0; }

Vec3 emittedLight(double temperature_k) {
  const double bright = brightness(temperature_k);
  return bright > 0.0 ? bright * chroma(temperature_k) : Vec3{};
}

Colour hotColour(const Colour& own, double temperature_k) {
  const double share = std::min(brightness(temperature_k), 1.0);
  if (share <= 0.0) return own;
  const Vec3 hot = chroma(temperature_k);
  const auto mixed = [&](double cold, double light) { return cold + share * (srgbFromLinear(light) - cold); };
  return {mixed(own.r, hot.x), mixed(own.g, hot.y), mixed(own.b, hot.z)};
}

void temperaturesOf(const Frame& frame, std::span<const LayerSpan> layers, std::vector<float>& out) {
  out.clear();
  if (frame.age.size() < frame.count || std::ranges::none_of(layers, [](const LayerSpan& layer) { return layer.temperature_k > 0.0; })) return;
  out.resize(frame.count, 0.0f);
  for (const LayerSpan& layer : layers) {
    if (layer.temperature_k <= 0.0) continue;
    const std::size_t end = endOf(layer, frame);
    for (std::size_t i = layer.first; i < end; ++i) out[i] = static_cast<float>(temperatureAt(layer, frame, i));
  }
}

void setEmitted(const gl::Program& program) {
  static const auto table = [] {
    std::array<Vec3, kSteps> out;
    for (std::size_t i = 0; i < kSteps; ++i) out[i] = emittedLight(kFirst_K + kStep_K * static_cast<double>(i));
    return out;
  }();
  for (std::size_t i = 0; i < kSteps; ++i) setVec3(program, ("u_emitted[" + std::to_string(i) + "]").c_str(), table[i]);
}

}  // namespace npsee::render
