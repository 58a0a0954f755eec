#pragma once

#include "sim/core/random.h"
#include "sim/explosion/kernels.h"

#include <npsee/preset.h>

namespace npsee::explosion {

/// What all particles of a layer's launch share, worked out once.
struct Emission {
  explicit Emission(const Preset& preset, const Layer& layer, bool has_parent);

  const Layer& layer;
  bool has_parent;
  bool neutral;          ///< equally in all directions
  bool mirror;           ///< places under the ground of a ground burst are mirrored up
  bool centred_height;   ///< box and cylinder stand about the centre
  Vec3 axis, east, south;  ///< orthonormal: principal direction and the two across it
  double cosine_limit, tangent_limit;
};

/// A launched particle: place relative to the burst's or the parent's, m, and its other draws.
struct Launch {
  Vec3 place, velocity;
  double lifetime_s = 0, birth_part = 0;
  double size_m = 0;
  Vec3 axis;
  double phase_rad = 0, rate_radps = 0;
};

/// Draws one particle. `place_above` is the height of the region's centre above the ground, m, for mirroring.
Launch launch(const Emission& emission, const ParticleIdentity& identity, double place_above);

}  // namespace npsee::explosion
