#pragma once

#include "app/render/effect_passes.h"
#include "app/render/float_image.h"
#include "app/render/float_target.h"

namespace npsee::render {

/// Depth and motion of the nearest surfaces, for compositing.
class SurfacePass {
 public:
  static Expected<SurfacePass> create();

  /// Draws the frame that `effects` uploaded last (null: none) and the ground where it is solid, and fills width, height, depth and
  /// motion of `image`, as requested, with the rows of a band. Error kind graphics when the driver has no room.
  Expected<void> run(EffectPasses& effects, const Frame* frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, int width, const RowBand& band, const FloatRequest& request, FloatImage& image);

 private:
  Expected<void> resize(int width, int rows);
  /// The framebuffer bound and its values empty; depth stays.
  void begin(const RowBand& band) const;
  /// Reads what is drawn: pieces and ground, or puffs, which replace them where they are a surface.
  void take(FloatImage& image, const FloatRequest& request, bool puffs);
  void drawGround(const View& view, const GroundLevel& ground, const RowBand& band) const;

  gl::Program ground_;
  gl::VertexArray nothing_;
  gl::Texture values_;
  gl::Renderbuffer depth_;
  gl::Framebuffer frame_;
  int width_ = 0, rows_ = 0;
  std::vector<float> read_;
};

}  // namespace npsee::render
