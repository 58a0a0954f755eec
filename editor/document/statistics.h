#pragma once

#include <npsee/explosion.h>

#include <cstddef>

namespace npsee::editor {

/// Figures of one moment.
struct FrameFigures {
  std::size_t alive = 0;
  double fastest_mps = 0.0;
  double energy_Jpkg = 0.0;  ///< mean kinetic energy of a kilogram of particles: particles have no mass, so that each counts alike
  Extent extent;             ///< of the particles alive; meaningless without any
};
/// The frame must hold velocities.
FrameFigures figuresOf(const Frame& frame);

}  // namespace npsee::editor
