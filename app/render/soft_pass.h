#pragma once

#include "app/render/frame_upload.h"
#include "app/render/ground_level.h"
#include "app/render/particle_output.h"
#include "app/render/view.h"

namespace npsee::render {

/// Streaks along the velocity, and camera-facing smoke, fire and flash, blended in the order given.
class SoftPass {
 public:
  static Expected<SoftPass> create(ParticleOutput output = ParticleOutput::light);
  void draw(const View& view, const BlendedUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground) const;
  /// Whether the fine noise is drawn too.
  void setDetail(bool detail) { detail_ = detail; }
  /// Blends their depth and motion, multiplied by their cover, in the order given. Needs a pass made for surfaces.
  void drawSurfaces(const View& view, const BlendedUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, const SurfaceFrame& frame) const;

 private:
  void drawInstances(const View& view, const BlendedUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground) const;

  gl::Program program_;
  gl::VertexArray attributes_;
  gl::Texture noise_;
  bool detail_ = true;
};

}  // namespace npsee::render
