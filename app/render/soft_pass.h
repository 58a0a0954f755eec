#pragma once

#include "app/render/frame_upload.h"
#include "app/render/ground_level.h"
#include "app/render/view.h"

namespace npsee::render {

/// Streaks along the velocity, and camera-facing smoke, fire and flash, blended in the order given.
class SoftPass {
 public:
  static Expected<SoftPass> create();
  void draw(const View& view, const BlendedUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground) const;

 private:
  gl::Program program_;
  gl::VertexArray attributes_;
  gl::Texture noise_;
};

}  // namespace npsee::render
