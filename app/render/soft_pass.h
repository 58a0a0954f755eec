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
  /// `smoke`: all of them are puffs of smoke, which is faster.
  void draw(const View& view, const BlendedUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, bool smoke) const;
  /// Whether the fine noise is drawn too.
  void setDetail(bool detail) { detail_ = detail; }
  /// Blends their depth and motion, multiplied by their cover, in the order given. Needs a pass made for surfaces.
  void drawSurfaces(const View& view, const BlendedUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, const SurfaceFrame& frame) const;

 private:
  /// With a program in use.
  void drawInstances(const gl::Program& program, const View& view, const BlendedUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground) const;

  gl::Program program_, smoke_;
  gl::VertexArray attributes_;
  gl::Texture noise_;
  bool detail_ = true;
};

}  // namespace npsee::render
