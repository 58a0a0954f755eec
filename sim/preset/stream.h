#pragma once

#include <npsee/preset.h>

namespace npsee {

/// Identity of a layer in the random numbers: from its name and variation, so that adding, removing or moving other layers
/// changes nothing in this one.
std::uint32_t layerStream(const Layer& layer);

}  // namespace npsee
