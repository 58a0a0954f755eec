#pragma once

#include "sim/explosion/flight.h"

namespace npsee::explosion {

/// Far beyond any lifetime: "no contact".
constexpr double kNever_s = 1e30;

/// First time in (0, life] at which a particle starting `y` above flat ground with vertical velocity vy meets it, or kNever_s.
/// y >= 0. T is double or Doubles; each lane's result is the same whatever stands in the others.
///
/// The height's second derivative keeps its sign over an arc (a - k (vy - wy) at first, then only fading), so Newton's iteration
/// runs monotonically into the root: from the right where the arc is concave, from the left where it is convex.
template <FlightLaw kLaw, class T>
NPSEE_KERNEL_INLINE T contactTime(const Flight& f, T y, T vy, T life) {
  using elementary_detail::constant;
  using lanes::select;
  const T never = constant<T>(kNever_s), zero = constant<T>(0.0);

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
    T end_height, end_speed;
    fallen<kLaw, T>(f, y, vy, life, end_height, end_speed);
    const T bend = f.a - f.k * (vy - f.wy);
    const auto concave = bend <= 0.0;

    // Concave: the end of life is right of the root if it is under ground; so are the tangent at the start of a fall and the
    // parabola of the least curvature on the way.
    T right = life;
    const T tangent = y / select(vy < 0.0, -vy, constant<T>(1.0));
    right = select(vy < 0.0, lanes::lesser(right, tangent), right);
    const T least_bend = -bend * exponential(-f.k * right);
    const T arch = (vy + lanes::squareRoot(vy * vy + 2.0 * least_bend * y)) / select(least_bend > 1e-12, least_bend, constant<T>(1.0));
    right = select(least_bend > 1e-12, lanes::lesser(right, arch), right);
    T tau = select(concave, right, zero);

    auto active = (concave & (end_height <= 0.0)) | (~concave & (vy < 0.0));
    T found = never;
    for (int step = 0; step < 80 && lanes::any(active); ++step) {
      T height, speed;
      fallen<kLaw, T>(f, y, vy, tau, height, speed);
      // A convex arc that has stopped falling above ground never meets it.
      const auto missed = ~concave & (speed >= 0.0) & (height > 0.0);
      const T move = height / select(speed < 0.0, -speed, constant<T>(1e-300));
      const T next = tau + move;
      // Done when rounding has ended the monotonic approach.
      const T size = select(move < 0.0, -move, move);
      const auto settled = (size <= 4e-16 * tau) | (concave & (next >= tau)) | (~concave & (next <= tau));
      found = select(active & settled & ~missed, tau, found);
      active = active & ~settled & ~missed;
      tau = select(active, next, tau);
    }
    found = select(active, tau, found);
    return select(found <= life, found, never);
  }
}

}  // namespace npsee::explosion
