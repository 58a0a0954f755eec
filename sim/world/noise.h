#pragma once

#include <cmath>
#include <cstdint>

namespace npsee::world {

/// 32 well-mixed bits of a lattice point (finaliser of MurmurHash3, public domain, after odd multipliers).
inline std::uint32_t latticeBits(std::uint32_t seed, std::int32_t x, std::int32_t z) {
  std::uint32_t h = seed ^ (static_cast<std::uint32_t>(x) * 0x9e3779b1u) ^ (static_cast<std::uint32_t>(z) * 0x85ebca77u);
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13)) * 0xc2b2ae35u;
  return h ^ (h >> 16);
}

/// A seed of its own for each use of one terrain seed.
inline std::uint32_t mixedSeed(std::int64_t seed, std::uint32_t use) {
  const auto bits = static_cast<std::uint64_t>(seed);
  return latticeBits(latticeBits(use, static_cast<std::int32_t>(bits & 0xffffffffu), 17), static_cast<std::int32_t>(bits >> 32), 29);
}

/// Gradient noise of x, z (|.| up to 1e9) with features of size 1; smooth to the second derivative, about -1 to 1, mean 0.
/// Source: K. Perlin 2002, Improving noise, ACM Transactions on Graphics 21 (3), 681-682; with sixteen even directions.
inline double gradientNoise(std::uint32_t seed, double x, double z) {
  static constexpr double kCosine[16] = {1.0, 0.92387953251128674, 0.70710678118654752, 0.38268343236508977, 0.0, -0.38268343236508977, -0.70710678118654752, -0.92387953251128674,
                                         -1.0, -0.92387953251128674, -0.70710678118654752, -0.38268343236508977, 0.0, 0.38268343236508977, 0.70710678118654752, 0.92387953251128674};
  const double fx = std::floor(x), fz = std::floor(z), u = x - fx, v = z - fz;
  const auto ix = static_cast<std::int32_t>(fx), iz = static_cast<std::int32_t>(fz);
  const auto corner = [&](int cx, int cz) {
    const std::uint32_t direction = latticeBits(seed, ix + cx, iz + cz) & 15u;
    return kCosine[direction] * (u - cx) + kCosine[(direction + 12u) & 15u] * (v - cz);
  };
  const double su = u * u * u * (u * (u * 6.0 - 15.0) + 10.0), sv = v * v * v * (v * (v * 6.0 - 15.0) + 10.0);
  const double north = corner(0, 0) + su * (corner(1, 0) - corner(0, 0)), south = corner(0, 1) + su * (corner(1, 1) - corner(0, 1));
  return 1.5 * (north + sv * (south - north));
}

/// Sum of `octaves` noises, each at twice the frequency and `gain` times the amplitude of the last; the first has amplitude 1.
inline double layeredNoise(std::uint32_t seed, double x, double z, int octaves, double gain) {
  double sum = 0.0, amplitude = 1.0;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += amplitude * gradientNoise(seed + 0x632be59bu * static_cast<std::uint32_t>(octave), x, z);
    // Off the lattice of the last octave, whose zeros would otherwise meet.
    x = 2.0 * x + 0.37;
    z = 2.0 * z + 0.71;
    amplitude *= gain;
  }
  return sum;
}

}  // namespace npsee::world
