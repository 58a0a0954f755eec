#pragma once

#include "app/gl/objects.h"
#include "app/render/ground_level.h"
#include "app/render/smoke_shadow.h"

namespace npsee::render {

/// The shadow of smoke on the ground: one square under its map.
class SmokeShadowPass {
 public:
  static Expected<SmokeShadowPass> create();
  void draw(const View& view, const GroundLevel& ground, const Vec3& towards_sun, const SmokeShadowMap& map) const;

 private:
  gl::Program program_;
  gl::VertexArray attributes_;
  gl::Texture map_;
};

}  // namespace npsee::render
