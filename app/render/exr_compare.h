#pragma once

#include "app/render/deep_image.h"
#include "app/render/float_image.h"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

namespace npsee::render {

/// How one pass of two OpenEXR pictures of equal size differs, in the unit of the pass.
struct PassDifference {
  std::string_view name, unit;
  double max = 0.0;               ///< largest difference of a component where both have a number
  double mean = 0.0;              ///< over all pixels and components, of the same
  std::size_t differing = 0;      ///< pixels with any difference
  std::size_t in_one = 0;         ///< pixels that have a number in only one of them: a surface here and none there
  int x = 0, y = 0;               ///< pixel of the largest difference
  std::array<double, 4> before{}, after{};  ///< its components, of which the pass has so many:
  std::size_t components = 0;
};

/// The passes that both have, in the order light, depth, motion. Equal bits are equal, even where they are no number.
std::vector<PassDifference> comparePasses(const FloatImage& before, const FloatImage& after);

/// Passes that only one of them has.
std::vector<std::string_view> passesOfOne(const FloatImage& before, const FloatImage& after);

/// Light as `npsee render --background transparent` shows it: highlights rolled off, straight alpha, sRGB by IEC 61966-2-1. Black and
/// transparent where there is no colour, or no number.
DeepImage shown(const FloatImage& image);

}  // namespace npsee::render
