#pragma once

#include "app/gl/objects.h"

#include <npsee/error.h>

namespace npsee::render {

/// What a picture is drawn into. The effect's linear light (with several samples per pixel where that is not too
/// much), the backdrop behind it (linear, and finished), and the finished sRGB-coded picture. Kept from picture
/// to picture; made anew when the size changes.
class Target {
 public:
  /// Error kind graphics when the driver has no room for the size.
  Expected<void> resize(int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }

  /// Binds the effect's framebuffer as it was left. Smooth: with four samples per pixel, if the driver has them. Error kind
  /// graphics when the driver has no room.
  Expected<void> beginEffect(bool smooth);
  /// Whether the effect has several samples per pixel.
  bool smooth() const { return smooth_; }

  /// Binds the two backdrop textures: output 0 linear, output 1 finished.
  void bindBackdrop() const;
  /// The finished picture becomes the backdrop's.
  void copyBackdrop() const;
  /// Binds the framebuffer of the finished picture, whole.
  void bindFinished() const;

  GLuint effect() const { return smooth_ ? samples_.name() : effect_.name(); }  ///< RGBA16F texture, multi-sampled if smooth()
  GLuint backdrop() const { return backdrop_.name(); }  ///< RGBA32F texture
  GLuint finished() const { return finished_.name(); }  ///< RGBA8 texture

 private:
  int width_ = 0, height_ = 0;
  bool smooth_ = false;
  gl::Texture effect_, samples_, backdrop_, backdrop_finished_, finished_;
  gl::Renderbuffer depth_, samples_depth_;
  gl::Framebuffer effect_frame_, samples_frame_, backdrop_frame_, finished_frame_;
};

}  // namespace npsee::render
