#pragma once

// Part of lanes.h: four doubles in two 128-bit vectors (SSE2, NEON, or whatever the compiler makes of them).

namespace npsee::lanes {

typedef double Twin __attribute__((vector_size(16)));
typedef decltype(Twin{} < Twin{}) TwinMask;  ///< 64-bit integers, of the kind that the compiler compares to; all ones = true, 0 = false

NPSEE_KERNEL_INLINE void fill(Twin& to, double value) { to = Twin{value, value}; }
NPSEE_KERNEL_INLINE Twin select(TwinMask mask, Twin yes, Twin no) { return (Twin)((mask & (TwinMask)yes) | (~mask & (TwinMask)no)); }
NPSEE_KERNEL_INLINE TwinMask bitsOf(Twin x) { return (TwinMask)x; }
NPSEE_KERNEL_INLINE Twin fromBits(TwinMask x) { return (Twin)x; }

NPSEE_KERNEL_INLINE bool any(TwinMask mask) {
#if defined(__SSE2__)
  return _mm_movemask_epi8((__m128i)mask) != 0;
#else
  return (mask[0] | mask[1]) != 0;
#endif
}

NPSEE_KERNEL_INLINE Twin squareRoot(Twin x) {
#if defined(__SSE2__)
  return (Twin)_mm_sqrt_pd((__m128d)x);
#else
  // Square roots are correctly rounded everywhere, so this has the same bits.
  return Twin{__builtin_sqrt(x[0]), __builtin_sqrt(x[1])};
#endif
}

}  // namespace npsee::lanes

#include "sim/core/lanes_pair.h"

namespace npsee::lanes {

using Doubles = Pair<Twin>;
using Masks = Pair<TwinMask>;

NPSEE_KERNEL_INLINE Doubles widen(Floats x) {
#if defined(__SSE2__)
  return {(Twin)_mm_cvtps_pd((__m128)x), (Twin)_mm_cvtps_pd(_mm_movehl_ps((__m128)x, (__m128)x))};
#else
  return {Twin{x[0], x[1]}, Twin{x[2], x[3]}};
#endif
}

NPSEE_KERNEL_INLINE Floats narrow(const Doubles& x) {
#if defined(__SSE2__)
  return (Floats)_mm_movelh_ps(_mm_cvtpd_ps((__m128d)x.low), _mm_cvtpd_ps((__m128d)x.high));
#else
  return Floats{static_cast<float>(x.low[0]), static_cast<float>(x.low[1]), static_cast<float>(x.high[0]), static_cast<float>(x.high[1])};
#endif
}

/// A comparison's result of four floats or whole numbers, for doubles; and back.
NPSEE_KERNEL_INLINE Masks wideMask(Ints mask) {
  return {(TwinMask)__builtin_shufflevector(mask, mask, 0, 0, 1, 1), (TwinMask)__builtin_shufflevector(mask, mask, 2, 2, 3, 3)};
}
NPSEE_KERNEL_INLINE Ints narrowMask(const Masks& mask) { return __builtin_shufflevector((Ints)mask.low, (Ints)mask.high, 0, 2, 4, 6); }

NPSEE_KERNEL_INLINE void transpose(Doubles& a, Doubles& b, Doubles& c, Doubles& d) {
  const Doubles ta{__builtin_shufflevector(a.low, b.low, 0, 2), __builtin_shufflevector(c.low, d.low, 0, 2)};
  const Doubles tb{__builtin_shufflevector(a.low, b.low, 1, 3), __builtin_shufflevector(c.low, d.low, 1, 3)};
  const Doubles tc{__builtin_shufflevector(a.high, b.high, 0, 2), __builtin_shufflevector(c.high, d.high, 0, 2)};
  const Doubles td{__builtin_shufflevector(a.high, b.high, 1, 3), __builtin_shufflevector(c.high, d.high, 1, 3)};
  a = ta;
  b = tb;
  c = tc;
  d = td;
}

NPSEE_KERNEL_INLINE Doubles joined(Twin low, Twin high) { return {low, high}; }

}  // namespace npsee::lanes
