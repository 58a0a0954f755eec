#include "editor/document/life_presets.h"

#include <algorithm>

namespace npsee::editor {
namespace {

const std::vector<LifePreset<Curve>>& curves() {
  static const std::vector<LifePreset<Curve>> kCurves{
      {"Fade out", {{0, 1}, {1, 0}}},
      {"Hold, then fade", {{0, 1}, {0.7, 1}, {1, 0}}},
      {"Fade in", {{0, 0}, {1, 1}}},
      {"In and out", {{0, 0}, {0.2, 1}, {0.7, 1}, {1, 0}}},
      {"Flash", {{0, 1}, {0.08, 0.6}, {0.3, 0.15}, {1, 0}}},
      {"Smoke", {{0, 0}, {0.06, 1}, {0.4, 0.7}, {0.75, 0.3}, {1, 0}}},
      {"Shrink", {{0, 1}, {1, 0.1}}},
      {"Grow", {{0, 0.2}, {1, 1}}},
      {"Billow", {{0, 0.3}, {0.15, 1.2}, {0.5, 2.2}, {1, 3.2}}},
      {"Swell and shrink", {{0, 0.4}, {0.3, 1.6}, {1, 0.2}}},
      {"Pulse", {{0, 1}, {0.25, 0.4}, {0.5, 1}, {0.75, 0.4}, {1, 0}}},
  };
  return kCurves;
}

const std::vector<LifePreset<Gradient>>& gradients() {
  constexpr auto rgb = [](unsigned hex) { return Colour{((hex >> 16) & 255u) / 255.0, ((hex >> 8) & 255u) / 255.0, (hex & 255u) / 255.0}; };
  static const std::vector<LifePreset<Gradient>> kGradients{
      {"Fire", {{0, rgb(0xfff3c4)}, {0.15, rgb(0xffc65c)}, {0.4, rgb(0xf27a1f)}, {0.7, rgb(0x8a2f12)}, {1, rgb(0x2a1a14)}}},
      {"Fire to smoke", {{0, rgb(0xffe9a8)}, {0.12, rgb(0xff9d2e)}, {0.3, rgb(0x6b3a22)}, {0.5, rgb(0x3a3430)}, {1, rgb(0x5d5853)}}},
      {"Embers", {{0, rgb(0xffd27a)}, {0.3, rgb(0xff7a1e)}, {0.75, rgb(0xa5260d)}, {1, rgb(0x2b0d08)}}},
      {"Hot metal", {{0, rgb(0xffffff)}, {0.1, rgb(0xfff0b8)}, {0.3, rgb(0xffa23a)}, {0.6, rgb(0xb8400f)}, {1, rgb(0x3b3a3a)}}},
      {"Dark smoke", {{0, rgb(0x1f1c1a)}, {0.5, rgb(0x45403c)}, {1, rgb(0x77716b)}}},
      {"White smoke", {{0, rgb(0xf4f4f2)}, {1, rgb(0xb9bcc0)}}},
      {"Dust", {{0, rgb(0x6e5a41)}, {0.4, rgb(0x9b8461)}, {1, rgb(0xbfae8e)}}},
      {"Water", {{0, rgb(0xffffff)}, {0.4, rgb(0xcfe3ee)}, {1, rgb(0x8fb3c6)}}},
      {"Magnesium", {{0, rgb(0xffffff)}, {0.6, rgb(0xe8f1ff)}, {1, rgb(0xffd98a)}}},
      {"Green star", {{0, rgb(0xeaffd8)}, {0.3, rgb(0x86f06a)}, {1, rgb(0x0f5a1c)}}},
      {"Red star", {{0, rgb(0xffe0d8)}, {0.3, rgb(0xff5a46)}, {1, rgb(0x5a0f12)}}},
      {"Blue star", {{0, rgb(0xe2ecff)}, {0.3, rgb(0x6a94ff)}, {1, rgb(0x141f6b)}}},
  };
  return kGradients;
}

template <class Course>
std::vector<LifePreset<Course>> allowed(const std::vector<LifePreset<Course>>& all, const Parameter& parameter) {
  std::vector<LifePreset<Course>> out;
  for (const auto& preset : all)
    if (checkValue(parameter, preset.course).empty()) out.push_back(preset);
  return out;
}

template <class Course>
Course backwards(Course course) {
  std::ranges::reverse(course);
  for (auto& point : course) point.at = 1.0 - point.at;
  return course;
}

}  // namespace

std::vector<LifePreset<Curve>> curvePresets(const Parameter& parameter) { return allowed(curves(), parameter); }
std::vector<LifePreset<Gradient>> gradientPresets(const Parameter& parameter) { return allowed(gradients(), parameter); }

Curve reversed(Curve curve) { return backwards(std::move(curve)); }
Gradient reversed(Gradient gradient) { return backwards(std::move(gradient)); }

double valueOf(const Curve& curve, double at) {
  if (at <= curve.front().at) return curve.front().value;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const CurvePoint &a = curve[i - 1], &b = curve[i];
    if (at > b.at) continue;
    return b.at > a.at ? a.value + (at - a.at) / (b.at - a.at) * (b.value - a.value) : b.value;
  }
  return curve.back().value;
}

Colour colourOf(const Gradient& gradient, double at) {
  if (at <= gradient.front().at) return gradient.front().colour;
  for (std::size_t i = 1; i < gradient.size(); ++i) {
    const GradientStop &a = gradient[i - 1], &b = gradient[i];
    if (at > b.at) continue;
    const double u = b.at > a.at ? (at - a.at) / (b.at - a.at) : 1.0;
    return {a.colour.r + u * (b.colour.r - a.colour.r), a.colour.g + u * (b.colour.g - a.colour.g), a.colour.b + u * (b.colour.b - a.colour.b)};
  }
  return gradient.back().colour;
}

}  // namespace npsee::editor
