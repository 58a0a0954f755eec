#pragma once

#include "app/render/frame_upload.h"
#include "app/render/ground_level.h"
#include "app/render/view.h"

namespace npsee::render {

/// Burnt patches on the ground under particles of the form scorch. They belong to the ground: shadows, light and pieces lie on them.
class ScorchPass {
 public:
  static Expected<ScorchPass> create();
  /// `under`: under what is drawn already, such as the outlines of shadows.
  void draw(const View& view, const FrameUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, bool under) const;

 private:
  gl::Program program_;
  gl::VertexArray attributes_;
};

}  // namespace npsee::render
