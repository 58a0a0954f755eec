#include "app/render/shadow_pass.h"

namespace npsee::render {
namespace {

// Where there are more pieces than this, their shadows run into each other and cost as much as the pieces themselves; every second,
// third ... one then stands for its neighbours.
constexpr std::size_t kMostShadows = 20'000;

}  // namespace

Expected<ShadowPass> ShadowPass::create() {
  auto program = gl::Program::fromFiles("shadow.vert", "shadow.frag");
  if (!program) return tl::unexpected<Error>(program.error());
  ShadowPass pass;
  pass.program_ = std::move(*program);
  pass.attributes_ = gl::VertexArray::make();
  return pass;
}

void ShadowPass::draw(const View& view, const FrameUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, double strength) const {
  // On a plane drawn before everything else no depth is needed; a terrain's hills hide shadows.
  if (ground.shadow_nearer > 0.0) glEnable(GL_DEPTH_TEST);
  else glDisable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_CULL_FACE);
  glDisable(GL_CLIP_DISTANCE0);
  program_.use();
  setView(program_, view);
  program_.set("u_ground", static_cast<float>(ground.height_m));
  program_.set("u_slope", static_cast<float>(ground.slope_x), static_cast<float>(ground.slope_z));
  program_.set("u_nearer", static_cast<float>(ground.shadow_nearer));
  program_.set("u_strength", static_cast<float>(strength));
  // The sun is half a degree wide: 0.009 from one edge of its disc to the other.
  program_.set("u_spread", 0.010f);
  glBindVertexArray(attributes_.name());
  const std::size_t every = (count + kMostShadows - 1) / kMostShadows;
  particles.bind(first, false, every);
  glDrawArraysInstanced(GL_TRIANGLES, 0, 3, static_cast<GLsizei>((count + every - 1) / every));
}

}  // namespace npsee::render
