#pragma once

// exp, log, sine and cosine of our own. The C library picks variants with fused multiply-add by the CPU it runs on, so its
// last bits differ between machines; these use additions, multiplications, divisions and bit patterns only and have equal bits
// everywhere, one number or four at a time.

#include "sim/core/lanes.h"

#include <bit>
#include <cstdint>

namespace npsee {

namespace elementary_detail {

// 1.5 * 2^52: adding it rounds a double of moderate size to the nearest whole number, left in the low bits.
constexpr double kRounder = 6755399441055744.0;

NPSEE_KERNEL_INLINE double fromBits(std::int64_t bits) { return std::bit_cast<double>(bits); }
NPSEE_KERNEL_INLINE std::int64_t bitsOf(double x) { return std::bit_cast<std::int64_t>(x); }
using lanes::bitsOf;
using lanes::fromBits;

/// True where bit 0 is set, made without a comparison of whole numbers, which baseline x86-64 lacks.
NPSEE_KERNEL_INLINE bool isOdd(std::int64_t bits) { return (bits & 1) != 0; }
template <class Bits>
  requires(!std::is_integral_v<Bits>)
NPSEE_KERNEL_INLINE Bits isOdd(Bits bits) { return -(bits & 1); }

}  // namespace elementary_detail

/// e^x for x in [-700, 700] (values outside are clamped to it). Relative error below 4e-16.
/// T is double, lanes::Doubles or lanes::Eight.
template <class T>
NPSEE_KERNEL_INLINE T exponential(T x) {
  using namespace elementary_detail;
  const T low = lanes::filled<T>(-700.0), high = lanes::filled<T>(700.0);
  x = lanes::select(x < low, low, x);
  x = lanes::select(x > high, high, x);
  // x = n ln 2 + r with |r| <= 0.35; ln 2 in two parts, the first short enough that n times it is exact.
  const T shifted = x * 1.4426950408889634 + kRounder;
  const T n = shifted - kRounder;
  const T r = (x - n * 0.693147180369123816490) - n * 1.90821492927058770002e-10;
  // Taylor to r^13, grouped by squares to shorten the chain of dependent operations.
  const T r2 = r * r, r4 = r2 * r2;
  const T p0 = (1.0 + r) + r2 * (0.5 + r * (1.0 / 6));
  const T p1 = (1.0 / 24 + r * (1.0 / 120)) + r2 * (1.0 / 720 + r * (1.0 / 5040));
  const T p2 = (1.0 / 40320 + r * (1.0 / 362880)) + r2 * (1.0 / 3628800 + r * (1.0 / 39916800));
  const T p3 = 1.0 / 479001600 + r * (1.0 / 6227020800);
  const T p = p0 + r4 * (p1 + r4 * (p2 + r4 * p3));
  const auto exponent = (bitsOf(shifted) + 1023) << 52;
  return p * fromBits(exponent);
}

/// Natural logarithm of a positive normal number. Relative error below 4e-16 (absolute near 1).
NPSEE_KERNEL_INLINE double logarithm(double x) {
  using namespace elementary_detail;
  const std::int64_t bits = bitsOf(x);
  std::int64_t exponent = ((bits >> 52) & 0x7ff) - 1023;
  double m = fromBits((bits & 0x000fffffffffffffll) | 0x3ff0000000000000ll);
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++exponent;
  }
  // ln m = 2 artanh(s), |s| <= 0.172.
  const double s = (m - 1.0) / (m + 1.0), s2 = s * s;
  double series = 0.0;
  for (int k = 23; k >= 3; k -= 2) series = (series + 1.0 / k) * s2;
  const auto n = static_cast<double>(exponent);
  return n * 0.693147180369123816490 + (2.0 * s + (2.0 * s * series + n * 1.90821492927058770002e-10));
}

/// Sine and cosine of x, |x| up to 1e5. Absolute error below 3e-16 for |x| < 100.
/// T is double, lanes::Doubles or lanes::Eight.
template <class T>
NPSEE_KERNEL_INLINE void sineCosine(T x, T& sine, T& cosine) {
  using namespace elementary_detail;
  // x = n pi/2 + r, |r| <= pi/4; pi/2 in three parts (Cody and Waite).
  const T shifted = x * 0.63661977236758134308 + kRounder;
  const T n = shifted - kRounder;
  const T r = ((x - n * 1.57079632673412561417) - n * 6.07710050630396597660e-11) - n * 2.02226624879595063154e-21;
  const T r2 = r * r;
  // Taylor series to r^15 and r^16, grouped by squares.
  const T r4 = r2 * r2, r8 = r4 * r4;
  const T sine_part = ((-1.0 / 6 + r2 * (1.0 / 120)) + r4 * (-1.0 / 5040 + r2 * (1.0 / 362880))) + r8 * ((-1.0 / 39916800 + r2 * (1.0 / 6227020800)) + r4 * (-1.0 / 1307674368000));
  const T cosine_part = ((-0.5 + r2 * (1.0 / 24)) + r4 * (-1.0 / 720 + r2 * (1.0 / 40320))) + r8 * ((-1.0 / 3628800 + r2 * (1.0 / 479001600)) + r4 * (-1.0 / 87178291200 + r2 * (1.0 / 20922789888000)));
  const T s = r + r * r2 * sine_part;
  const T c = 1.0 + r2 * cosine_part;
  const auto quadrant = bitsOf(shifted);
  const auto swapped = isOdd(quadrant);
  const auto sine_sign = (quadrant & 2) << 62, cosine_sign = ((quadrant + 1) & 2) << 62;
  sine = fromBits(bitsOf(lanes::select(swapped, c, s)) ^ sine_sign);
  cosine = fromBits(bitsOf(lanes::select(swapped, s, c)) ^ cosine_sign);
}

}  // namespace npsee
