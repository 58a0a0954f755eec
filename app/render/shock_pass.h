#pragma once

#include "app/render/frame_upload.h"
#include "app/render/ground_level.h"
#include "app/render/view.h"

namespace npsee::render {

/// Blast fronts: a bright ring with a dark one behind it where the front meets the ground, and a faint shell in the air.
class ShockPass {
 public:
  static Expected<ShockPass> create();

  void drawRings(const View& view, const FrameUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground) const;
  void drawShells(const View& view, const FrameUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground) const;

 private:
  gl::Program ring_, shell_;
  gl::VertexArray attributes_;
};

/// Width of the ring as a part of its radius, as in shaders/shock_ring.vert.
inline constexpr double kRingWidth = 0.055;

}  // namespace npsee::render
