#pragma once

#include "sim/world/terrain_grid.h"

#include <cmath>

namespace npsee::world {

/// Height of a straight line over the ground within one cell: c0 + c1 s + c2 s^2 for s in [0, span], s the line's parameter less the
/// cell's first one, `start`.
struct CellClearance {
  double start, span, c0, c1, c2;
};

/// Walks the cells under the line from + t (to - from), t in [0, 1], in order (2-D DDA, Amanatides & Woo 1987: A Fast Voxel Traversal
/// Algorithm for Ray Tracing), calling `visit` with the clearance in each until it returns false. Beyond the edge, cells reach to infinity
/// and repeat the edge's heights; kInside says that the line has none of them.
template <bool kInside, class Visit>
void walkCells(const Terrain::Grid& grid, const Vec3& from, const Vec3& to, Visit&& visit) {
  const int last_column = grid.columns - 1, last_row = grid.rows - 1;
  const double ax = from.x / grid.cell_x, az = from.z / grid.cell_z;
  const double dx = (to.x - from.x) / grid.cell_x, dz = (to.z - from.z) / grid.cell_z, dy = to.y - from.y;
  // Cells have the index of their west and north line; -1 and the last line begin the ones outside.
  const int lowest = kInside ? 0 : -1, over = kInside ? 1 : 0;
  const auto cellOf = [lowest](double g, int highest) {
    const double clamped = g < lowest ? lowest : (g > highest ? highest : std::floor(g));
    return static_cast<int>(clamped);
  };
  int column = cellOf(ax, last_column - over), row = cellOf(az, last_row - over);
  const int step_x = dx < 0.0 ? -1 : 1, step_z = dz < 0.0 ? -1 : 1;
  // Counting the crossings bounds the walk, whatever rounding does to the parameters.
  int left_x = std::abs(cellOf(ax + dx, last_column - over) - column), left_z = std::abs(cellOf(az + dz, last_row - over) - row);
  const double per_x = left_x > 0 ? 1.0 / dx : 0.0, per_z = left_z > 0 ? 1.0 / dz : 0.0;
  const double none = 2.0;
  const int ahead_x = step_x > 0 ? 1 : 0, ahead_z = step_z > 0 ? 1 : 0;
  double next_x = left_x > 0 ? (column + ahead_x - ax) * per_x : none, next_z = left_z > 0 ? (row + ahead_z - az) * per_z : none;

  double t = 0.0;
  for (;;) {
    const bool by_x = next_x <= next_z;
    double end = by_x ? next_x : next_z;
    end = end > t ? (end < 1.0 ? end : 1.0) : t;

    int west = column, east = column + 1, north = row, south = row + 1;
    if constexpr (!kInside) {
      west = std::clamp(west, 0, last_column);
      east = std::clamp(east, 0, last_column);
      north = std::clamp(north, 0, last_row);
      south = std::clamp(south, 0, last_row);
    }
    const float* north_row = grid.row(north);
    const float* south_row = grid.row(south);
    const double nw = north_row[west], ne = north_row[east], sw = south_row[west], se = south_row[east];
    const double a = ne - nw, b = sw - nw, c = (se - sw) - a;
    const double u = ax + t * dx - column, v = az + t * dz - row;
    const CellClearance cell{t, end - t, (from.y + t * dy) - (nw + u * a + v * (b + u * c)), dy - (dx * (a + v * c) + dz * (b + u * c)), -dx * dz * c};
    if (!visit(cell)) return;
    if (left_x + left_z == 0) return;

    t = end;
    if (by_x) {
      column += step_x;
      next_x = --left_x > 0 ? (column + ahead_x - ax) * per_x : none;
    } else {
      row += step_z;
      next_z = --left_z > 0 ? (row + ahead_z - az) * per_z : none;
    }
  }
}

inline bool insideGrid(const Terrain::Grid& grid, const Vec3& p) { return p.x >= 0.0 && p.x <= grid.size_x && p.z >= 0.0 && p.z <= grid.size_z; }

template <class Visit>
void walkLine(const Terrain::Grid& grid, const Vec3& from, const Vec3& to, Visit&& visit) {
  if (insideGrid(grid, from) && insideGrid(grid, to)) walkCells<true>(grid, from, to, visit);
  else walkCells<false>(grid, from, to, visit);
}

}  // namespace npsee::world
