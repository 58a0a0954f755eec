#pragma once

#include <npsee/fragments.h>

namespace npsee::fragments {

/// Points x with dot(normal, x) >= offset are above.
struct Plane {
  Vec3 normal;           ///< unit length
  double offset = 0.0;   ///< m
};

/// Cuts a closed surface in two closed ones, either of which may be empty. Both share their cut: the same points, the same facets turned
/// round, so that their volumes sum to the whole's up to rounding. Points within `snap_m` of the plane count as on it.
struct Halves {
  Solid below, above;
};
Halves cutBy(const Solid& solid, const Plane& plane, double snap_m);

}  // namespace npsee::fragments
