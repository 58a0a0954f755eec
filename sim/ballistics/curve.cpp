#include "sim/ballistics/curve.h"

#include <algorithm>
#include <cmath>

namespace npsee {
namespace ballistics {
namespace {

/// Slope at an end from the first two secants, kept from overshooting.
double endSlope(double h0, double h1, double d0, double d1) {
  const double slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0.0) return 0.0;
  if (d0 * d1 <= 0.0 && std::fabs(slope) > 3.0 * std::fabs(d0)) return 3.0 * d0;
  return slope;
}

Segment cubic(double x0, double x1, double y0, double y1, double m0, double m1) {
  const double h = x1 - x0, d = (y1 - y0) / h;
  return {x0, {y0, m0, (3.0 * d - 2.0 * m0 - m1) / h, (m0 + m1 - 2.0 * d) / (h * h)}};
}

std::vector<Segment> tabulatedSegments(const CoefficientCurve& curve) {
  const std::size_t n = std::min(curve.mach.size(), curve.value.size());
  std::vector<Segment> out{{0.0, {curve.value.front()}}};
  const bool smooth = curve.interpolation == Interpolation::monotone && n >= 3;
  const std::vector<double> slopes = smooth ? monotoneSlopes({curve.mach.data(), n}, {curve.value.data(), n}) : std::vector<double>();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double x0 = curve.mach[i], x1 = curve.mach[i + 1], y0 = curve.value[i], y1 = curve.value[i + 1];
    if (smooth) out.push_back(cubic(x0, x1, y0, y1, slopes[i], slopes[i + 1]));
    else out.push_back({x0, {y0, (y1 - y0) / (x1 - x0)}});
  }
  out.push_back({curve.mach[n - 1], {curve.value[n - 1]}});
  return out;
}

std::vector<Segment> polynomialSegments(const CoefficientCurve& curve) {
  std::vector<Segment> out;
  double from = 0.0;
  for (const PolynomialPiece& piece : curve.pieces) {
    out.push_back({from, shifted(piece.a, from)});
    from = piece.mach_to;
  }
  out.push_back({from, {polynomialAt(curve.pieces.back().a, from)}});
  return out;
}

}  // namespace

std::vector<double> monotoneSlopes(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  std::vector<double> h(n - 1), d(n - 1), m(n);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = x[i + 1] - x[i];
    d[i] = (y[i + 1] - y[i]) / h[i];
  }
  m.front() = endSlope(h[0], h[1], d[0], d[1]);
  m.back() = endSlope(h[n - 2], h[n - 3], d[n - 2], d[n - 3]);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (d[i - 1] * d[i] <= 0.0) continue;
    const double w1 = 2.0 * h[i] + h[i - 1], w2 = h[i] + 2.0 * h[i - 1];
    m[i] = (w1 + w2) / (w1 / d[i - 1] + w2 / d[i]);
  }
  return m;
}

std::vector<double> shifted(std::span<const double> polynomial, double shift) {
  std::vector<double> c(polynomial.begin(), polynomial.end());
  for (std::size_t i = 0; i + 1 < c.size(); ++i)
    for (std::size_t k = c.size() - 1; k-- > i;) c[k] += shift * c[k + 1];
  return c;
}

double polynomialAt(std::span<const double> polynomial, double x) {
  double sum = 0.0;
  for (std::size_t k = polynomial.size(); k-- > 0;) sum = sum * x + polynomial[k];
  return sum;
}

std::vector<Segment> segmentsOf(const CoefficientCurve& curve) {
  if (!curve.pieces.empty()) return polynomialSegments(curve);
  if (!curve.mach.empty() && !curve.value.empty()) return tabulatedSegments(curve);
  return {};
}

}  // namespace ballistics

double CoefficientCurve::at(double mach_number) const {
  const std::vector<ballistics::Segment> segments = ballistics::segmentsOf(*this);
  if (segments.empty()) return 0.0;
  std::size_t i = 0;
  while (i + 1 < segments.size() && mach_number >= segments[i + 1].from) ++i;
  return ballistics::polynomialAt(segments[i].c, mach_number - segments[i].from);
}

CoefficientCurve CoefficientCurve::constant(double value) {
  CoefficientCurve curve;
  curve.mach = {0.0};
  curve.value = {value};
  return curve;
}

}  // namespace npsee
