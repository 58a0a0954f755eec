#pragma once

#include "app/gl/objects.h"
#include "app/render/ground_level.h"
#include "app/render/smoke_shadow.h"

namespace npsee::render {

/// The shadow of smoke on the ground: one square under its map.
class SmokeShadowPass {
 public:
  static Expected<SmokeShadowPass> create();
  /// `share` is that of the sun or the moon in the ground's light, beside the day's.
  void draw(const View& view, const GroundLevel& ground, const Vec3& towards_sun, double share, const SmokeShadowMap& map) const;

 private:
  gl::Program program_;
  gl::VertexArray attributes_;
  gl::Texture map_;
};

}  // namespace npsee::render
