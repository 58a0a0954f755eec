#pragma once

#include "sim/explosion/compile.h"

namespace npsee::explosion {

/// Box that holds 93 % of what is drawn along each axis, and the burst itself: particles count up to their second ground contact with their
/// area times their opacity, so that a cloud matters more than splinters that fly far, and what is invisible not at all.
Extent extentOf(const std::vector<CompiledLayer>& layers, const Vec3& burst, double ground_y);

}  // namespace npsee::explosion
