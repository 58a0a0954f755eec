#include <npsee/fragments.h>

#include <algorithm>
#include <cmath>

namespace npsee {
namespace {

/// Slivers weigh nothing: what they get is bounded by what particles may have at all.
constexpr double kMostSpeed_mps = 3000.0, kMostSpin_radps = 200.0;

Vec3 atMost(const Vec3& v, double most) {
  const double size = length(v);
  return size > most ? (most / size) * v : v;
}

/// Solves I w = l for a symmetric tensor; nothing where it has no inverse.
Vec3 solved(const std::array<double, 6>& inertia, const Vec3& l) {
  const auto [xx, yy, zz, xy, yz, zx] = inertia;
  const double a = yy * zz - yz * yz, b = zx * yz - xy * zz, c = xy * yz - zx * yy;
  const double determinant = xx * a + xy * b + zx * c;
  if (!(std::fabs(determinant) > 0.0)) return {};
  const double d = xx * zz - zx * zx, e = xy * zx - xx * yz, f = xx * yy - xy * xy;
  const Vec3 out = (1.0 / determinant) * Vec3{a * l.x + b * l.y + c * l.z, b * l.x + d * l.y + e * l.z, c * l.x + e * l.y + f * l.z};
  return std::isfinite(out.x) && std::isfinite(out.y) && std::isfinite(out.z) ? out : Vec3{};
}

}  // namespace

Fling flingOf(const Piece& piece, const Impulse& impulse) {
  Fling out;
  if (!(piece.mass.mass_kg > 0.0)) return out;
  const Vec3 from = piece.mass.centre_m - impulse.burst_m;
  const double distance = length(from);
  const Vec3 away = distance > 1e-9 ? (1.0 / distance) * from : Vec3{0.0, 1.0, 0.0};
  const double inverse_reach = 1.0 / std::max(impulse.reach_m, 1e-6);
  Vec3 linear, angular;
  for (const Facet& facet : piece.solid.facets) {
    const Vec3 a = piece.solid.points[facet.corners[0]], b = piece.solid.points[facet.corners[1]], c = piece.solid.points[facet.corners[2]];
    const double facing = -0.5 * dot(cross(b - a, c - a), away);
    if (!(facing > 0.0)) continue;
    const Vec3 place = (1.0 / 3.0) * (a + b + c);
    const double r = length(place + from) * inverse_reach;
    const Vec3 share = (impulse.strength_Pas / (1.0 + r * r) * facing) * away;
    linear = linear + share;
    angular = angular + cross(place, share);
  }
  out.velocity_mps = atMost((1.0 / piece.mass.mass_kg) * linear, kMostSpeed_mps);
  out.spin_radps = atMost(solved(piece.mass.inertia_kgm2, angular), kMostSpin_radps);
  return out;
}

}  // namespace npsee
