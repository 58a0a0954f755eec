#pragma once

#include "app/render/terrain_mesh.h"

#include <cstdint>
#include <vector>

namespace npsee::render {

/// The land in daylight as a texture over the whole of it: what grows there and how the sun falls on it. Relief stays visible at any
/// distance, whatever the mesh there, and a pixel costs one look-up. Rows from the north, 4 bytes a texel: the square root of the
/// linear colour, and how rough the ground looks from near.
struct SurfaceMap {
  int width = 0, height = 0;
  std::vector<std::uint8_t> texels;
};

/// Same bytes for every number of threads.
SurfaceMap surfaceMapOf(const HeightGrid& grid, int threads);

/// Tiling noise, 0..255, `side` x `side`: its octaves start at `cells` lattice points a side.
std::vector<std::uint8_t> tilingNoise(int side, int cells, int octaves);

}  // namespace npsee::render
