#pragma once

#include "app/render/view.h"

namespace npsee::render {

/// The ground as passes see it.
struct GroundLevel {
  double height_m = 0.0;
  bool solid = true;  ///< hides what is on its other side; false over plain and transparent backgrounds
};

/// Sets u_ground and u_clip, and the clipping itself.
void setGround(const gl::Program& program, const View& view, const GroundLevel& ground);

}  // namespace npsee::render
