#pragma once

#include <npsee/explosion.h>

#include <cstddef>
#include <span>

namespace npsee::editor {

/// Figures of one moment.
struct FrameFigures {
  std::size_t alive = 0;
  double fastest_mps = 0.0;
  double energy_Jpkg = 0.0;  ///< mean kinetic energy of a kilogram of particles without a mass of their own, each counting alike
  double energy_J = 0.0;     ///< kinetic energy of those that have one, the pieces of models; without their spin
  std::size_t massive = 0;   ///< alive, with a mass
  Extent extent;             ///< of the particles alive; meaningless without any
};
/// The frame must hold velocities. Its layers say which particles have a mass.
FrameFigures figuresOf(const Frame& frame, std::span<const LayerSpan> layers = {});

}  // namespace npsee::editor
