#include "app/render/backdrop_pass.h"

namespace npsee::render {

Expected<BackdropPass> BackdropPass::create() {
  BackdropPass pass;
  auto ground = gl::Program::fromFiles("ground.vert", "ground.frag");
  if (!ground) return tl::unexpected<Error>(ground.error());
  auto sky = gl::Program::fromFiles("fullscreen.vert", "sky.frag");
  if (!sky) return tl::unexpected<Error>(sky.error());
  pass.ground_ = std::move(*ground);
  pass.sky_ = std::move(*sky);
  pass.nothing_ = gl::VertexArray::make();
  return pass;
}

void BackdropPass::drawGround(const View& view, double height_m, const Colour& colour, bool grid) const {
  // Haze grows with the scene, so that a far camera still sees its effect clearly.
  const double haze_m = 250.0 + 5.0 * view.distance_m;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  ground_.use();
  setView(ground_, view);
  setVec3(ground_, "u_centre", {view.eye.x, height_m, view.eye.z});
  ground_.set("u_reach", static_cast<float>(14.0 * haze_m));
  ground_.set("u_height", static_cast<float>(height_m));
  setVec3(ground_, "u_ground", {colour.r, colour.g, colour.b});
  ground_.set("u_grid", grid ? 1.0f : 0.0f);
  ground_.set("u_haze", static_cast<float>(haze_m));
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void BackdropPass::drawSky(const View& view) const {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  sky_.use();
  setView(sky_, view);
  sky_.set("u_depth", 1.0f);
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace npsee::render
