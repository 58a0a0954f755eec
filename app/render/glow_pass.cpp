#include "app/render/glow_pass.h"

namespace npsee::render {

Expected<GlowPass> GlowPass::create() {
  auto program = gl::Program::fromFiles("glow.vert", "glow.frag");
  if (!program) return tl::unexpected<Error>(program.error());
  GlowPass pass;
  pass.program_ = std::move(*program);
  pass.attributes_ = gl::VertexArray::make();
  return pass;
}

void GlowPass::draw(const View& view, const GroundLevel& ground) const {
  // As with shadows: a plane drawn before everything else needs no depth, a terrain's hills hide what is behind them.
  if (ground.shadow_nearer > 0.0) glEnable(GL_DEPTH_TEST);
  else glDisable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glDisable(GL_CULL_FACE);
  program_.use();
  setView(program_, view);
  setGround(program_, view, ground);
  glDisable(GL_CLIP_DISTANCE0);
  program_.set("u_nearer", static_cast<float>(ground.shadow_nearer));
  program_.set("u_reach", static_cast<float>(ground.glow.reach()));
  program_.set("u_least", static_cast<float>(kLeastGlow));
  setVec3(program_, "u_albedo", ground.colour);
  glBindVertexArray(attributes_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace npsee::render
