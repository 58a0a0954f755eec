#pragma once

#include "app/render/target.h"
#include "app/render/tiles.h"

#include <npsee/preset.h>

namespace npsee::render {

/// First and last step of a picture: empties the effect's framebuffer, and turns its light into the finished picture. Both
/// go over the touched tiles only.
class FinishPass {
 public:
  static Expected<FinishPass> create();

  /// Clears colour and depth of the tiles in the bound framebuffer.
  void clear(const TileMesh& tiles) const;

  /// Lays the effect over the target's backdrop.
  void drawOverBackdrop(const Target& target, const TileMesh& tiles) const;
  /// Lays it over a plain colour, or over nothing (null): a transparent picture.
  void drawOverColour(const Target& target, const TileMesh& tiles, const Colour* behind) const;

  /// A mission's picture, which covers everything. Error kind graphics when its shader does not compile.
  Expected<void> drawMission(const Target& target, const TileMesh& tiles);

 private:
  void lay(const Target& target, const TileMesh& tiles, int behind, const Colour& plain) const;

  gl::Program clear_, single_, smooth_;
  gl::Program mission_, mission_smooth_;  // made when first needed
};

/// Sets u_plain from an sRGB-coded colour.
void setPlain(const gl::Program& program, const Colour& plain);

}  // namespace npsee::render
