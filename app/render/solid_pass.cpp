#include "app/render/solid_pass.h"

#include "app/gl/vertices.h"
#include "app/render/heat.h"

#include <string>

namespace npsee::render {
namespace {

void uploadMesh(const Mesh& mesh, const gl::Buffer& vertices, const gl::Buffer& indices) {
  gl::upload(GL_ARRAY_BUFFER, vertices, mesh.vertices, GL_STATIC_DRAW);
  gl::attribute(kMeshPosition, 3, sizeof(Mesh::Vertex), offsetof(Mesh::Vertex, position));
  gl::attribute(kMeshNormal, 3, sizeof(Mesh::Vertex), offsetof(Mesh::Vertex, normal));
  gl::upload(GL_ELEMENT_ARRAY_BUFFER, indices, mesh.indices, GL_STATIC_DRAW);
}

void drawInstances(const Mesh& mesh, std::size_t count) {
  glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_SHORT, nullptr, static_cast<GLsizei>(count));
}

}  // namespace

Expected<SolidPass> SolidPass::create(ParticleOutput output) {
  auto program = gl::Program::fromFiles("solid.vert", output == ParticleOutput::surface ? "solid_surface.frag" : "solid.frag");
  if (!program) return tl::unexpected<Error>(program.error());
  SolidPass pass;
  pass.program_ = std::move(*program);
  pass.program_.use();
  setEmitted(pass.program_);
  return pass;
}

SolidPass::LoadedMesh& SolidPass::loaded(Form form) {
  LoadedMesh& out = meshes_.at(static_cast<std::size_t>(form));
  if (out.attributes) return out;
  out.mesh = meshOf(form);
  out.attributes = gl::VertexArray::make();
  out.vertices = gl::Buffer::make();
  out.indices = gl::Buffer::make();
  glBindVertexArray(out.attributes.name());
  uploadMesh(out.mesh, out.vertices, out.indices);
  return out;
}

void SolidPass::prepare(const View& view, const LoadedMesh& loaded, const GroundLevel& ground) const {
  const Mesh& mesh = loaded.mesh;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  if (mesh.two_sided) glDisable(GL_CULL_FACE);
  else glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  program_.use();
  setView(program_, view);
  setGround(program_, view, ground);
  program_.set("u_hull_count", static_cast<int>(mesh.hull.size()));
  for (std::size_t i = 0; i < mesh.hull.size(); ++i) setVec3(program_, ("u_hull[" + std::to_string(i) + "]").c_str(), mesh.hull[i]);
  program_.set("u_lift_limit", static_cast<float>(mesh.lift_limit));
  program_.set("u_two_sided", mesh.two_sided ? 1.0f : 0.0f);
  program_.set("u_facets", mesh.facets ? 1.0f : 0.0f);
  glBindVertexArray(loaded.attributes.name());
}

void SolidPass::drawOpaque(const View& view, Form form, const FrameUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground) {
  const LoadedMesh& mesh = loaded(form);
  prepare(view, mesh, ground);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  program_.set("u_opacity", kOpaque, 2.0f);
  particles.bind(first, true);
  drawInstances(mesh.mesh, count);
}

void SolidPass::drawSurfaces(const View& view, Form form, const FrameUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, const SurfaceFrame& frame) {
  const LoadedMesh& mesh = loaded(form);
  prepare(view, mesh, ground);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  program_.set("u_opacity", 0.4999f, 2.0f);
  setSurfaceFrame(program_, frame);
  particles.bind(first, true);
  particles.bindVelocities(first);
  drawInstances(mesh.mesh, count);
}

void SolidPass::drawBlended(const View& view, Form form, const BlendedUpload& particles, std::size_t first, std::size_t count, const GroundLevel& ground, bool with_depth) {
  const LoadedMesh& mesh = loaded(form);
  prepare(view, mesh, ground);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(with_depth ? GL_TRUE : GL_FALSE);
  program_.set("u_opacity", 0.0f, 2.0f);
  particles.bind(first);
  drawInstances(mesh.mesh, count);
}

}  // namespace npsee::render
