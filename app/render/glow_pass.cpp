#include "app/render/glow_pass.h"

namespace npsee::render {

Expected<GlowPass> GlowPass::create() {
  GlowPass pass;
  if (auto loaded = pass.program_.load("glow.vert", "glow.frag"); !loaded) return tl::unexpected<Error>(loaded.error());
  pass.attributes_ = gl::VertexArray::make();
  return pass;
}

void GlowPass::draw(const View& view, const GroundLevel& ground) const {
  layOnGround(program_, view, ground);
  glBlendFunc(GL_ONE, GL_ONE);
  program_.set("u_reach", static_cast<float>(ground.glow.reach()));
  program_.set("u_least", static_cast<float>(kLeastGlow));
  setVec3(program_, "u_albedo", ground.colour);
  glBindVertexArray(attributes_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace npsee::render
