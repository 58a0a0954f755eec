#pragma once

#include "app/render/bloom.h"
#include "app/render/float_image.h"
#include "app/render/float_target.h"
#include "app/render/target.h"
#include "app/render/tiles.h"

#include <npsee/preset.h>

namespace npsee::render {

/// What a finished picture is made of.
struct DeepParts {
  const TileMask& effect;        ///< the tiles that the effect was drawn in, which spread light reaches
  bool over_backdrop = false;    ///< else over `plain`
  const Colour* plain = nullptr; ///< sRGB-coded; null: over nothing
  bool linear = true;            ///< scene light, else as on the screen
  double exposure = 1.0;         ///< as in FinishPass
  BloomLight bloom;
};

/// Finishes a drawn target in single precision, for 16-bit and floating-point files; the counterpart of FinishPass.
class DeepFinish {
 public:
  static Expected<DeepFinish> create();

  /// Fills width, height and rgba of `image` with the rows of a band. Error kind graphics when the driver has no room.
  Expected<void> run(const Target& target, const DeepParts& parts, const RowBand& band, FloatImage& image);

 private:
  Expected<void> resize(int width, int rows);
  Expected<void> draw(const Target& target, const TileMesh& tiles, const DeepParts& parts, const RowBand& band, bool with_effect);

  gl::Program program_;
  gl::Program draft_;  // made when first needed
  TileMask all_;
  TileMesh tiles_;
  gl::Texture result_;
  gl::Framebuffer frame_;
  int width_ = 0, rows_ = 0;
};

}  // namespace npsee::render
