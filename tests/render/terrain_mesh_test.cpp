#include "app/render/surface_map.h"
#include "app/render/terrain_mesh.h"
#include "tests/support/missions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace npsee::render {
namespace {

Terrain hills() {
  TerrainSource source;
  source.kind = TerrainKind::hills;
  source.seed = 7;
  return test::terrainOf(source, 20000.0);
}

/// Everything around an eye.
TerrainFrustum aroundEye(const Vec3& eye, double tolerance) {
  TerrainFrustum frustum;
  frustum.eye = eye;
  frustum.tolerance = tolerance;
  return frustum;
}

/// Height of a tile's triangles at a place within it.
double drawnHeight(const HeightGrid& grid, const TerrainTile& tile, double column, double row) {
  const double i = std::min(std::floor((column - tile.column) / tile.step_x), kTileQuads - 1.0), j = std::min(std::floor((row - tile.row) / tile.step_z), kTileQuads - 1.0);
  const double c0 = tile.column + i * tile.step_x, r0 = tile.row + j * tile.step_z;
  const double u = (column - c0) / tile.step_x, v = (row - r0) / tile.step_z;
  const double nw = grid.height(c0, r0), ne = grid.height(c0 + tile.step_x, r0), sw = grid.height(c0, r0 + tile.step_z), se = grid.height(c0 + tile.step_x, r0 + tile.step_z);
  // The diagonal runs from the north-west to the south-east corner.
  return u > v ? nw + u * (ne - nw) + v * (se - ne) : nw + v * (sw - nw) + u * (se - sw);
}

TEST(TerrainTree, TheDrawnGroundIsWithinTheToleranceOfTheSimulators) {
  const Terrain terrain = hills();
  const HeightGrid grid = gridOf(terrain);
  const TerrainTree tree = TerrainTree::make(grid);
  const Vec3 eye{9000.0, terrain.surface(9000.0, 11000.0) + 3.0, 11000.0};
  std::vector<TerrainTile> tiles;
  const TerrainFrustum frustum = aroundEye(eye, 2e-3);
  tree.select(frustum, 100000, tiles);
  int compared = 0;
  for (const TerrainTile& tile : tiles)
    for (int k = 0; k < 40; ++k) {
      const double column = std::min(tile.column + kTileQuads * tile.step_x * std::fmod(0.618034 * k, 1.0), grid.columns - 1.001);
      const double row = std::min(tile.row + kTileQuads * tile.step_z * std::fmod(0.754878 * k, 1.0), grid.rows - 1.001);
      const double truth = grid.height(column, row);
      if (truth < grid.sea_m) continue;
      const double distance = std::hypot(column * grid.cell_x_m - eye.x, row * grid.cell_z_m - eye.z);
      EXPECT_LE(std::abs(drawnHeight(grid, tile, column, row) - truth), 1.5 * frustum.tolerance * distance + 0.02) << column << ' ' << row;
      ++compared;
    }
  EXPECT_GT(compared, 1000);
}

TEST(TerrainTree, TilesCoverEveryPlaceExactlyOnce) {
  const Terrain terrain = hills();
  const HeightGrid grid = gridOf(terrain);
  const TerrainTree tree = TerrainTree::make(grid);
  std::vector<TerrainTile> tiles;
  tree.select(aroundEye({3000.0, 400.0, 15000.0}, 1e-3), 100000, tiles);
  for (int k = 0; k < 500; ++k) {
    const double column = (grid.columns - 1) * std::fmod(0.618034 * k + 0.001, 1.0), row = (grid.rows - 1) * std::fmod(0.754878 * k + 0.001, 1.0);
    int covering = 0;
    for (const TerrainTile& tile : tiles)
      covering += column >= tile.column && column < tile.column + kTileQuads * tile.step_x && row >= tile.row && row < tile.row + kTileQuads * tile.step_z;
    EXPECT_EQ(covering, 1) << column << ' ' << row;
  }
}

TEST(TerrainTree, ANarrowRidgeIsNotLostAtADistance) {
  TerrainSource source;
  source.kind = TerrainKind::function;
  source.expression = "ridge";
  source.params = {{"crest_x", 5000.0}, {"crest_height", 40.0}, {"foot_before", 10.0}, {"foot_after", 10.0}};
  const Terrain terrain = test::terrainOf(source, 10000.0, -10.0);
  const TerrainTree tree = TerrainTree::make(gridOf(terrain));
  std::vector<TerrainTile> tiles;
  tree.select(aroundEye({500.0, 3.0, 5000.0}, 1e-3), 100000, tiles);
  double highest = 0.0;
  for (const TerrainTile& tile : tiles)
    for (int i = 0; i <= kTileQuads; ++i) highest = std::max(highest, gridOf(terrain).height(tile.column + i * tile.step_x, tile.row));
  EXPECT_GT(highest, 35.0);
}

TEST(TerrainTree, TheNumberOfTilesStaysWithinTheLimit) {
  const Terrain terrain = hills();
  const TerrainTree tree = TerrainTree::make(gridOf(terrain));
  std::vector<TerrainTile> tiles;
  tree.select(aroundEye({9000.0, 2.0, 11000.0}, 1e-7), 300, tiles);
  EXPECT_GT(tiles.size(), 50u);
  EXPECT_LE(tiles.size(), 300u);
}

TEST(SurfaceMap, TheSameTerrainGivesTheSameBytesOnAnyNumberOfThreads) {
  const Terrain kept = hills();
  EXPECT_EQ(surfaceMapOf(gridOf(kept), 1).texels, surfaceMapOf(gridOf(kept), 5).texels);
}

}  // namespace
}  // namespace npsee::render
