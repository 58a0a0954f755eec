#pragma once

// Part of lanes.h: four doubles in one 256-bit vector (AVX2).

namespace npsee::lanes {

typedef double Doubles __attribute__((vector_size(32)));
typedef double Twin __attribute__((vector_size(16)));
typedef decltype(Doubles{} < Doubles{}) Masks;  ///< 64-bit integers, of the kind that the compiler compares to; all ones = true, 0 = false

NPSEE_KERNEL_INLINE void fill(Doubles& to, double value) { to = Doubles{value, value, value, value}; }
NPSEE_KERNEL_INLINE Doubles select(Masks mask, Doubles yes, Doubles no) { return (Doubles)_mm256_blendv_pd((__m256d)no, (__m256d)yes, (__m256d)mask); }
NPSEE_KERNEL_INLINE bool any(Masks mask) { return _mm256_movemask_pd((__m256d)mask) != 0; }
NPSEE_KERNEL_INLINE Doubles squareRoot(Doubles x) { return (Doubles)_mm256_sqrt_pd((__m256d)x); }
NPSEE_KERNEL_INLINE Masks bitsOf(Doubles x) { return (Masks)x; }
NPSEE_KERNEL_INLINE Doubles fromBits(Masks x) { return (Doubles)x; }

}  // namespace npsee::lanes

#include "sim/core/lanes_pair.h"

namespace npsee::lanes {

NPSEE_KERNEL_INLINE Doubles widen(Floats x) { return (Doubles)_mm256_cvtps_pd((__m128)x); }
NPSEE_KERNEL_INLINE Floats narrow(Doubles x) { return (Floats)_mm256_cvtpd_ps((__m256d)x); }
/// A comparison's result of four floats or whole numbers, for doubles; and back.
NPSEE_KERNEL_INLINE Masks wideMask(Ints mask) { return (Masks)_mm256_cvtepi32_epi64((__m128i)mask); }
NPSEE_KERNEL_INLINE Ints narrowMask(Masks mask) {
  const Ints low = (Ints)_mm256_castsi256_si128((__m256i)mask), high = (Ints)_mm256_extracti128_si256((__m256i)mask, 1);
  return __builtin_shufflevector(low, high, 0, 2, 4, 6);
}

NPSEE_KERNEL_INLINE void transpose(Doubles& a, Doubles& b, Doubles& c, Doubles& d) {
  const Doubles low_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6), high_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Doubles low_cd = __builtin_shufflevector(c, d, 0, 4, 2, 6), high_cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(low_ab, low_cd, 0, 1, 4, 5);
  b = __builtin_shufflevector(high_ab, high_cd, 0, 1, 4, 5);
  c = __builtin_shufflevector(low_ab, low_cd, 2, 3, 6, 7);
  d = __builtin_shufflevector(high_ab, high_cd, 2, 3, 6, 7);
}

NPSEE_KERNEL_INLINE Doubles joined(Twin low, Twin high) { return __builtin_shufflevector(low, high, 0, 1, 2, 3); }

}  // namespace npsee::lanes
