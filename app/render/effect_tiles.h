#pragma once

#include "app/render/ground_level.h"
#include "app/render/tiles.h"
#include "app/render/view.h"

#include <npsee/explosion.h>

#include <span>
#include <vector>

namespace npsee::render {

/// Marks every tile that the particles may draw in, with their shadows and light on the ground if wanted. Never too few, sometimes more
/// than needed.
void markEffect(TileMask& mask, const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, bool shadows);

/// Where the pieces (solid forms, and parts of models) of a picture may be seen. Never too little.
struct PieceSpread {
  struct Extent {
    PixelBox box;
    double nearest_m, farthest_m;  ///< along the view
  };
  std::vector<Extent> pieces;

  /// Whether any may reach between two distances along the view.
  bool reaches(double nearest_m, double farthest_m) const;
  /// Marks those that may reach between two distances along the view.
  void mark(TileMask& mask, double nearest_m, double farthest_m) const;
};

/// Finds them anew, in a picture of the mask's size.
void findPieces(PieceSpread& out, const TileMask& mask, const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground);

/// Marks the tiles of particles that may be brighter than a picture can show: flashes, fire, streaks of light.
void markBright(TileMask& mask, const Frame& frame, std::span<const LayerSpan> layers, const View& view);

}  // namespace npsee::render
