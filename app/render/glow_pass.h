#pragma once

#include "app/gl/objects.h"
#include "app/render/ground_level.h"
#include "app/render/view.h"

namespace npsee::render {

/// The light of flashes and fire on the ground, added to what is drawn there.
class GlowPass {
 public:
  static Expected<GlowPass> create();
  void draw(const View& view, const GroundLevel& ground) const;

 private:
  gl::Program program_;
  gl::VertexArray attributes_;
};

}  // namespace npsee::render
