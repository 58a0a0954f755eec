#pragma once

#include "sim/explosion/flight.h"

namespace npsee::explosion {

/// Far beyond any lifetime: "no contact".
constexpr double kNever_s = 1e30;

/// Step to where a height falling at `speed` with the constant acceleration -fall reaches zero, ahead or behind: of the root's two forms
/// the one that does not cancel.
template <class T>
NPSEE_KERNEL_INLINE T toRoot(T height, T speed, T fall) {
  const T under = speed * speed + 2.0 * fall * height;
  const T root = lanes::squareRoot(lanes::select(under > 0.0, under, lanes::filled<T>(0.0)));
  const auto rising = speed > 0.0;
  return lanes::select(rising, speed + root, 2.0 * height) / lanes::select(rising, fall, root - speed);
}

/// Where to begin looking for the contact: good to 0.4 % for a bounce from the ground with k vy < g, exact as k vanishes. With
/// s = k vy / g the flight time T of a bounce solves (1 + s) (1 - e^{-kT}) = kT, and kT = 2 s (3 + s) / (3 + 2 s) has the right
/// value, slope and curvature at s = 0 and the right growth for large s.
template <class T>
NPSEE_KERNEL_INLINE T firstGuess(const Flight& f, T y, T vy, T first_bend) {
  const double pull = -f.a - f.k * f.wy;
  T fall = lanes::greater(-first_bend, lanes::filled<T>(0.0));
  if (pull > 0.0) {
    const T s = (f.k / pull) * vy;
    fall = lanes::select(vy > 0.0, pull * (3.0 + 2.0 * s) / (3.0 + s), fall);
  }
  return toRoot(y, vy, fall);
}

/// First time in (0, life] at which a particle starting `y` above flat ground with vertical velocity vy meets it, or kNever_s.
/// y >= 0. T is double, Doubles or Eight; each lane's result is the same whatever stands in the others.
///
/// Under drag the arc's vertical acceleration keeps its sign and only fades (a - k (vy - wy) at first). Where it is downward, stepping to
/// the root of the parabola with the present acceleration (Euler's third-order iteration) approaches the contact from the side it
/// started on and never passes it; where it is upward, the tangent does (Newton). Both are monotonic and need no bracket.
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
    const T first_bend = f.a - f.k * (vy - f.wy);
    const auto touching = (y <= 0.0) & (vy <= 0.0);
    T found = select(touching & (life > 0.0), zero, never);
    auto active = (life > 0.0) & ~touching & ((first_bend < 0.0) | (vy < 0.0));

    T tau = lanes::lesser(firstGuess(f, y, vy, first_bend), life);
    for (int step = 0; step < 100 && lanes::any(active); ++step) {
      T height, speed;
      fallen<kLaw, T>(f, y, vy, tau, height, speed);
      const T bend = f.a - f.k * (speed - f.wy);
      const T next = tau + toRoot(height, speed, lanes::greater(-bend, zero));
      const T move = next - tau, size = select(move < 0.0, -move, move);
      // The next error is about the cube of this step where the arc bends down, its square where it bends up.
      const auto settled = size <= select(bend < 0.0, lanes::filled<T>(1e-7), lanes::filled<T>(1e-9)) * tau;
      // Still above ground with the root beyond the end of life, or with none at all (a quotient beyond all bounds, 0/0).
      const auto missed = (height > 0.0) & ~(next <= life);
      found = select(active & settled & ~missed, next, found);
      active = active & ~settled & ~missed;
      tau = select(active, next, tau);
    }
    found = select(found <= life, found, never);
    return found;
  }
}

}  // namespace npsee::explosion
