#pragma once

#include "sim/core/random.h"
#include "sim/explosion/flight.h"

namespace npsee::explosion {

/// Eddies that move a layer's particles off their paths; docs/physics.md has the formula. A sum of plane shear waves, each of which is free of
/// divergence by itself because its amplitude is normal to its wave vector.
/// Source: R. H. Kraichnan 1970, Diffusion by a random velocity field, Physics of Fluids 13, 22-31.
struct Turbulence {
  static constexpr int kWaves = 8;

  double amplitude_m = 0.0;  ///< largest displacement; 0 = none
  double floor_y = 0.0;      ///< height at which the vertical part vanishes, m
  struct Wave {
    double kx, ky, kz;   ///< wave vector, turns per metre
    double ax, ay, az;   ///< share of the amplitude; the lengths of all add up to 1
    double phase, rate;  ///< turns, turns over a lifetime
  } waves[kWaves] = {};
};

/// Eddies of size `size_m`. The waves' phases follow from the seed alone, so that layers of one explosion with one size move together.
Turbulence makeTurbulence(double amplitude_m, double size_m, double floor_y, std::uint64_t seed);

/// A sine-like wave of period 1 made of parabolas, and its slope: value 8 f (1 - 2 |f|), f the distance from the nearest whole number.
/// Slope continuous, both within 3 % (value) of the sine's.
template <class T>
NPSEE_KERNEL_INLINE void wave(T turns, T& value, T& slope) {
  constexpr double kRounder = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to whole numbers
  const T f = turns - ((turns + kRounder) - kRounder);
  const T size = lanes::select(f < 0.0, -f, f);
  value = (8.0 * f) * (1.0 - 2.0 * size);
  slope = 8.0 - 32.0 * size;
}

/// Moves a particle, and changes its velocity to the exact time derivative of its new path. `part` is the age as a part of the lifetime (the
/// moment it came to rest for one that lies still), `pace` 1 / lifetime, or 0 for one that lies still.
template <class T>
NPSEE_KERNEL_INLINE void stir(const Turbulence& eddies, T part, T pace, Motion<T>& m) {
  const T zero = lanes::filled<T>(0.0);
  T dx = zero, dy = zero, dz = zero, ux = zero, uy = zero, uz = zero;
  for (const Turbulence::Wave& w : eddies.waves) {
    T value, slope;
    wave<T>(w.kx * m.x + w.ky * m.y + w.kz * m.z + (w.phase + w.rate * part), value, slope);
    const T change = slope * (w.kx * m.vx + w.ky * m.vy + w.kz * m.vz + w.rate * pace);
    dx += w.ax * value;
    dy += w.ay * value;
    dz += w.az * value;
    ux += w.ax * change;
    uy += w.ay * change;
    uz += w.az * change;
  }
  // Grows from nothing at birth, most of it in the first half of the life.
  const T grown = eddies.amplitude_m * (part * (2.0 - part)), growing = eddies.amplitude_m * (2.0 * (1.0 - part)) * pace;
  // Nothing passes through the ground: the vertical part vanishes there, as at a wall.
  const T height = lanes::greater(m.y - eddies.floor_y, zero), reach = height + eddies.amplitude_m;
  const T share = height / reach, sharing = lanes::select(height > 0.0, eddies.amplitude_m * m.vy / (reach * reach), zero);
  const T up = grown * dy, rising = grown * uy + growing * dy;
  m.x += grown * dx;
  m.z += grown * dz;
  m.y += share * up;
  m.vx += grown * ux + growing * dx;
  m.vz += grown * uz + growing * dz;
  m.vy += share * rising + sharing * up;
}

}  // namespace npsee::explosion
