#pragma once

#include <cmath>

namespace npsee::render {

/// sRGB coding and its inverse, 0..1 (IEC 61966-2-1); shaders/srgb.glsl is the same.
inline double srgbFromLinear(double c) { return c < 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055; }
inline double linearFromSrgb(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

}  // namespace npsee::render
