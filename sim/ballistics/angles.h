#pragma once

#include <npsee/units.h>

#include <cmath>

namespace npsee::ballistics {

/// Arc tangent from square roots and a power series, with equal bits on every CPU (the C library's differ between them).
///
///   atan x = 2 atan(x / (1 + sqrt(1 + x^2))), twice, then x - x^3/3 + x^5/5 - ... for |x| <= 0.2
///
/// Relative error below 1e-15. Source: half-angle formula and Gregory's series.
inline double arcTangent(double x) {
  for (int i = 0; i < 2; ++i) x = x / (1.0 + std::sqrt(1.0 + x * x));
  const double x2 = x * x;
  double sum = 0.0;
  for (int k = 21; k >= 1; k -= 2) sum = 1.0 / k - x2 * sum;
  return 4.0 * x * sum;
}

/// Angle of the vector (x, y) from the x axis, in (-pi, pi]; 0 for the zero vector.
inline double angleOf(double x, double y) {
  if (x == 0.0 && y == 0.0) return 0.0;
  if (std::fabs(y) <= std::fabs(x)) {
    const double a = arcTangent(y / x);
    return x > 0.0 ? a : y >= 0.0 ? a + kPi : a - kPi;
  }
  return (y > 0.0 ? 0.5 * kPi : -0.5 * kPi) - arcTangent(x / y);
}

}  // namespace npsee::ballistics
