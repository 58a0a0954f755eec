#include "app/render/overlay_pass.h"

#include <cstddef>

namespace npsee::render {
namespace {

void attribute(unsigned location, int components, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride), reinterpret_cast<const void*>(offset));
}

template <class Item>
void fill(const gl::Buffer& buffer, const std::vector<Item>& items) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(items.size() * sizeof(Item)), items.data(), GL_STREAM_DRAW);
}

void blended() {
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_CULL_FACE);
  glDisable(GL_CLIP_DISTANCE0);
  glDepthMask(GL_FALSE);
}

}  // namespace

Expected<OverlayPass> OverlayPass::create() {
  OverlayPass pass;
  const auto load = [](gl::Program& slot, const char* vertex, const char* fragment) -> Expected<void> {
    auto program = gl::Program::fromFiles(vertex, fragment);
    if (!program) return tl::unexpected<Error>(program.error());
    slot = std::move(*program);
    return {};
  };
  for (const auto& loaded : {load(pass.stroke_, "template_stroke.vert", "template_stroke.frag"), load(pass.area_, "area.vert", "area.frag"), load(pass.mask_, "fullscreen.vert", "mask.frag")})
    if (!loaded) return tl::unexpected<Error>(loaded.error());
  pass.nothing_ = gl::VertexArray::make();
  pass.stroke_attributes_ = gl::VertexArray::make();
  pass.stroke_vertices_ = gl::Buffer::make();
  glBindVertexArray(pass.stroke_attributes_.name());
  glBindBuffer(GL_ARRAY_BUFFER, pass.stroke_vertices_.name());
  attribute(0, 4, sizeof(StrokeVertex), offsetof(StrokeVertex, clip));
  attribute(1, 2, sizeof(StrokeVertex), offsetof(StrokeVertex, offset));
  attribute(2, 1, sizeof(StrokeVertex), offsetof(StrokeVertex, half_width));
  attribute(3, 2, sizeof(StrokeVertex), offsetof(StrokeVertex, dash_px));
  attribute(4, 4, sizeof(StrokeVertex), offsetof(StrokeVertex, colour));
  attribute(5, 1, sizeof(StrokeVertex), offsetof(StrokeVertex, hidden));
  pass.area_attributes_ = gl::VertexArray::make();
  pass.area_vertices_ = gl::Buffer::make();
  glBindVertexArray(pass.area_attributes_.name());
  glBindBuffer(GL_ARRAY_BUFFER, pass.area_vertices_.name());
  attribute(0, 3, sizeof(AreaVertex), offsetof(AreaVertex, place));
  attribute(1, 4, sizeof(AreaVertex), offsetof(AreaVertex, colour));
  return pass;
}

void OverlayPass::drawAreas(const std::vector<AreaVertex>& vertices, const View& view, double extinction_per_m) {
  if (vertices.empty()) return;
  fill(area_vertices_, vertices);
  blended();
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  area_.use();
  setView(area_, view);
  area_.set("u_extinction", static_cast<float>(extinction_per_m));
  glBindVertexArray(area_attributes_.name());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
}

void OverlayPass::drawStrokes(const std::vector<StrokeVertex>& vertices, bool over_all) {
  if (vertices.empty()) return;
  fill(stroke_vertices_, vertices);
  blended();
  stroke_.use();
  glBindVertexArray(stroke_attributes_.name());
  if (over_all) glDisable(GL_DEPTH_TEST);
  else glEnable(GL_DEPTH_TEST);
  // What the ground hides is drawn first, faintly; then what it does not.
  for (const bool behind : {true, false}) {
    if (over_all && behind) continue;
    glDepthFunc(behind ? GL_GREATER : GL_LEQUAL);
    stroke_.set("u_behind", behind ? 1.0f : 0.0f);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
  }
}

void OverlayPass::drawMask(int width, int height, double radius_px) {
  blended();
  glDisable(GL_DEPTH_TEST);
  mask_.use();
  mask_.set("u_depth", 0.0f);
  mask_.set("u_middle", 0.5f * static_cast<float>(width), 0.5f * static_cast<float>(height));
  mask_.set("u_radius", static_cast<float>(radius_px));
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace npsee::render
