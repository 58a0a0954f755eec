#pragma once

#include <array>
#include <cstdint>

namespace npsee {

/// Purposes of random draws of a particle. The written values are part of every preset's look: never renumber, only add.
enum class Draw : std::uint32_t {
  region_a = 0, region_b = 1, region_c = 2, speed = 3,
  angle = 4, azimuth = 5, size = 6, lifetime = 7,
  axis_a = 8, axis_b = 9, spin_phase = 10, spin_rate = 11,
  birth = 12,
};
inline constexpr int kDrawBlocks = 4;

/// Identity of one particle in the random numbers: nothing else enters, so that a particle's draws do not depend on how many
/// others there are, on order or on threads.
struct ParticleIdentity {
  std::uint64_t seed = 0;
  std::uint32_t layer_stream = 0;
  std::uint32_t index = 0;   ///< within its parent event, or within the layer
  std::uint32_t parent = 0;  ///< parent particle's index in its layer
  std::uint32_t event = 0;   ///< which of the parent's events (bounce number)
};

/// Four uniform numbers in (0, 1) of draw block `block` (draws 4 block .. 4 block + 3). Counter-based: Philox4x32-10
/// (Salmon, Moraes, Dror, Shaw 2011: Parallel random numbers: as easy as 1, 2, 3).
std::array<double, 4> uniformBlock(const ParticleIdentity& particle, std::uint32_t block);

/// Inverse of the standard normal distribution function, 0 < p < 1. Relative error about 1e-16.
/// Source: M. J. Wichura 1988, Algorithm AS 241 (PPND16), Applied Statistics 37, 477-484.
double inverseNormal(double p);

}  // namespace npsee
