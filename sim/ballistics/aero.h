#pragma once

#include <npsee/projectile.h>

#include <cstdint>
#include <vector>

namespace npsee::ballistics {

/// All coefficient curves on one list of Mach intervals, as cubics, ready for the kernels: row i holds for each coefficient
/// the four numbers of c0 + c1 s + c2 s^2 + c3 s^3 with s = mach - knots[i].
struct CompiledAero {
  CompiledAero() = default;
  CompiledAero(CompiledAero&&) = default;
  CompiledAero& operator=(CompiledAero&&) = default;
  CompiledAero(const CompiledAero&) = delete;
  CompiledAero& operator=(const CompiledAero&) = delete;

  std::vector<double> knots;            ///< first 0, last infinity
  std::vector<std::int32_t> buckets;    ///< where the search for an interval begins, by mach * bucket_scale
  double bucket_scale = 1.0;
  std::vector<double> rows;             ///< [interval][coefficient][power]
  bool has_yaw = false;                 ///< overturning moment known
  bool cubic_yaw = false;               ///< cubic lift or overturning moment present
  // The same storage as plain pointers: kernels of other instruction sets must not call inline functions of the library.
  const double* knot = nullptr;
  const std::int32_t* bucket = nullptr;
  const double* row = nullptr;
  std::int64_t last_bucket = 0;
  double mach_top = 0.0;                ///< above it a varying table is held constant; infinity where all are constant
};

/// Curves of degree above three are split until their cubics are within 1e-9 of them (relative to their greatest value).
CompiledAero compileAero(const AeroTable& table);

}  // namespace npsee::ballistics
