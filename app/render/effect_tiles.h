#pragma once

#include "app/render/tiles.h"
#include "app/render/view.h"

#include <npsee/explosion.h>

#include <span>

namespace npsee::render {

/// Marks every tile that the particles may draw in, with their shadows on the ground if wanted. Never too few, sometimes more
/// than needed.
void markEffect(TileMask& mask, const Frame& frame, std::span<const LayerSpan> layers, const View& view, double ground_m, bool shadows);

}  // namespace npsee::render
