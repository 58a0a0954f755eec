#pragma once

#include "sim/explosion/emission.h"

#include <npsee/fragments.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace npsee::explosion {

struct CompiledLayer;

/// What a piece of a model has besides what every particle has. Particles fly as points; a piece flies `rise_m` above its point, so that
/// its underside and not its centre meets the ground, and turns onto a face of its own before it comes to rest.
struct PiecePose {
  float rise_m = 0.0f;
  float settled_rise_m = 0.0f;             ///< of the centre above the ground once it lies
  double settle_from_s = 0.0, settle_to_s = 0.0;  ///< ages; equal: it does not come to rest
  std::array<float, 4> settled{0, 0, 0, 1};       ///< orientation it lies in
};

/// The model of a layer, cut. Error kind input; faults of no other file point to the layer's model.
Expected<std::shared_ptr<const Fragments>> fragmentsOf(const Preset& preset, std::size_t layer, std::uint64_t seed, const SolidModel* instead);

/// Least distance of a piece's hull from its centre: it meets the ground this far below its centre at the latest. m.
double leastReach(const Piece& piece);

/// Launch of piece `number` in place of what was drawn for a particle; its place is relative to the layer's origin. Lifetime and birth stay.
void launchPiece(const Layer& layer, const Piece& piece, Launch& launch);

/// Fills the part of the poses that depends on where each piece comes to rest.
void settlePieces(const Ground& ground, CompiledLayer& layer);

/// Turns points into pieces: raises them, lets them settle, and holds still those that have not started. `view` is the whole layer's.
template <class Real>
void posePieces(const CompiledLayer& layer, double t_s, const FrameView<Real>& view);

}  // namespace npsee::explosion
