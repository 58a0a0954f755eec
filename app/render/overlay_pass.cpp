#include "app/render/overlay_pass.h"

#include "app/gl/state.h"
#include "app/gl/vertices.h"

#include <cstddef>

namespace npsee::render {

Expected<OverlayPass> OverlayPass::create() {
  OverlayPass pass;
  for (const auto& loaded : {pass.area_.load("area.vert", "area.frag"), pass.mask_.load("fullscreen.vert", "mask.frag")})
    if (!loaded) return tl::unexpected<Error>(loaded.error());
  pass.nothing_ = gl::VertexArray::make();
  pass.area_attributes_ = gl::VertexArray::make();
  pass.area_vertices_ = gl::Buffer::make();
  glBindVertexArray(pass.area_attributes_.name());
  glBindBuffer(GL_ARRAY_BUFFER, pass.area_vertices_.name());
  gl::attribute(0, 3, sizeof(AreaVertex), offsetof(AreaVertex, place));
  gl::attribute(1, 4, sizeof(AreaVertex), offsetof(AreaVertex, colour));
  return pass;
}

void OverlayPass::drawAreas(const std::vector<AreaVertex>& vertices, const View& view, double extinction_per_m) {
  if (vertices.empty()) return;
  gl::upload(GL_ARRAY_BUFFER, area_vertices_, vertices, GL_STREAM_DRAW);
  gl::blendOver();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  area_.use();
  setView(area_, view);
  area_.set("u_extinction", static_cast<float>(extinction_per_m));
  glBindVertexArray(area_attributes_.name());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
}

void OverlayPass::drawMask(int width, int height, double radius_px) {
  gl::blendOver();
  glDisable(GL_DEPTH_TEST);
  mask_.use();
  mask_.set("u_depth", 0.0f);
  mask_.set("u_middle", 0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height));
  mask_.set("u_radius", static_cast<float>(radius_px));
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace npsee::render
