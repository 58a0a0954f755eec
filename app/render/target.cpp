#include "app/render/target.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <string>

namespace npsee::render {
namespace {

/// Samples per pixel of a smooth effect; shaders/finish_smooth.frag reads as many.
constexpr GLint kSamples = 4;
/// Largest picture with several samples: they take 48 bytes a pixel.
constexpr std::int64_t kMostSmoothPixels = 9'000'000;

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

gl::Framebuffer makeFramebuffer(const gl::Texture& colour, const gl::Texture* second = nullptr) {
  gl::Framebuffer frame = gl::Framebuffer::make();
  glBindFramebuffer(GL_FRAMEBUFFER, frame.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour.name(), 0);
  if (second == nullptr) return frame;
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, second->name(), 0);
  const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glDrawBuffers(2, both);
  return frame;
}

/// Empty if the framebuffers made so far can be used, else the driver's word.
Expected<void> checkComplete(std::initializer_list<const gl::Framebuffer*> frames, int width, int height) {
  bool usable = true;
  for (const gl::Framebuffer* frame : frames) {
    glBindFramebuffer(GL_FRAMEBUFFER, frame->name());
    usable = usable && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
  const char* error = gl::pendingError();
  if (usable && error == nullptr) return {};
  return fail(ErrorKind::graphics, "the driver has no picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels" + (error != nullptr ? std::string(": ") + error : std::string()) + ".",
              "Choose a smaller size.");
}

}  // namespace

Expected<void> Target::resize(int width, int height) {
  if (width == width_ && height == height_) return {};
  *this = Target();
  effect_ = makeTexture(GL_RGBA16F, GL_HALF_FLOAT, width, height);
  // In single precision: half floats would show in 16-bit pictures.
  backdrop_ = makeTexture(GL_RGBA32F, GL_FLOAT, width, height);
  backdrop_finished_ = makeTexture(GL_RGBA8, GL_UNSIGNED_BYTE, width, height);
  finished_ = makeTexture(GL_RGBA8, GL_UNSIGNED_BYTE, width, height);
  depth_ = makeRenderbuffer(GL_DEPTH_COMPONENT24, 0, width, height);
  effect_frame_ = makeFramebuffer(effect_);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  backdrop_frame_ = makeFramebuffer(backdrop_, &backdrop_finished_);
  finished_frame_ = makeFramebuffer(finished_);
  if (auto made = checkComplete({&effect_frame_, &backdrop_frame_, &finished_frame_}, width, height); !made) {
    *this = Target();
    return made;
  }
  width_ = width;
  height_ = height;
  return {};
}

Expected<void> Target::beginEffect(bool smooth) {
  draft_ = summed_ = false;
  GLint most = 1;
  glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &most);
  smooth_ = smooth && most >= kSamples && static_cast<std::int64_t>(width_) * height_ <= kMostSmoothPixels;
  if (smooth_ && !samples_frame_) {
    samples_ = gl::Texture::make();
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, samples_.name());
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, kSamples, GL_RGBA16F, width_, height_, GL_TRUE);
    samples_depth_ = makeRenderbuffer(GL_DEPTH_COMPONENT24, kSamples, width_, height_);
    samples_frame_ = gl::Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, samples_frame_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D_MULTISAMPLE, samples_.name(), 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, samples_depth_.name());
    if (auto made = checkComplete({&samples_frame_}, width_, height_); !made) {
      samples_frame_.reset();
      return made;
    }
  }
  glBindFramebuffer(GL_FRAMEBUFFER, smooth_ ? samples_frame_.name() : effect_frame_.name());
  glViewport(0, 0, width_, height_);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_MULTISAMPLE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return {};
}

void Target::beginDraft() {
  draft_ = true;
  smooth_ = summed_ = false;
  glBindFramebuffer(GL_FRAMEBUFFER, effect_frame_.name());
  glViewport(0, 0, effectWidth(), effectHeight());
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  // All of it: what is drawn larger looks beyond the tiles.
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, effectWidth(), effectHeight());
  const float nothing[] = {0.0f, 0.0f, 0.0f, 0.0f}, farthest = 1.0f;
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  glDisable(GL_SCISSOR_TEST);
}

Expected<void> Target::bindSum() {
  if (!sum_frame_) {
    sum_ = makeTexture(GL_RGBA32F, GL_FLOAT, width_, height_);
    sum_frame_ = makeFramebuffer(sum_);
    if (auto made = checkComplete({&sum_frame_}, width_, height_); !made) {
      sum_frame_.reset();
      return made;
    }
  }
  draft_ = smooth_ = false;
  summed_ = true;
  glBindFramebuffer(GL_FRAMEBUFFER, sum_frame_.name());
  glViewport(0, 0, width_, height_);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return {};
}

void Target::bindBackdrop() const {
  glBindFramebuffer(GL_FRAMEBUFFER, backdrop_frame_.name());
  glViewport(0, 0, width_, height_);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void Target::copyBackdrop() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, backdrop_frame_.name());
  glReadBuffer(GL_COLOR_ATTACHMENT1);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, finished_frame_.name());
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Target::bindFinished() const {
  glBindFramebuffer(GL_FRAMEBUFFER, finished_frame_.name());
  glViewport(0, 0, width_, height_);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace npsee::render
