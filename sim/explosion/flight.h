#pragma once

#include "sim/core/elementary.h"
#include "sim/core/lanes.h"

namespace npsee::explosion {

/// How a layer's particles move between ground contacts; docs/physics.md derives it.
enum class FlightLaw {
  ballistic,    ///< no drag: x = x0 + v0 t + a t^2 / 2
  exponential,  ///< drag: x = x0 + u t + (v0 - u) (1 - e^{-kt}) / k, u = wind + a / k
  series,       ///< weak drag, where the formula above would lose digits
};

/// Constants of a layer's flight, SI.
struct Flight {
  FlightLaw law = FlightLaw::ballistic;
  double k = 0.0;                ///< drag, 1/s
  double inverse_k = 0.0;        ///< 1/k, s (exponential law)
  double wx = 0, wy = 0, wz = 0; ///< wind, m/s
  double a = 0.0;                ///< vertical acceleration, gravity and buoyancy together, m/s^2
  double uy = 0.0;               ///< terminal vertical velocity wy + a / k, m/s (exponential law)
};

// Below it the series holds to 1e-16 for any lifetime (z < 1); above it cancellation stays below 3e-8 m.
constexpr double kWeakDrag_ps = 2e-4;

/// One arc's starting state, as one number or lanes of them.
template <class T>
struct Motion {
  T x, y, z, vx, vy, vz;
};

/// (1 - (1 - e^{-z}) / z) / z for 0 <= z <= 1 by its Taylor series 1/2 - z/6 + z^2/24 - ...
template <class T>
NPSEE_KERNEL_INLINE T weakDragSeries(T z) {
  // 16 terms: the first one left out is z^16/18! < 2e-16.
  T sum = lanes::filled<T>(1.0 / 355687428096000.0);  // 1/17!
  const double inverse_factorials[] = {1.0 / 20922789888000.0, 1.0 / 1307674368000.0, 1.0 / 87178291200.0, 1.0 / 6227020800.0, 1.0 / 479001600.0,
                                       1.0 / 39916800.0,       1.0 / 3628800.0,       1.0 / 362880.0,      1.0 / 40320.0,      1.0 / 5040.0,
                                       1.0 / 720.0,            1.0 / 120.0,           1.0 / 24.0,          1.0 / 6.0,          0.5};
  for (const double term : inverse_factorials) sum = term - z * sum;
  return sum;
}

/// State after tau seconds without a contact. Exact; no step.
template <FlightLaw kLaw, class T>
NPSEE_KERNEL_INLINE Motion<T> flown(const Flight& f, const Motion<T>& m, T tau) {
  if constexpr (kLaw == FlightLaw::ballistic) {
    return {m.x + m.vx * tau, m.y + (m.vy + (0.5 * f.a) * tau) * tau, m.z + m.vz * tau, m.vx, m.vy + f.a * tau, m.vz};
  } else if constexpr (kLaw == FlightLaw::exponential) {
    const T decay = exponential(-f.k * tau);
    const T reach = (1.0 - decay) * f.inverse_k;
    const T dx = m.vx - f.wx, dy = m.vy - f.uy, dz = m.vz - f.wz;
    return {m.x + f.wx * tau + dx * reach, m.y + f.uy * tau + dy * reach, m.z + f.wz * tau + dz * reach, f.wx + dx * decay, f.uy + dy * decay, f.wz + dz * decay};
  } else {
    const T z = f.k * tau;
    const T second = weakDragSeries(z);     // (1 - first) / z
    const T first = 1.0 - z * second;       // (1 - e^{-z}) / z
    const T reach = tau * first, carried = tau - reach, fallen = f.a * tau * tau * second;
    const T decay = 1.0 - z * first;
    return {m.x + m.vx * reach + f.wx * carried,
            m.y + m.vy * reach + f.wy * carried + fallen,
            m.z + m.vz * reach + f.wz * carried,
            m.vx * decay + f.wx * (1.0 - decay),
            m.vy * decay + f.wy * (1.0 - decay) + f.a * reach,
            m.vz * decay + f.wz * (1.0 - decay)};
  }
}

/// The same by the layer's law.
NPSEE_KERNEL_INLINE Motion<double> flownBy(const Flight& f, const Motion<double>& m, double tau) {
  switch (f.law) {
    case FlightLaw::ballistic: return flown<FlightLaw::ballistic, double>(f, m, tau);
    case FlightLaw::exponential: return flown<FlightLaw::exponential, double>(f, m, tau);
    case FlightLaw::series: return flown<FlightLaw::series, double>(f, m, tau);
  }
  return m;
}

/// Height above the arc's start plus `y`, and vertical velocity: the part of flown() that finding a contact needs.
template <FlightLaw kLaw, class T>
NPSEE_KERNEL_INLINE void fallen(const Flight& f, T y, T vy, T tau, T& height, T& speed) {
  const T zero = lanes::filled<T>(0.0);
  const Motion<T> m = flown<kLaw, T>(f, {zero, y, zero, zero, vy, zero}, tau);
  height = m.y;
  speed = m.vy;
}

}  // namespace npsee::explosion
