#pragma once

#include "app/render/view.h"

#include <npsee/preset.h>

namespace npsee::render {

/// Ground plane with its metre grid, and the sky.
class BackdropPass {
 public:
  static Expected<BackdropPass> create();

  /// Draws first; writes depth, so that it hides what is below.
  void drawGround(const View& view, double height_m, const Colour& colour, bool grid) const;
  /// Draws last, where nothing else is.
  void drawSky(const View& view) const;

 private:
  gl::Program ground_, sky_;
  gl::VertexArray nothing_;  // core profile wants one bound even without attributes
};

}  // namespace npsee::render
