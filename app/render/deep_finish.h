#pragma once

#include "app/render/bloom.h"
#include "app/render/float_image.h"
#include "app/render/target.h"
#include "app/render/tiles.h"

#include <npsee/preset.h>

namespace npsee::render {

/// Finishes a drawn target in single precision, for 16-bit and floating-point files; the counterpart of FinishPass.
class DeepFinish {
 public:
  static Expected<DeepFinish> create();

  /// `over_backdrop`, or over a plain colour (sRGB-coded), or over nothing (null). `effect` marks the tiles that the effect was
  /// drawn in, which spread light reaches. Fills width, height and rgba. Error kind graphics when the driver has no room.
  Expected<void> run(const Target& target, const TileMask& effect, bool over_backdrop, const Colour* plain, bool linear, const BloomLight& bloom, FloatImage& image);

 private:
  void draw(const Target& target, const TileMesh& tiles, int behind, const Colour& plain, bool linear, const BloomLight* bloom) const;

  gl::Program program_;
  TileMask all_;
  TileMesh tiles_;
  gl::Texture result_;
  gl::Framebuffer frame_;
  int width_ = 0, height_ = 0;
};

}  // namespace npsee::render
