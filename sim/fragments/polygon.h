#pragma once

#include <npsee/fragments.h>

#include <cstdint>
#include <vector>

namespace npsee::fragments {

/// Corners of a closed line, as indices of points.
using Loop = std::vector<std::uint32_t>;

/// Triangles that fill a loop, n - 2 for n corners, whatever its shape: each edge of the loop is used once in its direction, each edge
/// inside once in both. A flat loop without crossings is filled without overlaps (ear clipping).
void fillLoop(const std::vector<Vec3>& points, const Loop& loop, std::uint16_t material, std::vector<Facet>& out);

/// Fills loops that lie in one plane, those anticlockwise about `normal` as areas and the others as holes in them.
void fillArea(const std::vector<Vec3>& points, std::vector<Loop> loops, const Vec3& normal, std::uint16_t material, std::vector<Facet>& out);

/// An edge of the boundary of a surface, from corner to corner.
struct Step {
  std::uint32_t from = 0, to = 0;
};
/// Loops without repeated corners that are made of all the steps. Each corner must begin as many steps as it ends.
std::vector<Loop> loopsOf(std::vector<Step> steps);

}  // namespace npsee::fragments
