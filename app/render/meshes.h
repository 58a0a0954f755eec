#pragma once

#include "app/gl/objects.h"

#include <npsee/preset.h>
#include <npsee/vec3.h>

#include <cstdint>
#include <vector>

namespace npsee::render {

/// Triangles of a solid form within a sphere of diameter 1 around the origin.
struct Mesh {
  struct Vertex {
    float position[3];
    float normal[3];
  };
  std::vector<Vertex> vertices;
  std::vector<std::uint16_t> indices;
  std::vector<Vec3> hull;    ///< corners that can touch the ground first, at most 8; empty for a ball
  double lift_limit = 0.5;   ///< largest lift off the ground as a fraction of the size
  bool facets = true;        ///< one light per facet, that of its last corner
  bool two_sided = false;
};

/// Mesh of tetrahedron, disc, sphere or shard; forms that are drawn softly have none (no vertices).
Mesh meshOf(Form form);

/// True for the forms that are drawn as camera-facing discs or ribbons.
bool isSoft(Form form);
/// True for the forms that are drawn as lit meshes. The others, neither soft nor solid, have passes of their own.
bool isSolid(Form form);

}  // namespace npsee::render
