#pragma once

#include "sim/explosion/flight.h"

namespace npsee::explosion {

/// Far beyond any lifetime: "no contact".
constexpr double kNever_s = 1e30;

/// First time in (0, life] at which a particle starting `y` above flat ground with vertical velocity vy meets it, or kNever_s.
/// y >= 0. T is double, Doubles or Eight; each lane's result is the same whatever stands in the others.
///
/// The arc's vertical acceleration keeps its sign and only fades (a - k (vy - wy) at first). Where it is downward, the parabola with
/// the present acceleration falls faster than the arc, so stepping to its root (Euler's third-order iteration) approaches the
/// contact from before it and never passes; where it is upward, the tangent does (Newton). Both are monotonic and need no bracket.
template <FlightLaw kLaw, class T>
NPSEE_KERNEL_INLINE T contactTime(const Flight& f, T y, T vy, T life) {
  using lanes::select;
  const T never = lanes::filled<T>(kNever_s), zero = lanes::filled<T>(0.0);

  if constexpr (kLaw == FlightLaw::ballistic) {
    const double g = -f.a;
    T tau;
    if (g > 0.0) {
      tau = (vy + lanes::squareRoot(vy * vy + (2.0 * g) * y)) * (1.0 / g);
    } else {
      // Straight or rising: only a fall meets the ground, at the smaller root.
      const T under = vy * vy + (2.0 * g) * y;
      const T root = lanes::squareRoot(select(under > 0.0, under, zero));
      tau = select(vy < 0.0, (2.0 * y) / (root - vy), never);
      tau = select(under < 0.0, never, tau);
    }
    return select(tau <= life, tau, never);
  } else {
    T tau = zero, height = y, speed = vy, bend = f.a - f.k * (vy - f.wy);
    T found = never;
    auto active = life > 0.0;
    for (int step = 0; step < 100; ++step) {
      const T fall = lanes::greater(-bend, zero);
      const T root = lanes::squareRoot(speed * speed + 2.0 * fall * height);
      // The two forms of the same root, each where it does not cancel; neither divides by zero where it is chosen.
      const auto rising = speed > 0.0;
      const T move = select(rising, speed + root, 2.0 * height) / select(rising, fall, root - speed);
      // A piece on the ground that does not move has met it.
      const T next = select((height <= 0.0) & (speed <= 0.0), tau, tau + move);
      const auto settled = next <= tau * (1.0 + 4e-16);
      found = select(active & settled, tau, found);
      // Never: rising or hanging without a fall (a quotient beyond all bounds or 0/0), or later than the life lasts.
      active = active & ~settled & (next <= life);
      if (!lanes::any(active)) break;
      tau = select(active, next, tau);
      fallen<kLaw, T>(f, y, vy, tau, height, speed);
      bend = f.a - f.k * (speed - f.wy);
    }
    return found;
  }
}

}  // namespace npsee::explosion
