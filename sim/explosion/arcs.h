#pragma once

#include "sim/core/lanes.h"

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <vector>

namespace npsee::explosion {

/// Start of one arc: half a cache line, so that looking up a particle at any time touches exactly one. Times and vertical velocities
/// are doubles: flight times, apexes and the geometric series of bounces are exact. A contact's place is rounded to float (at 60 m by 2
/// micrometres), and so is the velocity along the ground, towards zero, so that no contact adds energy (by one part in eight million at
/// most). What follows is computed from the rounded values: each arc is exact in itself.
struct alignas(32) Arc {
  /// Age at which the arc begins, s. A particle's first arc begins at age 0 and has its height here instead, m above the origin.
  double start_s;
  double vy;      ///< m/s
  float x, z;     ///< m, relative to the layer's origin for the first arc
  float vx, vz;   ///< m/s
};
static_assert(sizeof(Arc) == 32);

/// The float nearest to x that is not farther from zero; for magnitudes from 1e-38 on.
NPSEE_KERNEL_INLINE double floatTowardsZero(double x) { return __builtin_bit_cast(double, __builtin_bit_cast(std::int64_t, x) & lanes::kFloatBits); }

constexpr int kChunkParticles = 1024;
constexpr std::uint8_t kNoRest = 255;

/// Compiled state of up to kChunkParticles particles of one layer.
struct Chunk {
  /// All arrays live in `memory`, which must outlive the chunk.
  explicit Chunk(std::pmr::memory_resource* memory)
      : arcs(memory), heights(memory), first_arc(memory), last_arc(memory), rest_arc(memory), starts(memory), first_row(memory), birth_s(memory), lifetime_s(memory), size_m(memory),
        axis_x(memory), axis_y(memory), axis_z(memory), phase_rad(memory), rate_radps(memory) {}

  std::size_t first = 0;    ///< index of the first particle in the frame
  int count = 0;

  std::pmr::vector<Arc> arcs;                 ///< all arcs, particle after particle
  std::pmr::vector<float> heights;            ///< over a height function: y of each arc but the first ones, m. Empty on flat ground, where all have the ground's
  std::pmr::vector<std::uint32_t> first_arc;  ///< per particle
  std::pmr::vector<std::uint8_t> last_arc;    ///< per particle: number of its last arc
  std::pmr::vector<std::uint8_t> rest_arc;    ///< per particle: number of the arc from which it lies still, or kNoRest

  // Start times of arcs 1, 2, ... rounded down to float, four particles side by side, padded with infinity: where to look for
  // the arc of a given age.
  std::pmr::vector<float> starts;
  std::pmr::vector<std::uint32_t> first_row;  ///< per four particles, in rows of `starts`; one more at the end

  std::pmr::vector<double> birth_s;     ///< empty: all at Layer start
  std::pmr::vector<double> lifetime_s;
  std::pmr::vector<float> size_m;
  std::pmr::vector<float> axis_x, axis_y, axis_z, phase_rad, rate_radps;  ///< tumbling
};

}  // namespace npsee::explosion
