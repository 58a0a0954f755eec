#pragma once

#include <npsee/explosion.h>

#include <cstddef>
#include <span>
#include <vector>

namespace npsee::render {

/// What smoke lets through of the sun's light to the ground, as a map over the plane of the ground.
///
/// The map's axes run along the throw of the shadows (u) and across it (v), so that the ellipse which a ball throws has its axes there. The
/// depths of puffs add up, t(u, v) = sum of their t0 weighted by 1 - (d / R)^2 along each axis, so that shadows of neighbours merge as the
/// smoke itself does. R = 0.85 r plus the sun's penumbra of 0.005 per metre of height, and a puff's whole is the same however wide it gets.
struct SmokeShadowMap {
  double origin_u = 0.0, origin_v = 0.0;  ///< of the lower corner, world m along the axes
  double cell_m = 1.0;
  int columns = 0, rows = 0;              ///< along u and v; none where there is no shadow
  std::vector<float> dark;                ///< share of the ground's light that is taken, row after row

  bool empty() const { return columns == 0; }
};

/// Ground plane: height at the origin and rise per metre.
struct ShadowPlane {
  double height_m = 0.0, slope_x = 0.0, slope_z = 0.0;
};

/// Fills `map` from the smoke of a frame, using its memory again. `towards_sun` is a unit vector that points up.
void mapSmokeShadow(const Frame& frame, std::span<const LayerSpan> layers, const ShadowPlane& ground, const Vec3& towards_sun, SmokeShadowMap& map);

}  // namespace npsee::render
