#include "app/render/exr_compare.h"

#include "app/render/srgb.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

namespace npsee::render {
namespace {

struct Pass {
  std::string_view name, unit;
  std::size_t components;
  const std::vector<float>& (*of)(const FloatImage&);
};

constexpr std::array<Pass, 3> kPasses{{
    {"light", "", 4, [](const FloatImage& image) -> const std::vector<float>& { return image.rgba; }},
    {"depth", "m", 1, [](const FloatImage& image) -> const std::vector<float>& { return image.depth; }},
    {"motion", "pixels", 2, [](const FloatImage& image) -> const std::vector<float>& { return image.motion; }},
}};

bool allFinite(std::span<const float> values) {
  return std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
}

PassDifference compared(const Pass& pass, const FloatImage& a, const FloatImage& b) {
  PassDifference out;
  out.name = pass.name;
  out.unit = pass.unit;
  out.components = pass.components;
  const std::size_t n = pass.components, pixels = static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height);
  double sum = 0.0;
  for (std::size_t i = 0; i < pixels; ++i) {
    const std::span<const float> before(pass.of(a).data() + i * n, n), after(pass.of(b).data() + i * n, n);
    if (std::memcmp(before.data(), after.data(), n * sizeof(float)) == 0) continue;
    ++out.differing;
    if (!allFinite(before) || !allFinite(after)) {
      if (allFinite(before) != allFinite(after)) ++out.in_one;
      continue;
    }
    double largest = 0.0;
    for (std::size_t c = 0; c < n; ++c) {
      const double d = std::abs(static_cast<double>(before[c]) - static_cast<double>(after[c]));
      largest = std::max(largest, d);
      sum += d;
    }
    if (largest <= out.max) continue;
    out.max = largest;
    out.x = static_cast<int>(i % static_cast<std::size_t>(a.width));
    out.y = static_cast<int>(i / static_cast<std::size_t>(a.width));
    std::ranges::copy(before, out.before.begin());
    std::ranges::copy(after, out.after.begin());
  }
  out.mean = sum / static_cast<double>(std::max<std::size_t>(pixels * n, 1));
  return out;
}

double rolledOff(double c) {
  constexpr double kKnee = 0.8;
  const double over = std::max(c - kKnee, 0.0) / (1.0 - kKnee);
  return std::min(c, kKnee) + (1.0 - kKnee) * over / (1.0 + over);
}

std::uint16_t coded(double c) { return static_cast<std::uint16_t>(std::lround(65535.0 * std::clamp(srgbFromLinear(c), 0.0, 1.0))); }

}  // namespace

std::vector<PassDifference> comparePasses(const FloatImage& before, const FloatImage& after) {
  std::vector<PassDifference> out;
  for (const Pass& pass : kPasses)
    if (!pass.of(before).empty() && !pass.of(after).empty()) out.push_back(compared(pass, before, after));
  return out;
}

std::vector<std::string_view> passesOfOne(const FloatImage& before, const FloatImage& after) {
  std::vector<std::string_view> out;
  for (const Pass& pass : kPasses)
    if (pass.of(before).empty() != pass.of(after).empty()) out.push_back(pass.name);
  return out;
}

DeepImage shown(const FloatImage& image) {
  DeepImage out{image.width, image.height, 16, true, {}};
  out.rgba.resize(4u * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
    const std::span<const float> pixel(image.rgba.data() + i, 4);
    if (!allFinite(pixel)) continue;
    std::array<double, 3> light{};
    for (std::size_t c = 0; c < 3; ++c) light[c] = rolledOff(std::max(static_cast<double>(pixel[c]), 0.0));
    // Light without cover needs some alpha to be kept.
    const double alpha = std::clamp(std::max(static_cast<double>(pixel[3]), std::ranges::max(light)), 0.0, 1.0);
    for (std::size_t c = 0; c < 3; ++c) out.rgba[i + c] = coded(std::min(light[c] / std::max(alpha, 1e-4), 1.0));
    out.rgba[i + 3] = static_cast<std::uint16_t>(std::lround(65535.0 * alpha));
  }
  return out;
}

}  // namespace npsee::render
