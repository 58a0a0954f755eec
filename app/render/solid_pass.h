#pragma once

#include "app/render/frame_upload.h"
#include "app/render/ground_level.h"
#include "app/render/meshes.h"
#include "app/render/particle_output.h"
#include "app/render/view.h"

#include <array>

namespace npsee::render {

/// Lit meshes, one instance per particle: tetrahedron, disc, sphere, shard.
class SolidPass {
 public:
  static Expected<SolidPass> create(ParticleOutput output = ParticleOutput::light);

  /// Draws the opaque particles of a frame's range.
  void drawOpaque(const View& view, Form form, const FrameUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground);
  /// Draws the depth and motion of those that cover at least half of what is behind them. Needs velocities uploaded, and a pass
  /// made for surfaces.
  void drawSurfaces(const View& view, Form form, const FrameUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, const SurfaceFrame& frame);
  /// Blends particles in the order given. With their depth they hide what is drawn later behind them.
  void drawBlended(const View& view, Form form, const BlendedUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, bool with_depth);

 private:
  struct LoadedMesh {
    gl::VertexArray attributes;
    gl::Buffer vertices, indices;
    Mesh mesh;
  };
  LoadedMesh& loaded(Form form);
  void prepare(const View& view, const LoadedMesh& mesh, const GroundLevel& ground) const;

  gl::Program program_;
  std::array<LoadedMesh, 4> meshes_;  // made when first needed
};

/// Opacity from which a particle counts as opaque: what 8 bits cannot tell from 1.
inline constexpr float kOpaque = 0.998f;

}  // namespace npsee::render
