#include <npsee/fragments.h>

#include <algorithm>

namespace npsee {

MassProperties massOf(const Solid& solid, double density_kgpm3) {
  MassProperties out;
  if (solid.points.empty()) return out;
  // From a point in their midst the tetrahedra stay small, and with them what rounding takes.
  Vec3 origin;
  for (const Vec3& point : solid.points) origin = origin + point;
  origin = (1.0 / static_cast<double>(solid.points.size())) * origin;

  double six_volumes = 0.0;
  Vec3 moment;                     // 24 times the integral of x
  double xx = 0.0, yy = 0.0, zz = 0.0, xy = 0.0, yz = 0.0, zx = 0.0;  // 120 times the integrals of x x, ...
  for (const Facet& facet : solid.facets) {
    const Vec3 a = solid.points[facet.corners[0]] - origin, b = solid.points[facet.corners[1]] - origin, c = solid.points[facet.corners[2]] - origin;
    const double d = dot(a, cross(b, c));
    const Vec3 s = a + b + c;
    six_volumes += d;
    moment = moment + d * s;
    xx += d * (a.x * a.x + b.x * b.x + c.x * c.x + s.x * s.x);
    yy += d * (a.y * a.y + b.y * b.y + c.y * c.y + s.y * s.y);
    zz += d * (a.z * a.z + b.z * b.z + c.z * c.z + s.z * s.z);
    xy += d * (a.x * a.y + b.x * b.y + c.x * c.y + s.x * s.y);
    yz += d * (a.y * a.z + b.y * b.z + c.y * c.z + s.y * s.z);
    zx += d * (a.z * a.x + b.z * b.x + c.z * c.x + s.z * s.x);
  }
  out.volume_m3 = six_volumes / 6.0;
  out.mass_kg = density_kgpm3 * out.volume_m3;
  const Vec3 offset = out.volume_m3 != 0.0 ? (1.0 / (24.0 * out.volume_m3)) * moment : Vec3{};
  out.centre_m = origin + offset;
  // Second moments about the centre of mass (Steiner), then the tensor.
  const double k = density_kgpm3 / 120.0, m = out.mass_kg;
  const double sxx = k * xx - m * offset.x * offset.x, syy = k * yy - m * offset.y * offset.y, szz = k * zz - m * offset.z * offset.z;
  out.inertia_kgm2 = {syy + szz, szz + sxx, sxx + syy, -(k * xy - m * offset.x * offset.y), -(k * yz - m * offset.y * offset.z), -(k * zx - m * offset.z * offset.x)};
  return out;
}

}  // namespace npsee
