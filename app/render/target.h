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
  /// Binds a quarter of the effect's framebuffer, emptied: half the picture's width and height, rounded up.
  void beginDraft();
  /// Binds the sum of several effects, which effect() is from then on until the next begins. Error kind graphics when the driver has no room.
  Expected<void> bindSum();

  /// Whether the effect has several samples per pixel.
  bool smooth() const { return smooth_; }
  /// Whether it has half the size.
  bool draft() const { return draft_; }
  int effectWidth() const { return draft_ ? (width_ + 1) / 2 : width_; }
  int effectHeight() const { return draft_ ? (height_ + 1) / 2 : height_; }

  /// Binds the two backdrop textures: output 0 linear, output 1 finished.
  void bindBackdrop() const;
  /// The finished picture becomes the backdrop's.
  void copyBackdrop() const;
  /// Binds the framebuffer of the finished picture, whole.
  void bindFinished() const;

  GLuint effect() const { return summed_ ? sum_.name() : smooth_ ? samples_.name() : effect_.name(); }  ///< RGBA16F texture, multi-sampled if smooth(); a sum has 32 bits
  GLuint look() const { return effect_.name(); }  ///< the effect drawn last, of those that are summed
  GLuint backdrop() const { return backdrop_.name(); }  ///< RGBA32F texture
  GLuint finished() const { return finished_.name(); }  ///< RGBA8 texture

 private:
  int width_ = 0, height_ = 0;
  bool smooth_ = false, draft_ = false, summed_ = false;
  gl::Texture sum_, effect_, samples_, backdrop_, backdrop_finished_, finished_;
  gl::Renderbuffer depth_, samples_depth_;
  gl::Framebuffer sum_frame_, effect_frame_, samples_frame_, backdrop_frame_, finished_frame_;
};

}  // namespace npsee::render
