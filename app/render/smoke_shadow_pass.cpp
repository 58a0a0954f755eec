#include "app/render/smoke_shadow_pass.h"

#include <cmath>

namespace npsee::render {

Expected<SmokeShadowPass> SmokeShadowPass::create() {
  SmokeShadowPass pass;
  if (auto loaded = pass.program_.load("smoke_shadow.vert", "smoke_shadow.frag"); !loaded) return tl::unexpected<Error>(loaded.error());
  pass.attributes_ = gl::VertexArray::make();
  pass.map_ = gl::Texture::make();
  glBindTexture(GL_TEXTURE_2D, pass.map_.name());
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  return pass;
}

void SmokeShadowPass::draw(const View& view, const GroundLevel& ground, const Vec3& towards_sun, double share, const SmokeShadowMap& map) const {
  layOnGround(program_, view, ground);
  const double flat = std::sqrt(towards_sun.x * towards_sun.x + towards_sun.z * towards_sun.z);
  const double x = flat > 1e-9 ? -towards_sun.x / flat : 1.0, z = flat > 1e-9 ? -towards_sun.z / flat : 0.0;
  program_.set("u_throw", static_cast<float>(x), static_cast<float>(z));
  program_.set("u_origin", static_cast<float>(map.origin_u), static_cast<float>(map.origin_v));
  program_.set("u_extent", static_cast<float>(map.columns * map.cell_m), static_cast<float>(map.rows * map.cell_m));
  program_.set("u_map", 0);
  program_.set("u_share", static_cast<float>(share));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, map_.name());
  glBindSampler(0, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R16F, map.columns, map.rows, 0, GL_RED, GL_FLOAT, map.dark.data());
  glBindVertexArray(attributes_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace npsee::render
