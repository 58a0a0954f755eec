#pragma once

#include "app/render/target.h"
#include "app/render/view.h"

#include <npsee/preset.h>

namespace npsee::render {

/// All that the picture behind an effect depends on.
struct Backdrop {
  View view;
  double ground_m = 0.0;
  Colour ground_colour;
  Sky sky = Sky::day;
  bool grid = true;
  double exposure = 1.0;  ///< factor on the light

  friend bool operator==(const Backdrop&, const Backdrop&) = default;
};

/// Ground plane with its metre grid, and the sky.
class BackdropPass {
 public:
  static Expected<BackdropPass> create();

  /// Draws into the target's backdrop textures.
  void draw(const Target& target, const Backdrop& backdrop) const;

 private:
  gl::Program program_;
  gl::VertexArray nothing_;  // core profile wants one bound even without attributes
};

}  // namespace npsee::render
