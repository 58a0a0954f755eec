#pragma once

#include <npsee/terrain.h>
#include <npsee/vec3.h>

#include <cstdint>
#include <span>
#include <vector>

namespace npsee::render {

/// A terrain's samples as the mesh sees them.
struct HeightGrid {
  int columns = 0, rows = 0;
  double cell_x_m = 0.0, cell_z_m = 0.0;
  double sea_m = 0.0;
  std::span<const float> heights;  ///< row by row from the north

  double at(int column, int row) const { return static_cast<double>(heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)]); }
  /// Bilinear height at a place in cells; outside, the edge goes on level.
  double height(double column, double row) const;
};
HeightGrid gridOf(const Terrain& terrain);

/// Quads along each side of a tile.
inline constexpr int kTileQuads = 16;

/// A rectangle of terrain drawn as kTileQuads x kTileQuads quads. Places and steps are in cells of the terrain and powers of
/// two, so that neighbours agree on their common corners to the bit.
struct TerrainTile {
  double column = 0.0, row = 0.0;    ///< north-west corner, cells
  double step_x = 1.0, step_z = 1.0; ///< cells per quad
  double error_m = 0.0;              ///< bound of the height between these triangles and the simulator's surface
  double low_m = 0.0, high_m = 0.0;  ///< heights of the ground within, under the sea too
  double distance_m = 0.0;           ///< from the eye to the tile's box
};

/// What a tile must be seen through to be drawn: half-spaces dot(normal, p - eye) + offset >= 0.
struct TerrainFrustum {
  Vec3 eye;
  Vec3 normals[5];
  double offsets[5] = {};
  int planes = 0;
  double tolerance = 1e-3;           ///< height error allowed per metre of distance
};

/// Chooses which parts of a terrain are drawn how finely. The error of every level against the surface that the simulator uses is
/// bounded beforehand, so what stands on the drawn ground neither floats nor sinks by more than the tolerance, and a narrow
/// ridge is never lost. Near the eye, tiles finer than the terrain's cells follow the bilinear surface within a cell.
class TerrainTree {
 public:
  static TerrainTree make(const HeightGrid& grid);

  /// Tiles in view, nearest first. At most about `limit` of them: where that does not do, the tolerance grows.
  void select(const TerrainFrustum& frustum, std::size_t limit, std::vector<TerrainTile>& out) const;
  double lowest() const { return nodes_.empty() ? 0.0 : static_cast<double>(nodes_[0].low); }
  double highest() const { return nodes_.empty() ? 0.0 : static_cast<double>(nodes_[0].high); }

 private:
  struct Node {
    float error = 0.0f, low = 0.0f, high = 0.0f;
    std::int32_t child[2] = {-1, -1};  // west and east, or north and south, half
  };
  struct Area {
    int column, row, across, down;     // quads are 2^across by 2^down cells
  };
  class Builder;
  bool choose(const TerrainFrustum& frustum, std::int32_t node, const Area& area, std::size_t limit, std::vector<TerrainTile>& out) const;
  bool chooseWithin(const TerrainFrustum& frustum, const TerrainTile& tile, int depth, std::size_t limit, std::vector<TerrainTile>& out) const;
  bool halvesWide(const Area& area) const;

  std::vector<Node> nodes_;
  Area root_{};
  double cell_x_m_ = 1.0, cell_z_m_ = 1.0, sea_m_ = 0.0;
  int cells_x_ = 0, cells_z_ = 0;
};

/// One corner of a tile: place relative to the eye, m, and what the shader needs besides.
struct TerrainVertex {
  float x, z;      ///< relative to the eye, m
  float ground;    ///< height of the ground, m; at most slightly below the sea's level
  float skirt;     ///< how far below its place the corner is drawn, m: tiles hang aprons over the cracks between levels
};

/// Appends the tile's corners, kTileVertices of them, and they are joined as tileIndices() says.
void addTileVertices(const HeightGrid& grid, const TerrainTile& tile, const Vec3& eye, double tolerance, std::vector<TerrainVertex>& out);
inline constexpr int kTileVertices = (kTileQuads + 1) * (kTileQuads + 1) + 4 * (kTileQuads + 1);
/// Triangles of one tile, counter-clockwise from above.
const std::vector<std::uint16_t>& tileIndices();

/// The level surroundings of the world, as the simulator continues it: `reach_m` out from every edge, in strips as wide as the
/// tolerance allows. Triangles, three vertices each.
void addSurroundings(const HeightGrid& grid, const Vec3& eye, double reach_m, double tolerance, std::vector<TerrainVertex>& out);

}  // namespace npsee::render
