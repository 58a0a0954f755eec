#pragma once

#include "app/gl/objects.h"
#include "app/gl/program.h"

#include "editor/ui/damage.h"

#include <npsee/error.h>

#include <span>

namespace npsee::editor {

/// Draws ImGui's output with our own GL 3.3 code, in a window and offscreen alike, into the framebuffer bound at the time.
class DrawDataRenderer {
 public:
  /// Uploads the font atlas of the current ImGui context too. Error kind graphics with the shader log.
  static Expected<DrawDataRenderer> create();

  /// Draws what lies in the boxes. `opaque`: textures that need no blending.
  void draw(const ImDrawData& data, std::span<const PixelBox> boxes, std::span<const ImTextureID> opaque) const;

 private:
  DrawDataRenderer() = default;
  void uploadFonts();

  gl::Program program_;
  gl::VertexArray array_;
  gl::Buffer vertices_, indices_;
  gl::Texture fonts_;
};

}  // namespace npsee::editor
