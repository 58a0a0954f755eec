#pragma once

#include "app/gl/objects.h"
#include "app/render/quality.h"

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
  /// Whether a picture of this size has several samples per pixel, if wanted.
  bool hasSamples() const;
  /// Binds the effect's samples, as they were left, for its pieces alone; the effect keeps one sample. Error kind graphics when the driver has no room.
  Expected<void> beginPieces();
  /// Binds the effect again with what is kept of pieces' edges: output 1 light, output 2 device depth.
  void bindEdges() const;
  /// Binds the effect again, after beginPieces().
  void bindEffect() const;
  /// Binds the part of the effect's framebuffer that a draft takes, emptied. Error kind graphics when the driver has no room.
  Expected<void> beginDraft();
  /// Binds the finished draft, emptied.
  void bindDraft() const;
  /// Binds the sum of several effects, which effect() is from then on until the next begins. Error kind graphics when the driver has no room.
  Expected<void> bindSum();

  /// Whether the effect has several samples per pixel.
  bool smooth() const { return smooth_; }
  /// Whether it has a draft's size.
  bool draft() const { return draft_; }
  int draftWidth() const { return (width_ + kDraftScale - 1) / kDraftScale; }
  int draftHeight() const { return (height_ + kDraftScale - 1) / kDraftScale; }

  /// Binds the two backdrop textures: output 0 linear, output 1 finished.
  void bindBackdrop() const;
  /// The finished picture becomes the backdrop's.
  void copyBackdrop() const;
  /// Binds the framebuffer of the finished picture, whole.
  void bindFinished() const;

  GLuint effect() const { return summed_ ? sum_.name() : smooth_ ? samples_.name() : effect_.name(); }  ///< RGBA16F texture, multi-sampled if smooth(); a sum has 32 bits
  GLuint samples() const { return samples_.name(); }              ///< RGBA16F, multi-sampled
  GLuint sampleDepths() const { return samples_depth_.name(); }   ///< device depth, multi-sampled
  GLuint edges() const { return edges_.name(); }                  ///< RGBA16F texture
  GLuint edgeDepths() const { return edge_depths_.name(); }       ///< R32F texture
  GLuint look() const { return effect_.name(); }  ///< the effect drawn last, of those that are summed
  GLuint draftLight() const { return draft_light_.name(); }        ///< RGBA8 texture of the draft's size
  GLuint backdrop() const { return backdrop_.name(); }  ///< RGBA32F texture
  GLuint finished() const { return finished_.name(); }  ///< RGBA8 texture

 private:
  int width_ = 0, height_ = 0;
  bool smooth_ = false, draft_ = false, summed_ = false;
  Expected<void> makeSamples();
  /// All pixels of a framebuffer, with all colours written.
  void bindWhole(const gl::Framebuffer& frame) const;

  gl::Texture sum_, effect_, samples_, samples_depth_, edges_, edge_depths_, draft_light_, backdrop_, backdrop_finished_, finished_;
  gl::Renderbuffer depth_;
  gl::Framebuffer sum_frame_, effect_frame_, samples_frame_, edges_frame_, draft_frame_, backdrop_frame_, finished_frame_;
};

}  // namespace npsee::render
