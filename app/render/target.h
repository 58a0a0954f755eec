#pragma once

#include "app/gl/objects.h"

#include <npsee/error.h>

namespace npsee::render {

/// What a picture is drawn into: linear light with several samples per pixel, the same resolved to one, and the finished
/// sRGB-coded texture. Kept from picture to picture; made anew when the size changes.
class Target {
 public:
  /// Error kind graphics when the driver has no room for the size.
  Expected<void> resize(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  /// Binds the multi-sampled framebuffer with the viewport over all of it, and clears it to nothing.
  void begin() const;
  /// Averages the samples into the texture of linear light.
  void resolve() const;
  /// Binds the framebuffer of the finished picture.
  void bindFinished() const;

  GLuint light() const { return light_.name(); }        ///< RGBA16F texture, after resolve()
  GLuint finished() const { return finished_.name(); }  ///< RGBA8 texture

 private:
  int width_ = 0, height_ = 0;
  gl::Framebuffer samples_frame_, light_frame_, finished_frame_;
  gl::Renderbuffer samples_, depth_;
  gl::Texture light_, finished_;
};

/// Samples per pixel.
inline constexpr int kSamples = 4;

}  // namespace npsee::render
