#pragma once

#include "sim/world/terrain_grid.h"

#include <cmath>
#include <cstdlib>

namespace npsee::world {

/// Height of a straight line over the ground within one cell: c0 + c1 s + c2 s^2 for s in [0, span], s the line's parameter less the
/// cell's first one, `start`.
struct CellClearance {
  double start, span, c0, c1, c2;
};

/// A line over squares of size 1: (ax, az) + t (dx, dz).
struct LineOverSquares {
  double ax, az, dx, dz;
};
/// Squares by the index of their west and north side, ends included.
struct SquareRange {
  int west, north, east, south;
};

/// Walks the squares of a range under the line for t in [from, to], in order, calling `visit(column, row, first t, last t)` until it returns
/// false; then the result is false. 2-D DDA: Amanatides & Woo 1987, A Fast Voxel Traversal Algorithm for Ray Tracing.
template <class Visit>
bool walkSquares(const LineOverSquares& line, double from, double to, const SquareRange& range, const Visit& visit) {
  const auto squareOf = [](double g, int low, int high) { return static_cast<int>(g < low ? low : (g > high ? high : std::floor(g))); };
  int column = squareOf(line.ax + from * line.dx, range.west, range.east), row = squareOf(line.az + from * line.dz, range.north, range.south);
  const int step_x = line.dx < 0.0 ? -1 : 1, step_z = line.dz < 0.0 ? -1 : 1;
  // Counting the crossings bounds the walk, whatever rounding does to the parameters.
  int left_x = std::max(0, step_x * (squareOf(line.ax + to * line.dx, range.west, range.east) - column));
  int left_z = std::max(0, step_z * (squareOf(line.az + to * line.dz, range.north, range.south) - row));
  const double per_x = left_x > 0 ? 1.0 / line.dx : 0.0, per_z = left_z > 0 ? 1.0 / line.dz : 0.0;
  const double off_x = ((step_x > 0 ? 1 : 0) - line.ax) * per_x, off_z = ((step_z > 0 ? 1 : 0) - line.az) * per_z;
  for (double t = from;;) {
    const double next_x = column * per_x + off_x, next_z = row * per_z + off_z;
    const bool by_x = (left_z == 0) | ((left_x != 0) & (next_x <= next_z));
    double end = by_x ? next_x : next_z;
    end = end > t ? end : t;
    end = ((end < to) & (left_x + left_z > 0)) ? end : to;
    if (!visit(column, row, t, end)) return false;
    if (left_x + left_z == 0) return true;
    t = end;
    // Which side comes next is as good as random: chosen without a jump.
    const int along_x = by_x ? 1 : 0, along_z = 1 - along_x;
    column += along_x * step_x;
    row += along_z * step_z;
    left_x -= along_x;
    left_z -= along_z;
  }
}

/// A line from one point (t = 0) to another (t = 1) over the cells of a grid.
struct LineOverGrid {
  const Terrain::Grid& grid;
  LineOverSquares cells;
  double y, dy;

  LineOverGrid(const Terrain::Grid& g, const Vec3& from, const Vec3& to)
      : grid(g), cells{from.x / g.cell_x, from.z / g.cell_z, (to.x - from.x) / g.cell_x, (to.z - from.z) / g.cell_z}, y(from.y), dy(to.y - from.y) {}

  CellClearance clearance(int column, int row, double start, double end, double nw, double ne, double sw, double se) const {
    const double a = ne - nw, b = sw - nw, c = (se - sw) - a;
    const double u = (cells.ax - column) + start * cells.dx, v = (cells.az - row) + start * cells.dz;
    return {start, end - start, (y + start * dy) - (nw + u * a + v * (b + u * c)), dy - (cells.dx * (a + v * c) + cells.dz * (b + u * c)), -cells.dx * cells.dz * c};
  }
};

/// Calls `visit` with the clearance in each cell under the line, in order, until it returns false. Whole blocks of cells over whose highest ground
/// the line keeps more than `enough()` are left out. Beyond the edge, cells reach to infinity and repeat the edge's heights.
template <class Enough, class Visit>
void walkLine(const Terrain::Grid& grid, const Vec3& from, const Vec3& to, const Enough& enough, const Visit& visit) {
  const LineOverGrid line(grid, from, to);
  const auto inside = [&](const Vec3& p) { return p.x >= 0.0 && p.x <= grid.size_x && p.z >= 0.0 && p.z <= grid.size_z; };
  if (!inside(from) || !inside(to)) {
    walkSquares(line.cells, 0.0, 1.0, {-1, -1, grid.columns - 1, grid.rows - 1}, [&](int column, int row, double start, double end) {
      const float* north = grid.row(std::clamp(row, 0, grid.rows - 1));
      const float* south = grid.row(std::clamp(row + 1, 0, grid.rows - 1));
      const int west = std::clamp(column, 0, grid.columns - 1), east = std::clamp(column + 1, 0, grid.columns - 1);
      return visit(line.clearance(column, row, start, end, north[west], north[east], south[west], south[east]));
    });
    return;
  }
  constexpr int kBlock = Terrain::Grid::kBlock;
  constexpr double kScale = 1.0 / kBlock;
  const LineOverSquares blocks{kScale * line.cells.ax, kScale * line.cells.az, kScale * line.cells.dx, kScale * line.cells.dz};
  walkSquares(blocks, 0.0, 1.0, {0, 0, grid.block_columns - 1, grid.block_rows - 1}, [&](int block_column, int block_row, double first, double last) {
    const double lowest = line.y + (line.dy > 0.0 ? first : last) * line.dy;
    if (lowest - grid.highestInBlock(block_column, block_row) >= enough()) return true;
    const SquareRange range{block_column * kBlock, block_row * kBlock, std::min(block_column * kBlock + kBlock, grid.columns - 1) - 1, std::min(block_row * kBlock + kBlock, grid.rows - 1) - 1};
    return walkSquares(line.cells, first, last, range, [&](int column, int row, double start, double end) {
      const float* north = grid.row(row) + column;
      const float* south = north + grid.columns;
      return visit(line.clearance(column, row, start, end, north[0], north[1], south[0], south[1]));
    });
  });
}

}  // namespace npsee::world
