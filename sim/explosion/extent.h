#pragma once

#include "sim/explosion/compile.h"

namespace npsee::explosion {

/// Box that holds 95 % of the places along each axis that particles take up to their second ground contact, and the
/// burst itself.
Extent extentOf(const std::vector<CompiledLayer>& layers, const Vec3& burst);

}  // namespace npsee::explosion
