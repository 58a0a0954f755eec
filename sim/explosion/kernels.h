#pragma once

#include "sim/explosion/arcs.h"
#include "sim/explosion/flight.h"
#include "sim/explosion/turbulence.h"

#include <npsee/explosion.h>

namespace npsee::explosion {

/// What the kernels need to know of a layer.
struct LayerConstants {
  Flight flight;
  Turbulence turbulence;
  double origin_x = 0, origin_y = 0, origin_z = 0;  ///< added to first arcs, m
  double ground_y = 0;                              ///< y of later arcs, m (0 over a height function)
  double start_s = 0.0;                             ///< birth of all particles where a chunk has no own times
  bool follow = false;                              ///< flows along the ground: arcs are no contacts
  bool stands = false;                              ///< particles are there before their birth, from 0 on
  bool collide = true;
  double restitution = 0, friction = 0, rest_speed_mps = 0;
  int bounce_limit = 0;
  Colour colour;
  double colour_variation = 0.0, opacity = 1.0;
  Gradient colour_over_life;
  Curve opacity_over_life, size_over_life;
};

/// Launch states of a chunk, structure of arrays, padded to whole eights.
struct Launches {
  alignas(32) double x[kChunkParticles], y[kChunkParticles], z[kChunkParticles];  ///< relative to origin, each a float's value
  alignas(32) double vx[kChunkParticles], vy[kChunkParticles], vz[kChunkParticles];  ///< vx and vz each a float's value
  alignas(32) double lifetime_s[kChunkParticles];
};

/// Room for the arcs of eight particles while they are found.
struct ArcRoom {
  static constexpr int kArcs = 66;  ///< launch, 64 bounces, rest
  Arc arcs[lanes::kEight][kArcs];
  float heights[lanes::kEight][kArcs];  ///< as Chunk::heights; not on flat ground
  int last[lanes::kEight];
  bool rests[lanes::kEight];
};

/// Pointers into a frame for one chunk; null where a quantity is not wanted.
template <class Real>
struct FrameView {
  Real *x, *y, *z, *vx, *vy, *vz, *size, *age, *r, *g, *b, *a, *qx, *qy, *qz, *qw;
  std::uint8_t *alive, *bounces;
};

/// The code that exists once per instruction set; all sets give equal bits.
struct Kernels {
  void (*evaluate)(const LayerConstants&, const Chunk&, double t_s, const FrameView<float>&);
  void (*evaluate_exact)(const LayerConstants&, const Chunk&, double t_s, const FrameView<double>&);
  /// Arcs of launches [first, first + 8) over flat ground.
  void (*find_arcs)(const LayerConstants&, const Launches&, int first, ArcRoom&);
};

const Kernels& baselineKernels();
/// The best set this CPU has.
const Kernels& bestKernels();

}  // namespace npsee::explosion
