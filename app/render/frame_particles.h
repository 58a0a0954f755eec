#pragma once

#include <npsee/explosion.h>

#include <algorithm>
#include <cstddef>
#include <ranges>

namespace npsee::render {

/// Indices of a layer's particles in a frame, which may hold fewer than the layer has.
inline auto particlesOf(const LayerSpan& layer, const Frame& frame) {
  return std::views::iota(std::min(layer.first, frame.count), std::min(layer.first + layer.count, frame.count));
}

/// Where particle i is, in m.
inline Vec3 placeOf(const Frame& frame, std::size_t i) { return {static_cast<double>(frame.x[i]), static_cast<double>(frame.y[i]), static_cast<double>(frame.z[i])}; }

}  // namespace npsee::render
