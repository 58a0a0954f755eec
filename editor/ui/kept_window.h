#pragma once

#include "app/gl/objects.h"
#include "editor/ui/damage.h"
#include "editor/ui/draw_data.h"

namespace npsee::editor {

/// The window's picture, kept from frame to frame: only what has changed is drawn.
class KeptWindow {
 public:
  /// Error kind graphics with the shader log.
  static Expected<KeptWindow> create();

  /// Brings the picture up to date. `redrawn`: textures with another content than the last time; `opaque`: those that hide what is behind
  /// them. False if nothing had to be drawn.
  bool update(const ImDrawData& data, std::span<const ImTextureID> redrawn, std::span<const ImTextureID> opaque);
  /// All of it is drawn at the next update: the driver may have left anything in it.
  void forget() { damage_ = {}; }
  /// Copies it to another framebuffer of the same size.
  void copyTo(GLuint framebuffer) const;
  /// Binds it for reading.
  void bindToRead() const;

 private:
  explicit KeptWindow(DrawDataRenderer renderer) : renderer_(std::move(renderer)) {}
  void resize(int width, int height);

  DrawDataRenderer renderer_;
  Damage damage_;
  int width_ = 0, height_ = 0;
  gl::Texture texture_;
  gl::Framebuffer frame_;
};

}  // namespace npsee::editor
