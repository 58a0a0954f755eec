#include "app/render/shock_pass.h"

#include "app/gl/state.h"

namespace npsee::render {

Expected<ShockPass> ShockPass::create() {
  ShockPass pass;
  if (auto loaded = pass.ring_.load("shock_ring.vert", "shock_ring.frag"); !loaded) return tl::unexpected<Error>(loaded.error());
  if (auto loaded = pass.shell_.load("shock_shell.vert", "shock_shell.frag"); !loaded) return tl::unexpected<Error>(loaded.error());
  pass.attributes_ = gl::VertexArray::make();
  return pass;
}

void ShockPass::drawRings(const View& view, const FrameUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground) const {
  layOnGround(ring_, view, ground);
  ring_.set("u_width", static_cast<float>(kRingWidth));
  glBindVertexArray(attributes_.name());
  particles.bind(first, false);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
}

void ShockPass::drawShells(const View& view, const FrameUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground) const {
  gl::blendOver();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  shell_.use();
  setView(shell_, view);
  setGround(shell_, view, ground);
  // The shader cuts each side of the shell at the ground by itself.
  glDisable(GL_CLIP_DISTANCE0);
  glBindVertexArray(attributes_.name());
  particles.bind(first, false);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
}

}  // namespace npsee::render
