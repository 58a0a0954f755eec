#pragma once

#include "app/gl/objects.h"
#include "app/gl/program.h"

#include <npsee/error.h>

struct ImDrawData;

namespace npsee::editor {

/// Draws ImGui's output with our own GL 3.3 code, in a window and offscreen alike, into the framebuffer bound at the time.
class DrawDataRenderer {
 public:
  /// Uploads the font atlas of the current ImGui context too. Error kind graphics with the shader log.
  static Expected<DrawDataRenderer> create();

  void draw(const ImDrawData& data) const;

 private:
  DrawDataRenderer() = default;
  void uploadFonts();

  gl::Program program_;
  gl::VertexArray array_;
  gl::Buffer vertices_, indices_;
  gl::Texture fonts_;
};

}  // namespace npsee::editor
