#pragma once

#include <npsee/preset.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace npsee::editor {

/// What the particles of a layer are given when they start, one entry per particle: drawn from the layer alone, as if it hung on nothing
/// and began all at once, so that every layer has them. Of a layer without a parent they are the very draws of the explosion.
struct LaunchProbe {
  std::vector<float> x_m, y_m, z_m;  ///< place in the region, from its centre
  std::vector<float> speed_mps, size_m, angle_rad, lifetime_s;  ///< the angle is from the principal direction
};

/// The first `most` particles of the layer; none where the layer has no particles or the preset is not valid.
LaunchProbe probeLaunch(const Preset& preset, int layer, std::size_t most);

/// How often values lie in equal parts of their range.
struct Histogram {
  static constexpr std::size_t kBins = 36;
  double low = 0.0, high = 0.0, mean = 0.0;
  std::array<int, kBins> bins{};
  int most = 0;  ///< in one bin
  bool spread() const { return high > low; }
};
Histogram histogramOf(std::span<const float> values);

}  // namespace npsee::editor
