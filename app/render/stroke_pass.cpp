#include "app/render/stroke_pass.h"

#include "app/gl/state.h"
#include "app/gl/vertices.h"

#include <cstddef>

namespace npsee::render {

Expected<StrokePass> StrokePass::create() {
  StrokePass pass;
  if (auto loaded = pass.program_.load("stroke.vert", "stroke.frag"); !loaded) return tl::unexpected<Error>(loaded.error());
  pass.attributes_ = gl::VertexArray::make();
  pass.vertices_ = gl::Buffer::make();
  glBindVertexArray(pass.attributes_.name());
  glBindBuffer(GL_ARRAY_BUFFER, pass.vertices_.name());
  gl::attribute(0, 4, sizeof(StrokeVertex), offsetof(StrokeVertex, clip));
  gl::attribute(1, 2, sizeof(StrokeVertex), offsetof(StrokeVertex, offset));
  gl::attribute(2, 1, sizeof(StrokeVertex), offsetof(StrokeVertex, half_width));
  gl::attribute(3, 2, sizeof(StrokeVertex), offsetof(StrokeVertex, dash_px));
  gl::attribute(4, 4, sizeof(StrokeVertex), offsetof(StrokeVertex, colour));
  gl::attribute(5, 1, sizeof(StrokeVertex), offsetof(StrokeVertex, hidden));
  glBindVertexArray(0);
  return pass;
}

void StrokePass::draw(const std::vector<StrokeVertex>& triangles, Hiding hiding) {
  if (triangles.empty()) return;
  gl::upload(GL_ARRAY_BUFFER, vertices_, triangles, GL_STREAM_DRAW);
  gl::blendOver();
  program_.use();
  glBindVertexArray(attributes_.name());
  const auto pass = [&](bool behind) {
    glDepthFunc(behind ? GL_GREATER : GL_LEQUAL);
    program_.set("u_behind", behind ? 1.0f : 0.0f);
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles.size()));
  };
  if (hiding == Hiding::none) {
    glDisable(GL_DEPTH_TEST);
    pass(false);
  } else {
    // The depth divides each stroke into what lies behind something and what does not.
    glEnable(GL_DEPTH_TEST);
    pass(true);
    pass(false);
  }
  glDepthMask(GL_TRUE);
  glBindVertexArray(0);
}

}  // namespace npsee::render
