#pragma once

// Four doubles at a time, written once for every instruction set: GCC and clang split the vectors where the machine has
// narrower ones. Everything here has internal linkage, because the same code is compiled into several kernels for different
// instruction sets and the linker must never pick one kernel's copy for another.

#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#define NPSEE_KERNEL_INLINE static inline __attribute__((always_inline, unused))

namespace npsee::lanes {

constexpr int kLanes = 4;

typedef double Doubles __attribute__((vector_size(32)));
typedef std::int64_t Masks __attribute__((vector_size(32)));  ///< all ones = true, 0 = false
typedef float Floats __attribute__((vector_size(16)));
typedef std::int32_t Ints __attribute__((vector_size(16)));

NPSEE_KERNEL_INLINE Doubles all(double value) { return Doubles{value, value, value, value}; }

NPSEE_KERNEL_INLINE Doubles select(Masks mask, Doubles yes, Doubles no) {
  return (Doubles)((mask & (Masks)yes) | (~mask & (Masks)no));
}
NPSEE_KERNEL_INLINE double select(bool mask, double yes, double no) { return mask ? yes : no; }

NPSEE_KERNEL_INLINE bool any(Masks mask) {
#if defined(__AVX__)
  return _mm256_movemask_pd((__m256d)mask) != 0;
#else
  return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
#endif
}
NPSEE_KERNEL_INLINE bool any(bool mask) { return mask; }

NPSEE_KERNEL_INLINE Doubles squareRoot(Doubles x) {
#if defined(__AVX__)
  return (Doubles)_mm256_sqrt_pd((__m256d)x);
#else
  // Square roots are correctly rounded everywhere, so this has the same bits.
  return Doubles{__builtin_sqrt(x[0]), __builtin_sqrt(x[1]), __builtin_sqrt(x[2]), __builtin_sqrt(x[3])};
#endif
}
NPSEE_KERNEL_INLINE double squareRoot(double x) { return __builtin_sqrt(x); }

NPSEE_KERNEL_INLINE Doubles lesser(Doubles a, Doubles b) { return select(a < b, a, b); }
NPSEE_KERNEL_INLINE Doubles greater(Doubles a, Doubles b) { return select(a > b, a, b); }

NPSEE_KERNEL_INLINE Doubles load(const double* from) {
  Doubles out;
  std::memcpy(&out, from, sizeof out);
  return out;
}
NPSEE_KERNEL_INLINE Floats load(const float* from) {
  Floats out;
  std::memcpy(&out, from, sizeof out);
  return out;
}
NPSEE_KERNEL_INLINE Doubles widen(Floats x) { return __builtin_convertvector(x, Doubles); }
NPSEE_KERNEL_INLINE Floats narrow(Doubles x) { return __builtin_convertvector(x, Floats); }

NPSEE_KERNEL_INLINE void store(double* to, Doubles x) { std::memcpy(to, &x, sizeof x); }
NPSEE_KERNEL_INLINE void store(float* to, Doubles x) {
  const Floats narrowed = narrow(x);
  std::memcpy(to, &narrowed, sizeof narrowed);
}

/// Rows become columns.
NPSEE_KERNEL_INLINE void transpose(Doubles& a, Doubles& b, Doubles& c, Doubles& d) {
  const Doubles low_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6), high_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Doubles low_cd = __builtin_shufflevector(c, d, 0, 4, 2, 6), high_cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(low_ab, low_cd, 0, 1, 4, 5);
  b = __builtin_shufflevector(high_ab, high_cd, 0, 1, 4, 5);
  c = __builtin_shufflevector(low_ab, low_cd, 2, 3, 6, 7);
  d = __builtin_shufflevector(high_ab, high_cd, 2, 3, 6, 7);
}
NPSEE_KERNEL_INLINE void transpose(Floats& a, Floats& b, Floats& c, Floats& d) {
  const Floats low_ab = __builtin_shufflevector(a, b, 0, 4, 1, 5), high_ab = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Floats low_cd = __builtin_shufflevector(c, d, 0, 4, 1, 5), high_cd = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  a = __builtin_shufflevector(low_ab, low_cd, 0, 1, 4, 5);
  b = __builtin_shufflevector(low_ab, low_cd, 2, 3, 6, 7);
  c = __builtin_shufflevector(high_ab, high_cd, 0, 1, 4, 5);
  d = __builtin_shufflevector(high_ab, high_cd, 2, 3, 6, 7);
}

}  // namespace npsee::lanes
