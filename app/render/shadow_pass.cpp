#include "app/render/shadow_pass.h"

namespace npsee::render {
namespace {

// Where there are more pieces than this, their shadows run into each other and cost as much as the pieces themselves; every second,
// third ... one then stands for its neighbours.
constexpr std::size_t kMostShadows = 20'000;

}  // namespace

Expected<ShadowPass> ShadowPass::create() {
  ShadowPass pass;
  if (auto loaded = pass.program_.load("shadow.vert", "shadow.frag"); !loaded) return tl::unexpected<Error>(loaded.error());
  pass.attributes_ = gl::VertexArray::make();
  return pass;
}

void ShadowPass::draw(const View& view, const FrameUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, double strength) const {
  layOnGround(program_, view, ground);
  program_.set("u_strength", static_cast<float>(strength));
  // The sun is half a degree wide: 0.009 from one edge of its disc to the other.
  program_.set("u_spread", 0.010f);
  glBindVertexArray(attributes_.name());
  const std::size_t every = (count + kMostShadows - 1) / kMostShadows;
  particles.bind(first, false, every);
  glDrawArraysInstanced(GL_TRIANGLES, 0, 3, static_cast<GLsizei>((count + every - 1) / every));
}

}  // namespace npsee::render
