#include "app/render/backdrop_pass.h"

#include "app/gl/state.h"
#include "app/render/hour_light.h"

namespace npsee::render {

Expected<BackdropPass> BackdropPass::create() {
  auto program = gl::Program::fromFiles("fullscreen.vert", "backdrop.frag");
  if (!program) return tl::unexpected<Error>(program.error());
  BackdropPass pass;
  pass.program_ = std::move(*program);
  pass.nothing_ = gl::VertexArray::make();
  return pass;
}

void BackdropPass::draw(const Target& target, const Backdrop& backdrop) const {
  target.bindBackdrop();
  gl::drawPlainly();
  program_.use();
  setView(program_, backdrop.view);
  program_.set("u_depth", 0.0f);
  program_.set("u_height", static_cast<float>(backdrop.ground_m));
  setVec3(program_, "u_ground", {backdrop.ground_colour.r, backdrop.ground_colour.g, backdrop.ground_colour.b});
  setHour(program_, backdrop.sky);
  program_.set("u_grid", backdrop.grid ? 1.0f : 0.0f);
  // Haze grows with the scene, so that a far camera still sees its effect clearly.
  program_.set("u_haze", static_cast<float>(250.0 + 5.0 * backdrop.view.distance_m));
  program_.set("u_exposure", static_cast<float>(backdrop.exposure));
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace npsee::render
