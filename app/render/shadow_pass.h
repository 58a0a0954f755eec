#pragma once

#include "app/render/frame_upload.h"
#include "app/render/ground_level.h"
#include "app/render/view.h"

namespace npsee::render {

/// Shadows of particles on the ground: a soft blob each, where the key light throws it, wider and fainter with height.
class ShadowPass {
 public:
  static Expected<ShadowPass> create();

  /// `strength` is the darkness under a solid form, 0..1.
  void draw(const View& view, const FrameUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, double strength) const;

 private:
  gl::Program program_;
  gl::VertexArray attributes_;
};

}  // namespace npsee::render
