#pragma once

// Four doubles at a time, written once for every instruction set: one vector where the machine has 256 bits, a pair of vectors
// elsewhere (the compiler's own splitting goes through memory and is several times slower). Everything here has internal linkage,
// because the same code is compiled into several kernels for different instruction sets and the linker must never pick one
// kernel's copy for another.

#include <cstdint>
#include <cstring>
#include <type_traits>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#define NPSEE_KERNEL_INLINE static inline __attribute__((always_inline, unused))

namespace npsee::lanes {

constexpr int kLanes = 4;

typedef float Floats __attribute__((vector_size(16)));
typedef std::int32_t Ints __attribute__((vector_size(16)));
typedef std::uint8_t Bytes __attribute__((vector_size(4)));

}  // namespace npsee::lanes

// The scalar forms stand first: the pair's templates must see them.
namespace npsee::lanes {

NPSEE_KERNEL_INLINE double select(bool mask, double yes, double no) { return mask ? yes : no; }
NPSEE_KERNEL_INLINE bool any(bool mask) { return mask; }
NPSEE_KERNEL_INLINE double squareRoot(double x) { return __builtin_sqrt(x); }
NPSEE_KERNEL_INLINE void fill(double& to, double value) { to = value; }

}  // namespace npsee::lanes

#if defined(__AVX2__)
#include "sim/core/lanes_wide.h"
#else
#include "sim/core/lanes_narrow.h"
#endif

namespace npsee::lanes {

/// Eight doubles, for long chains of dependent operations: two fours are computed side by side.
using Eight = Pair<Doubles>;
using EightMasks = Pair<Masks>;
constexpr int kEight = 8;

/// `value` in every lane.
template <class T>
NPSEE_KERNEL_INLINE T filled(double value) {
  T out;
  fill(out, value);
  return out;
}
NPSEE_KERNEL_INLINE Doubles all(double value) { return filled<Doubles>(value); }

template <class T>
NPSEE_KERNEL_INLINE T lesser(T a, T b) { return select(a < b, a, b); }
template <class T>
NPSEE_KERNEL_INLINE T greater(T a, T b) { return select(a > b, a, b); }

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
NPSEE_KERNEL_INLINE Ints loadInts(const void* from) {
  Ints out;
  std::memcpy(&out, from, sizeof out);
  return out;
}
/// Puts one number into a lane.
template <class T>
NPSEE_KERNEL_INLINE void setLane(T& x, int lane, double value) {
  std::memcpy(reinterpret_cast<char*>(&x) + sizeof(double) * static_cast<std::size_t>(lane), &value, sizeof value);
}

NPSEE_KERNEL_INLINE Eight loadEight(const double* from) { return {load(from), load(from + kLanes)}; }
NPSEE_KERNEL_INLINE void store(double* to, Doubles x) { std::memcpy(to, &x, sizeof x); }
NPSEE_KERNEL_INLINE void store(float* to, Doubles x) {
  const Floats narrowed = narrow(x);
  std::memcpy(to, &narrowed, sizeof narrowed);
}

/// Four small counts as whole numbers, and back.
NPSEE_KERNEL_INLINE Ints loadCounts(const std::uint8_t* from) {
#if defined(__SSE2__)
  std::int32_t bytes;
  std::memcpy(&bytes, from, sizeof bytes);
  const __m128i zero = _mm_setzero_si128();
  return (Ints)_mm_unpacklo_epi16(_mm_unpacklo_epi8(_mm_cvtsi32_si128(bytes), zero), zero);
#else
  Bytes bytes;
  std::memcpy(&bytes, from, sizeof bytes);
  return __builtin_convertvector(bytes, Ints);
#endif
}
NPSEE_KERNEL_INLINE void storeCounts(std::uint8_t* to, Ints counts) {
#if defined(__SSE2__)
  const __m128i words = _mm_packs_epi32((__m128i)counts, (__m128i)counts);
  const std::int32_t bytes = _mm_cvtsi128_si32(_mm_packus_epi16(words, words));
#else
  const Bytes bytes = __builtin_convertvector(counts, Bytes);
#endif
  std::memcpy(to, &bytes, 4);
}

/// Four floats of each of four rows.
struct Columns {
  Floats a, b, c, d;
};
NPSEE_KERNEL_INLINE Columns transposed(const Floats (&rows)[kLanes]) {
  const Floats low_ab = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5), high_ab = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7);
  const Floats low_cd = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5), high_cd = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
  return {__builtin_shufflevector(low_ab, low_cd, 0, 1, 4, 5), __builtin_shufflevector(low_ab, low_cd, 2, 3, 6, 7), __builtin_shufflevector(high_ab, high_cd, 0, 1, 4, 5),
          __builtin_shufflevector(high_ab, high_cd, 2, 3, 6, 7)};
}

/// First and second numbers of four rows of two.
NPSEE_KERNEL_INLINE Doubles firsts(const Twin (&rows)[kLanes]) { return joined(__builtin_shufflevector(rows[0], rows[1], 0, 2), __builtin_shufflevector(rows[2], rows[3], 0, 2)); }
NPSEE_KERNEL_INLINE Doubles seconds(const Twin (&rows)[kLanes]) { return joined(__builtin_shufflevector(rows[0], rows[1], 1, 3), __builtin_shufflevector(rows[2], rows[3], 1, 3)); }

/// The bits of a double that a float keeps: `and` rounds towards zero (for magnitudes from 1e-38 on).
constexpr std::int64_t kFloatBits = ~((std::int64_t{1} << 29) - 1);

}  // namespace npsee::lanes
