#pragma once

#include "app/gl/program.h"
#include "app/render/target.h"

#include <npsee/preset.h>

namespace npsee::render {

/// Turns a target's linear light into its finished picture.
class FinishPass {
 public:
  static Expected<FinishPass> create();

  /// Resolves and finishes `target`. `behind` is null for a transparent picture. With `rows_from_top` the picture's first
  /// row is the top one, as image files want it.
  void draw(const Target& target, const Colour* behind, bool rows_from_top) const;

 private:
  gl::Program program_;
  gl::VertexArray nothing_;
};

}  // namespace npsee::render
