#pragma once

#include "app/render/ground_level.h"
#include "app/render/tiles.h"
#include "app/render/view.h"

#include <npsee/explosion.h>

#include <span>

namespace npsee::render {

/// Marks every tile that the particles may draw in, with their shadows and light on the ground if wanted. Never too few, sometimes more
/// than needed.
void markEffect(TileMask& mask, const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, bool shadows);

/// Marks the tiles of particles that may be brighter than a picture can show: flashes, fire, streaks of light.
void markBright(TileMask& mask, const Frame& frame, std::span<const LayerSpan> layers, const View& view);

}  // namespace npsee::render
