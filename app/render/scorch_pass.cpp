#include "app/render/scorch_pass.h"

namespace npsee::render {

Expected<ScorchPass> ScorchPass::create() {
  ScorchPass pass;
  if (auto loaded = pass.program_.load("scorch.vert", "scorch.frag"); !loaded) return tl::unexpected<Error>(loaded.error());
  pass.attributes_ = gl::VertexArray::make();
  return pass;
}

void ScorchPass::draw(const View& view, const FrameUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, bool under) const {
  layOnGround(program_, view, ground);
  // Premultiplied, what is there keeps its share and leaves the rest to what comes under it.
  if (under) glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
  glBindVertexArray(attributes_.name());
  particles.bind(first, true);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
}

}  // namespace npsee::render
