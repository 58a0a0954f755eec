#pragma once

#include "app/render/bloom.h"
#include "app/render/target.h"
#include "app/render/tiles.h"

#include <npsee/preset.h>

namespace npsee::render {

/// First and last step of a picture: empties the effect's framebuffer, and turns its light into the finished picture. Both
/// go over the touched tiles only. `exposure` is the factor on all light, before highlights roll off.
class FinishPass {
 public:
  static Expected<FinishPass> create();

  /// Clears colour and depth of the tiles in the bound framebuffer.
  void clear(const TileMesh& tiles) const;

  /// Adds a share of the effect drawn last to the sum bound.
  Expected<void> add(const Target& target, const TileMesh& tiles, double share);

  /// Lays the effect over the target's backdrop. Error kind graphics as drawMission().
  Expected<void> drawOverBackdrop(const Target& target, const TileMesh& tiles, double exposure, const BloomLight& bloom);
  /// Lays it over a plain colour, or over nothing (null): a transparent picture.
  Expected<void> drawOverColour(const Target& target, const TileMesh& tiles, const Colour* behind, double exposure, const BloomLight& bloom);

  /// A mission's picture, which covers everything. Error kind graphics when its shader does not compile.
  Expected<void> drawMission(const Target& target, const TileMesh& tiles, double exposure, const BloomLight& bloom);

 private:
  Expected<void> lay(const Target& target, const TileMesh& tiles, int behind, const Colour& plain, double exposure, const BloomLight& bloom);
  /// The effect's textures and uniforms that finish.glsl asks for.
  static void setScene(const gl::Program& program, const Target& target, int behind, const Colour& plain);
  Expected<void> layDraft(const Target& target, const TileMesh& tiles, int behind, const Colour& plain, double exposure);

  gl::Program clear_, single_;
  // Made when first needed.
  gl::Program smooth_, draft_, enlarge_, sum_, mission_, mission_smooth_, mission_draft_;
};

/// Sets where a draft's effect lies in its texture: u_per_pixel, u_used and u_texels, with the program in use.
void setDraft(const gl::Program& program, const Target& target);

/// Sets u_plain from an sRGB-coded colour.
void setPlain(const gl::Program& program, const Colour& plain);

/// Sets what shaders/bloom_add.glsl asks for; the spread light is bound to texture unit 2.
void setLight(const gl::Program& program, double exposure, const BloomLight& bloom);

}  // namespace npsee::render
