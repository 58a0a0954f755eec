#include "app/render/target.h"

#include <algorithm>
#include <string>

namespace npsee::render {
namespace {

gl::Texture makeTexture(GLenum internal_format, GLenum type, int width, int height) {
  gl::Texture texture = gl::Texture::make();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format), width, height, 0, GL_RGBA, type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  return texture;
}

gl::Renderbuffer makeRenderbuffer(GLenum format, int samples, int width, int height) {
  gl::Renderbuffer buffer = gl::Renderbuffer::make();
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  return buffer;
}

gl::Framebuffer makeFramebuffer(const gl::Texture& colour) {
  gl::Framebuffer frame = gl::Framebuffer::make();
  glBindFramebuffer(GL_FRAMEBUFFER, frame.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour.name(), 0);
  return frame;
}

bool complete(const gl::Framebuffer& frame) {
  glBindFramebuffer(GL_FRAMEBUFFER, frame.name());
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace

Expected<void> Target::resize(int width, int height) {
  if (width == width_ && height == height_) return {};
  *this = Target();
  GLint most = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  const int samples = std::min(kSamples, static_cast<int>(most));
  light_ = makeTexture(GL_RGBA16F, GL_HALF_FLOAT, width, height);
  finished_ = makeTexture(GL_RGBA8, GL_UNSIGNED_BYTE, width, height);
  samples_ = makeRenderbuffer(GL_RGBA16F, samples, width, height);
  depth_ = makeRenderbuffer(GL_DEPTH_COMPONENT24, samples, width, height);
  light_frame_ = makeFramebuffer(light_);
  finished_frame_ = makeFramebuffer(finished_);
  samples_frame_ = gl::Framebuffer::make();
  glBindFramebuffer(GL_FRAMEBUFFER, samples_frame_.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samples_.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  const bool usable = complete(light_frame_) && complete(finished_frame_) && complete(samples_frame_);
  const char* error = gl::pendingError();
  if (!usable || error != nullptr) {
    *this = Target();
    return fail(ErrorKind::graphics, "the driver has no picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels" + (error != nullptr ? std::string(": ") + error : std::string()) + ".",
                "Choose a smaller size.");
  }
  width_ = width;
  height_ = height;
  return {};
}

void Target::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, samples_frame_.name());
  glViewport(0, 0, width_, height_);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_MULTISAMPLE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClearDepth(1.0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Target::resolve() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_frame_.name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, light_frame_.name());
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Target::bindFinished() const {
  glBindFramebuffer(GL_FRAMEBUFFER, finished_frame_.name());
  glViewport(0, 0, width_, height_);
}

}  // namespace npsee::render
