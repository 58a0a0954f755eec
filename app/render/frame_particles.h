#pragma once

#include <npsee/explosion.h>

#include <algorithm>
#include <cstddef>

namespace npsee::render {

/// One past the last of a layer's particles in a frame, which may hold fewer than the layer has; from `layer.first` on.
inline std::size_t endOf(const LayerSpan& layer, const Frame& frame) { return std::max(layer.first, std::min(layer.first + layer.count, frame.count)); }
/// How many of them the frame holds.
inline std::size_t countOf(const LayerSpan& layer, const Frame& frame) { return endOf(layer, frame) - layer.first; }

/// Where particle i is, in m.
inline Vec3 placeOf(const Frame& frame, std::size_t i) { return {static_cast<double>(frame.x[i]), static_cast<double>(frame.y[i]), static_cast<double>(frame.z[i])}; }

}  // namespace npsee::render
