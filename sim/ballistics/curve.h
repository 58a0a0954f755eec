#pragma once

#include <npsee/projectile.h>

#include <span>
#include <vector>

namespace npsee::ballistics {

/// Slopes at the knots of a monotone cubic: weighted harmonic means of the neighbouring secants, zero where they change sign,
/// one-sided three-point estimates at the ends.
/// Source: Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300, as usual for "PCHIP".
std::vector<double> monotoneSlopes(std::span<const double> x, std::span<const double> y);

/// A polynomial valid from `from` up to the next segment, in powers of (mach - from).
struct Segment {
  double from = 0.0;
  std::vector<double> c;
};

/// The curve as segments in order; the first begins at 0 and the last is constant. Empty for an empty curve.
std::vector<Segment> segmentsOf(const CoefficientCurve& curve);

/// Coefficients of p(x + shift).
std::vector<double> shifted(std::span<const double> polynomial, double shift);
double polynomialAt(std::span<const double> polynomial, double x);

}  // namespace npsee::ballistics
