#pragma once

#include "app/gl/program.h"
#include "app/render/strokes.h"

namespace npsee::render {

/// Draws lines and dots that a StrokeBuilder made.
class StrokePass {
 public:
  /// Error kind graphics with the log of a shader that does not compile.
  static Expected<StrokePass> create();

  enum class Hiding {
    by_depth,  ///< what lies behind the depth buffer's surfaces is drawn first, as faintly as its style says, then the rest
    none       ///< drawn over everything
  };
  /// Blends the triangles over the bound framebuffer, which takes linear premultiplied light. Sets all the state it needs, writes no
  /// depth and leaves the depth mask on.
  void draw(const std::vector<StrokeVertex>& triangles, Hiding hiding);

 private:
  gl::Program program_;
  gl::VertexArray attributes_;
  gl::Buffer vertices_;
};

}  // namespace npsee::render
