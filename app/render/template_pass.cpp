#include "app/render/template_pass.h"

#include "app/gl/vertices.h"

#include <cstddef>

namespace npsee::render {
namespace {

/// A little under the shapes' feet, which would flicker through it.
constexpr double kGroundLevel = -0.006;
constexpr double kGroundReach = 1.7;

void setVector(const gl::Program& program, const char* uniform, const Vec3& v) {
  program.set(uniform, static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
}

void setColour(const gl::Program& program, const char* uniform, const Colour& c) { setVector(program, uniform, {c.r, c.g, c.b}); }

void setCamera(const gl::Program& program, const TemplateCamera& camera) {
  float matrix[16];
  const auto values = camera.viewProjection();
  std::copy(values.begin(), values.end(), matrix);
  program.setMatrix("u_view_projection", matrix);
}

}  // namespace

Expected<TemplatePass> TemplatePass::create() {
  TemplatePass pass;
  for (const auto& loaded : {pass.mesh_.load("template_mesh.vert", "template_mesh.frag"), pass.ground_.load("template_ground.vert", "template_ground.frag")})
    if (!loaded) return tl::unexpected<Error>(loaded.error());
  auto strokes = StrokePass::create();
  if (!strokes) return tl::unexpected<Error>(strokes.error());
  pass.strokes_ = std::move(*strokes);

  pass.nothing_ = gl::VertexArray::make();
  pass.mesh_attributes_ = gl::VertexArray::make();
  pass.mesh_vertices_ = gl::Buffer::make();
  pass.mesh_indices_ = gl::Buffer::make();
  glBindVertexArray(pass.mesh_attributes_.name());
  glBindBuffer(GL_ARRAY_BUFFER, pass.mesh_vertices_.name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, pass.mesh_indices_.name());
  using Vertex = TemplateMesh::Vertex;
  gl::attribute(0, 3, sizeof(Vertex), offsetof(Vertex, position));
  gl::attribute(1, 3, sizeof(Vertex), offsetof(Vertex, normal));
  glBindVertexArray(0);
  return pass;
}

const Colour* TemplatePass::background(const TemplateScene& scene) {
  switch (scene.background.kind) {
    case Background::Kind::sky: return &kTemplateBackground;
    case Background::Kind::colour: return &scene.background.colour;
    case Background::Kind::transparent: break;
  }
  return nullptr;
}

void TemplatePass::drawMesh(const TemplateDrawing& drawing, const TemplateCamera& camera) const {
  gl::upload(GL_ARRAY_BUFFER, mesh_vertices_, drawing.mesh.vertices, GL_STREAM_DRAW);
  glBindVertexArray(mesh_attributes_.name());
  gl::upload(GL_ELEMENT_ARRAY_BUFFER, mesh_indices_, drawing.mesh.triangles, GL_STREAM_DRAW);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  const GLboolean colours = drawing.mesh_visible ? GL_TRUE : GL_FALSE;
  glColorMask(colours, colours, colours, colours);
  mesh_.use();
  setCamera(mesh_, camera);
  setVector(mesh_, "u_eye", camera.eye());
  setVector(mesh_, "u_light", camera.lamp());
  setColour(mesh_, "u_colour", drawing.flat ? drawing.palette.facet : drawing.palette.surface);
  mesh_.set("u_quiet", drawing.flat ? 1.0f : 0.0f);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(drawing.mesh.triangles.size()), GL_UNSIGNED_INT, nullptr);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void TemplatePass::drawGround(const TemplateDrawing& drawing, const TemplateCamera& camera, double scale) const {
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_FALSE);
  ground_.use();
  setCamera(ground_, camera);
  ground_.set("u_reach", static_cast<float>(kGroundReach));
  ground_.set("u_level", static_cast<float>(kGroundLevel));
  ground_.set("u_pixels", static_cast<float>(scale));
  ground_.set("u_region", static_cast<float>(drawing.region_x), static_cast<float>(drawing.region_z));
  setColour(ground_, "u_line", drawing.palette.dim);
  setColour(ground_, "u_tint", drawing.palette.geometry);
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDepthMask(GL_TRUE);
}

void TemplatePass::draw(const TemplateScene& scene, int width, int height) {
  const TemplateShape shape = templateShape(*scene.preset, scene.layer);
  const TemplateCamera camera(shape, scene.yaw_rad, scene.pitch_rad, width, height);
  const TemplateDrawing drawing = drawingOf(shape, scene, camera);
  // A surface that is not seen must not cut a hole into the base plane.
  if (!drawing.mesh_visible) drawGround(drawing, camera, scene.scale);
  drawMesh(drawing, camera);
  if (drawing.mesh_visible) drawGround(drawing, camera, scene.scale);
  strokes_.draw(strokeTriangles(drawing.strokes, camera, width, height), StrokePass::Hiding::by_depth);
}

}  // namespace npsee::render
