#include "app/render/meshes.h"

#include <npsee/units.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace npsee::render {
namespace {

Vec3 unit(const Vec3& v) { return (1.0 / length(v)) * v; }

void addVertex(Mesh& mesh, const Vec3& position, const Vec3& normal) {
  mesh.indices.push_back(static_cast<std::uint16_t>(mesh.vertices.size()));
  const auto f = [](double v) { return static_cast<float>(v); };
  mesh.vertices.push_back({{f(position.x), f(position.y), f(position.z)}, {f(normal.x), f(normal.y), f(normal.z)}});
}

/// A facet with its own normal; corners in any order, the normal points away from the origin.
void addFacet(Mesh& mesh, Vec3 a, Vec3 b, const Vec3& c) {
  Vec3 normal = cross(b - a, c - a);
  if (dot(normal, a + b + c) < 0.0) {
    std::swap(a, b);
    normal = -1.0 * normal;
  }
  normal = unit(normal);
  for (const Vec3& corner : {a, b, c}) addVertex(mesh, corner, normal);
}

Mesh tetrahedron() {
  Mesh mesh;
  const double s = 0.5 / std::sqrt(3.0);
  mesh.hull = {{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}};
  // Four corners serve four facets: a facet takes its light from its last corner, and each corner is last in one facet. Twelve
  // corners would be shaded three times as long.
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const Vec3 normal = -1.0 * unit(mesh.hull[(corner + 3) % 4]);
    addVertex(mesh, mesh.hull[corner], normal);
    mesh.indices.pop_back();
  }
  for (std::size_t last = 0; last < 4; ++last) {
    std::size_t first = (last + 1) % 4, second = (last + 2) % 4;
    const Vec3 &a = mesh.hull[first], &b = mesh.hull[second], &c = mesh.hull[last];
    // Counter-clockwise from outside.
    if (dot(cross(b - a, c - a), a + b + c) < 0.0) std::swap(first, second);
    for (const std::size_t index : {first, second, last}) mesh.indices.push_back(static_cast<std::uint16_t>(index));
  }
  // A third of the way between lying on a facet (1/6) and standing on a corner (1/2): seldom floating, hardly buried.
  mesh.lift_limit = 0.26;
  return mesh;
}

/// A long irregular splinter: two tips and a crooked waist of three corners.
Mesh shard() {
  Mesh mesh;
  mesh.hull = {{0.02, 0.50, 0.0}, {-0.04, -0.46, 0.03}, {0.15, 0.06, 0.03}, {-0.07, -0.08, 0.13}, {-0.05, 0.04, -0.11}};
  for (int i = 0; i < 3; ++i) {
    const Vec3 a = mesh.hull[static_cast<std::size_t>(2 + i)], b = mesh.hull[static_cast<std::size_t>(2 + (i + 1) % 3)];
    addFacet(mesh, mesh.hull[0], a, b);
    addFacet(mesh, mesh.hull[1], a, b);
  }
  mesh.lift_limit = 0.16;
  return mesh;
}

Mesh disc() {
  constexpr int kSides = 20;
  Mesh mesh;
  mesh.two_sided = true;
  mesh.lift_limit = 0.30;
  const auto rim = [](int i) {
    const double angle = kTwoPi * i / kSides;
    return Vec3{0.5 * std::cos(angle), 0.0, 0.5 * std::sin(angle)};
  };
  for (int i = 0; i < kSides; ++i)
    for (const Vec3& corner : {Vec3{}, rim(i + 1), rim(i)}) addVertex(mesh, corner, {0.0, 1.0, 0.0});
  for (int i = 0; i < 8; ++i) {
    const double angle = kTwoPi * i / 8;
    mesh.hull.push_back({0.5 * std::cos(angle), 0.0, 0.5 * std::sin(angle)});
  }
  return mesh;
}

/// An icosahedron, each facet cut in four and pushed out to the sphere.
Mesh sphere() {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  const std::array<Vec3, 12> corners{{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0}, {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g}, {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}}};
  constexpr int kFacets[20][3] = {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                  {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8}, {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}};
  Mesh mesh;
  mesh.facets = false;
  std::vector<Vec3> points;
  std::map<std::pair<int, int>, std::uint16_t> between;
  const auto point = [&](const Vec3& direction) {
    const Vec3 n = unit(direction);
    addVertex(mesh, 0.5 * n, n);
    mesh.indices.pop_back();
    points.push_back(n);
    return static_cast<std::uint16_t>(points.size() - 1);
  };
  for (const Vec3& corner : corners) point(corner);
  const auto middle = [&](int a, int b) {
    const auto key = std::minmax(a, b);
    if (const auto found = between.find(key); found != between.end()) return found->second;
    return between[key] = point(points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)]);
  };
  for (const auto& f : kFacets) {
    const auto a = static_cast<std::uint16_t>(f[0]), b = static_cast<std::uint16_t>(f[1]), c = static_cast<std::uint16_t>(f[2]);
    const std::uint16_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const std::uint16_t i : {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca}) mesh.indices.push_back(i);
  }
  return mesh;
}

}  // namespace

bool isSoft(Form form) { return form == Form::streak || form == Form::smoke || form == Form::fire || form == Form::flash; }

bool isSolid(Form form) { return form == Form::tetrahedron || form == Form::disc || form == Form::sphere || form == Form::shard; }

Mesh meshOf(Form form) {
  switch (form) {
    case Form::tetrahedron: return tetrahedron();
    case Form::shard: return shard();
    case Form::disc: return disc();
    case Form::sphere: return sphere();
    case Form::streak:
    case Form::smoke:
    case Form::fire:
    case Form::flash:
    case Form::shock:
    case Form::scorch:
    case Form::pieces: break;
  }
  return {};
}

}  // namespace npsee::render
