#include "app/render/target.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>

namespace npsee::render {
namespace {

/// Samples per pixel of a smooth effect; shaders/finish_smooth.frag reads as many.
constexpr GLint kSamples = 4;
/// Largest picture with several samples: they take 60 bytes a pixel.
constexpr std::int64_t kMostSmoothPixels = 9'000'000;

gl::Texture makeTexture(GLenum internal_format, GLenum type, int width, int height, GLenum format = GL_RGBA) {
  gl::Texture texture = gl::Texture::make();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format), width, height, 0, format, type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  return texture;
}

gl::Texture makeSampled(GLenum internal_format, int width, int height) {
  gl::Texture texture = gl::Texture::make();
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture.name());
  glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, kSamples, internal_format, width, height, GL_TRUE);
  return texture;
}

gl::Renderbuffer makeDepth(int width, int height) {
  gl::Renderbuffer buffer = gl::Renderbuffer::make();
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  return buffer;
}

/// Output i goes into the i-th texture.
gl::Framebuffer makeFramebuffer(std::initializer_list<const gl::Texture*> colours, GLenum kind = GL_TEXTURE_2D) {
  gl::Framebuffer frame = gl::Framebuffer::make();
  glBindFramebuffer(GL_FRAMEBUFFER, frame.name());
  std::array<GLenum, 3> outputs{};
  GLsizei count = 0;
  for (const gl::Texture* colour : colours) {
    const GLenum output = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(count);
    glFramebufferTexture2D(GL_FRAMEBUFFER, output, kind, colour->name(), 0);
    outputs.at(static_cast<std::size_t>(count++)) = output;
  }
  glDrawBuffers(count, outputs.data());
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
  depth_ = makeDepth(width, height);
  effect_frame_ = makeFramebuffer({&effect_});
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  backdrop_frame_ = makeFramebuffer({&backdrop_, &backdrop_finished_});
  finished_frame_ = makeFramebuffer({&finished_});
  if (auto made = checkComplete({&effect_frame_, &backdrop_frame_, &finished_frame_}, width, height); !made) {
    *this = Target();
    return made;
  }
  width_ = width;
  height_ = height;
  return {};
}

bool Target::hasSamples() const {
  GLint most = 1;
  glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &most);
  return most >= kSamples && static_cast<std::int64_t>(width_) * height_ <= kMostSmoothPixels;
}

Expected<void> Target::makeSamples() {
  if (samples_frame_) return {};
  samples_ = makeSampled(GL_RGBA16F, width_, height_);
  samples_depth_ = makeSampled(GL_DEPTH_COMPONENT24, width_, height_);
  samples_frame_ = makeFramebuffer({&samples_}, GL_TEXTURE_2D_MULTISAMPLE);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D_MULTISAMPLE, samples_depth_.name(), 0);
  auto made = checkComplete({&samples_frame_}, width_, height_);
  if (!made) samples_frame_.reset();
  return made;
}

void Target::bindWhole(const gl::Framebuffer& frame) const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame.name());
  glViewport(0, 0, width_, height_);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

Expected<void> Target::beginEffect(bool smooth) {
  draft_ = summed_ = false;
  smooth_ = smooth && hasSamples();
  if (smooth_)
    if (auto made = makeSamples(); !made) return made;
  bindWhole(smooth_ ? samples_frame_ : effect_frame_);
  glEnable(GL_MULTISAMPLE);
  return {};
}

Expected<void> Target::beginPieces() {
  if (auto made = makeSamples(); !made) return made;
  if (!edges_frame_) {
    edges_ = makeTexture(GL_RGBA16F, GL_HALF_FLOAT, width_, height_);
    edge_depths_ = makeTexture(GL_R32F, GL_FLOAT, width_, height_, GL_RED);
    edges_frame_ = makeFramebuffer({&effect_, &edges_, &edge_depths_});
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    if (auto made = checkComplete({&edges_frame_}, width_, height_); !made) {
      edges_frame_.reset();
      return made;
    }
  }
  bindWhole(samples_frame_);
  glEnable(GL_MULTISAMPLE);
  return {};
}

void Target::bindEdges() const { bindWhole(edges_frame_); }
void Target::bindEffect() const { bindWhole(effect_frame_); }

Expected<void> Target::beginDraft() {
  if (!draft_frame_) {
    draft_light_ = makeTexture(GL_RGBA8, GL_UNSIGNED_BYTE, draftWidth(), draftHeight());
    draft_frame_ = makeFramebuffer({&draft_light_});
    if (auto made = checkComplete({&draft_frame_}, draftWidth(), draftHeight()); !made) {
      draft_frame_.reset();
      return made;
    }
  }
  draft_ = true;
  smooth_ = summed_ = false;
  bindWhole(effect_frame_);
  glViewport(0, 0, draftWidth(), draftHeight());
  return {};
}

void Target::bindDraft() const {
  bindWhole(draft_frame_);
  glViewport(0, 0, draftWidth(), draftHeight());
  // All of it: what is drawn larger looks beyond the tiles.
  const float nothing[] = {0.0f, 0.0f, 0.0f, 0.0f};
  glClearBufferfv(GL_COLOR, 0, nothing);
}

Expected<void> Target::bindSum() {
  if (!sum_frame_) {
    sum_ = makeTexture(GL_RGBA32F, GL_FLOAT, width_, height_);
    sum_frame_ = makeFramebuffer({&sum_});
    if (auto made = checkComplete({&sum_frame_}, width_, height_); !made) {
      sum_frame_.reset();
      return made;
    }
  }
  draft_ = smooth_ = false;
  summed_ = true;
  bindWhole(sum_frame_);
  return {};
}

void Target::bindBackdrop() const {
  bindWhole(backdrop_frame_);
}

void Target::copyBackdrop() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, backdrop_frame_.name());
  glReadBuffer(GL_COLOR_ATTACHMENT1);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, finished_frame_.name());
  glDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Target::bindFinished() const {
  bindWhole(finished_frame_);
}

}  // namespace npsee::render
