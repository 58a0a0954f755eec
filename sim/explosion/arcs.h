#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <vector>

namespace npsee::explosion {

/// Start of one arc, packed to 44 bytes. Times and velocities are full doubles, so that flight times, energies and the geometric
/// series of bounces are exact; a contact's place is rounded to float (at 60 m by 2 micrometres), on flat ground not even that
/// vertically, as the height is then the ground's.
#pragma pack(push, 4)
struct Arc {
  double start_s;      ///< age at which the arc begins
  double vx, vy, vz;   ///< m/s
  float x, y, z;       ///< m, relative to the chunk's origin for a particle's first arc, to the ground point below it after
};
#pragma pack(pop)
static_assert(sizeof(Arc) == 44);

constexpr int kChunkParticles = 1024;
constexpr std::uint8_t kNoRest = 255;

/// Compiled state of up to kChunkParticles particles of one layer.
struct Chunk {
  /// All arrays live in `memory`, which must outlive the chunk.
  explicit Chunk(std::pmr::memory_resource* memory)
      : arcs(memory), first_arc(memory), last_arc(memory), rest_arc(memory), starts(memory), first_row(memory), birth_s(memory), lifetime_s(memory), size_m(memory),
        axis_x(memory), axis_y(memory), axis_z(memory), phase_rad(memory), rate_radps(memory) {}

  std::size_t first = 0;    ///< index of the first particle in the frame
  int count = 0;

  std::pmr::vector<Arc> arcs;                 ///< all arcs, particle after particle; one spare at the end
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
