#include "app/render/float_target.h"

#include <algorithm>
#include <string>

namespace npsee::render {

Expected<gl::Texture> makeFloatTexture(int width, int height, gl::Framebuffer& frame) {
  gl::Texture texture = gl::Texture::make();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  frame = gl::Framebuffer::make();
  glBindFramebuffer(GL_FRAMEBUFFER, frame.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
  const bool usable = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  const char* error = gl::pendingError();
  if (usable && error == nullptr) return texture;
  return fail(ErrorKind::graphics, "the driver has no floating-point picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels" + (error != nullptr ? std::string(": ") + error : std::string()) + ".", "Choose a smaller size.");
}

void showBand(const RowBand& band, int width) {
  glViewport(0, -band.low(), width, band.height);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void readRows(int width, int rows, std::vector<float>& out) {
  out.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(rows));
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width, rows, GL_RGBA, GL_FLOAT, out.data());
}

void readFloats(int width, int rows, std::vector<float>& out) {
  const std::size_t row = 4 * static_cast<std::size_t>(width);
  readRows(width, rows, out);
  // GL's first row is the lowest.
  for (std::size_t low = 0, high = static_cast<std::size_t>(rows) - 1; low < high; ++low, --high)
    std::swap_ranges(out.begin() + static_cast<std::ptrdiff_t>(low * row), out.begin() + static_cast<std::ptrdiff_t>((low + 1) * row), out.begin() + static_cast<std::ptrdiff_t>(high * row));
}

}  // namespace npsee::render
