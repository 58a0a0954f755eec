#include "sim/world/cell_walk.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace npsee {
namespace {

/// A grazing of less than this is no obstacle, m: points put on the ground must not be blocked by rounding.
constexpr double kGrazing_m = 1e-6;
/// Farther is outside every world; keeps products finite.
constexpr double kFar_m = 1e9;

/// Whether the line comes lowest within the cell and not at its ends.
bool hasVertex(const world::CellClearance& cell) { return (cell.c2 > 0.0) & (cell.c1 < 0.0) & (cell.c1 + 2.0 * cell.c2 * cell.span > 0.0); }

bool usable(const Vec3& p) { return std::fabs(p.x) <= kFar_m && std::fabs(p.y) <= kFar_m && std::fabs(p.z) <= kFar_m; }

/// Smallest root in [0, span] of c0 + c1 s + c2 s^2 with c0 >= 0, or a negative number.
double firstRoot(double c0, double c1, double c2, double span) {
  const double under = c1 * c1 - 4.0 * c2 * c0;
  if (under < 0.0) return -1.0;
  const double root = std::sqrt(under);
  // Of the root's two forms the one that does not cancel.
  double s = -1.0;
  if (c1 <= 0.0) s = root - c1 > 0.0 ? 2.0 * c0 / (root - c1) : -1.0;
  else if (c2 < 0.0) s = (-c1 - root) / (2.0 * c2);
  return s <= span ? s : -1.0;
}

}  // namespace

Sight Terrain::sight(const Vec3& eye, const Vec3& target) const {
  if (!usable(eye) || !usable(target)) return {};
  // Always walked the same way, so that both see the same.
  const bool turned = std::tie(target.x, target.z, target.y) < std::tie(eye.x, eye.z, eye.y);
  const Vec3& from = turned ? target : eye;
  const Vec3& to = turned ? eye : target;
  double least = from.y - height(from.x, from.z), where = 0.0;
  const auto consider = [&](double clearance, double t) {
    if (clearance < least) {
      least = clearance;
      where = t;
    }
  };
  consider(to.y - height(to.x, to.z), 1.0);
  world::walkLine(*grid_, from, to, [&] { return least; }, [&](const world::CellClearance& cell) {
    consider(cell.c0, cell.start);
    consider(cell.c0 + cell.span * (cell.c1 + cell.span * cell.c2), cell.start + cell.span);
    if (hasVertex(cell)) {
      const double s = -0.5 * cell.c1 / cell.c2;
      consider(cell.c0 + 0.5 * s * cell.c1, cell.start + s);
    }
    return true;
  });
  const double dx = to.x - from.x, dz = to.z - from.z;
  return {least >= -kGrazing_m, least, (turned ? 1.0 - where : where) * std::sqrt(dx * dx + dz * dz)};
}

bool Terrain::sees(const Vec3& eye, const Vec3& target) const {
  if (!usable(eye) || !usable(target)) return false;
  const bool turned = std::tie(target.x, target.z, target.y) < std::tie(eye.x, eye.z, eye.y);
  const Vec3& from = turned ? target : eye;
  const Vec3& to = turned ? eye : target;
  bool clear = from.y - height(from.x, from.z) >= -kGrazing_m && to.y - height(to.x, to.z) >= -kGrazing_m;
  if (!clear) return false;
  world::walkLine(*grid_, from, to, [] { return -kGrazing_m; }, [&](const world::CellClearance& cell) {
    const double end = cell.c0 + cell.span * (cell.c1 + cell.span * cell.c2);
    clear = (cell.c0 >= -kGrazing_m) & (end >= -kGrazing_m);
    // c1^2 / 4 c2 under the start, at the vertex.
    if (clear && hasVertex(cell)) clear = cell.c0 - 0.25 * cell.c1 * cell.c1 / cell.c2 >= -kGrazing_m;
    return clear;
  });
  return clear;
}

bool Terrain::sightSampled(const Vec3& eye, const Vec3& target, int most) const {
  if (!usable(eye) || !usable(target)) return false;
  const Vec3 along = target - eye;
  const double parts = std::ceil(std::sqrt(along.x * along.x + along.z * along.z) / kSampleSpacing_m);
  const int samples = static_cast<int>(std::clamp(parts - 1.0, 0.0, static_cast<double>(std::max(0, most))));
  for (int i = 1; i <= samples; ++i) {
    const Vec3 p = eye + (static_cast<double>(i) / (samples + 1.0)) * along;
    if (height(p.x, p.z) > p.y) return false;
  }
  return true;
}

std::optional<Vec3> Terrain::raycast(const Vec3& from, const Vec3& direction, double max_m) const {
  const double size = length(direction);
  if (!usable(from) || !usable(direction) || !(size > 0.0) || !(max_m > 0.0)) return std::nullopt;
  const Vec3 to = from + (std::min(max_m, kFar_m) / size) * direction;
  double hit = -1.0;
  world::walkLine(*grid_, from, to, [] { return kGrazing_m; }, [&](const world::CellClearance& cell) {
    const bool touching = cell.c0 <= 0.0;
    // A start on the ground is no hit while the ray leaves it.
    if (touching && (cell.c0 < -kGrazing_m || cell.c1 < 0.0)) {
      hit = cell.start;
      return false;
    }
    const double s = firstRoot(std::max(cell.c0, 0.0), cell.c1, cell.c2, cell.span);
    if (s < 0.0 || (touching && s == 0.0)) return true;
    hit = cell.start + s;
    return false;
  });
  if (hit < 0.0) return std::nullopt;
  const Vec3 along = to - from;
  const double x = from.x + hit * along.x, z = from.z + hit * along.z;
  return Vec3{x, height(x, z), z};
}

}  // namespace npsee
