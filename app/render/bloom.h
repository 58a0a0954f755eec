#pragma once

#include "app/gl/objects.h"
#include "app/render/target.h"
#include "app/render/tiles.h"

#include <vector>

namespace npsee::render {

/// Spread light, as FinishPass adds it; none where `texture` is 0.
struct BloomLight {
  GLuint texture = 0;  ///< linear light that has come to a place, of RGBA16F
  double share = 0.0;  ///< of the light above the threshold, which has left its own place
  double width_px = 0.0, height_px = 0.0;  ///< of the picture that the whole texture spans
  int cell_px = 1;     ///< side of a texel; light has left where its alpha is 1
};

/// Light that is too bright for the picture spreads over its neighbours, as in an eye or a lens.
///
/// What is above the threshold of the roll-off (0.8), B = c (m - 0.8) / m with m the largest component of c, is averaged into cells of
/// 1/180 of the picture's height, halved again and again to cells of 1/11 of it ([1 3 3 1] filters), and added up on the way back (tents).
/// A picture c becomes c + s (sum of w_i B_i - B), with the weights w_i adding up to 1: light is moved, none is made. Cells are a share of
/// the height, so that a picture of any size shows the same.
class Bloom {
 public:
  static Expected<Bloom> create();

  /// Share s that spreads.
  static constexpr double kShare = 0.24;
  /// How far light may spread, as a share of the height.
  static constexpr double kReach = 0.16;
  /// Pixels of `height` whose mean is a cell of the finest level.
  static int cellOf(int height);

  /// Spreads the light of the target's effect that stands in the tiles. Error kind graphics when the driver has no room.
  Expected<BloomLight> run(const Target& target, const TileMask& bright);

 private:
  struct Level {
    gl::Texture texture;
    gl::Framebuffer frame;
    int width = 0, height = 0;
    float weight = 0.0f;
  };
  Expected<void> resize(int width, int height);
  void take(const Target& target, const TileMask& bright);
  void down(const Level& from, const Level& to) const;
  void up(const Level& from, const Level& to, float scale) const;

  gl::Program bright_, bright_smooth_, down_, up_;
  gl::VertexArray nothing_;
  TileMesh tiles_;
  std::vector<Level> levels_;
  int width_ = 0, height_ = 0, cell_ = 1;
};

}  // namespace npsee::render
