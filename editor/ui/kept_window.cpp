#include "editor/ui/kept_window.h"

namespace npsee::editor {

Expected<KeptWindow> KeptWindow::create() {
  auto renderer = DrawDataRenderer::create();
  if (!renderer) return tl::unexpected<Error>(renderer.error());
  return KeptWindow(std::move(*renderer));
}

void KeptWindow::resize(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  texture_ = gl::Texture::make();
  frame_ = gl::Framebuffer::make();
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
}

bool KeptWindow::update(const ImDrawData& data, std::span<const ImTextureID> redrawn, std::span<const ImTextureID> opaque) {
  const auto width = static_cast<int>(data.DisplaySize.x * data.FramebufferScale.x), height = static_cast<int>(data.DisplaySize.y * data.FramebufferScale.y);
  if (width <= 0 || height <= 0) return false;
  const auto& boxes = damage_.find(data, redrawn);
  if (boxes.empty()) return false;
  resize(width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
  glEnable(GL_SCISSOR_TEST);
  for (const PixelBox& box : boxes) {
    glScissor(box.left, height - box.bottom, box.right - box.left, box.bottom - box.top);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  renderer_.draw(data, boxes, opaque);
  return true;
}

void KeptWindow::copyTo(GLuint framebuffer) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void KeptWindow::bindToRead() const { glBindFramebuffer(GL_FRAMEBUFFER, frame_.name()); }

}  // namespace npsee::editor
