#include "app/render/model_pass.h"

#include "app/gl/state.h"
#include "app/gl/vertices.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace npsee::render {
namespace {

struct Axes {
  Vec3 right, up, back;
};

/// Turned to the right by `turn`, then the nose raised by `raise`.
Axes turned(const Axes& axes, double turn_rad, double raise_rad) {
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  const Vec3 right = c * axes.right + s * axes.back;
  const Vec3 back = c * axes.back - s * axes.right;
  const double cr = std::cos(raise_rad), sr = std::sin(raise_rad);
  return {right, cr * axes.up + sr * back, cr * back - sr * axes.up};
}

}  // namespace

Expected<ModelPass> ModelPass::create() {
  ModelPass pass;
  auto program = gl::Program::fromFiles("model.vert", "model.frag");
  if (!program) return tl::unexpected<Error>(program.error());
  pass.program_ = std::move(*program);
  auto models = loadShippedModels();
  if (!models) return tl::unexpected<Error>(models.error());
  pass.models_ = std::move(*models);
  std::vector<Model::Vertex> all;
  for (const Model& model : pass.models_) {
    pass.first_.push_back(all.size());
    all.insert(all.end(), model.vertices.begin(), model.vertices.end());
  }
  pass.attributes_ = gl::VertexArray::make();
  pass.vertices_ = gl::Buffer::make();
  pass.instances_ = gl::Buffer::make();
  glBindVertexArray(pass.attributes_.name());
  gl::upload(GL_ARRAY_BUFFER, pass.vertices_, all, GL_STATIC_DRAW);
  using Vertex = Model::Vertex;
  gl::attribute(0, 3, sizeof(Vertex), offsetof(Vertex, position));
  gl::attribute(1, 3, sizeof(Vertex), offsetof(Vertex, normal));
  gl::attribute(2, 3, sizeof(Vertex), offsetof(Vertex, colour));
  gl::attribute(3, 1, sizeof(Vertex), offsetof(Vertex, paint));
  return pass;
}

std::size_t ModelPass::find(std::string_view name, std::string_view otherwise) const {
  for (const std::string_view wanted : {name, otherwise})
    for (std::size_t i = 0; i < models_.size(); ++i)
      if (models_[i].name == wanted) return i;
  return 0;
}

PartAxes axesOf(const ModelInstance& instance, const ModelPart& part) {
  const auto place = [](const Axes& by, const Vec3& p) { return p.x * by.right + p.y * by.up + p.z * by.back; };
  Axes axes{instance.right, instance.up, instance.back};
  Vec3 at;
  // What is at a pivot stays there while the axes turn.
  const auto turnAround = [&](const Vec3& pivot, double turn_rad, double raise_rad) {
    const Axes moved = turned(axes, turn_rad, raise_rad);
    at = at + instance.scale * (place(axes, pivot) - place(moved, pivot));
    axes = moved;
  };
  const bool tube = part.kind == ModelPart::Kind::tube;
  if (part.kind != ModelPart::Kind::hull) turnAround(tube ? part.carrier : part.pivot, instance.turret_rad, 0.0);
  if (tube) turnAround(part.pivot, 0.0, instance.tube_rad);
  const double s = instance.scale;
  return {s * axes.right, s * axes.up, s * axes.back, at};
}

ModelPass::Placed ModelPass::placed(const ModelInstance& instance, const ModelPart& part, const Vec3& eye) {
  const auto f = [](double v) { return static_cast<float>(v); };
  const auto [r, u, b, offset] = axesOf(instance, part);
  const Vec3 at = instance.at_m - eye + offset;
  return {{f(r.x), f(u.x), f(b.x), f(at.x), f(r.y), f(u.y), f(b.y), f(at.y), f(r.z), f(u.z), f(b.z), f(at.z)},
          {f(instance.body.r), f(instance.body.g), f(instance.body.b), 1.0f},
          {f(instance.accent.r), f(instance.accent.g), f(instance.accent.b), f(instance.burnt)}};
}

void ModelPass::draw(const std::vector<ModelInstance>& instances, const Vec3& eye, const View& view, const MissionLight& light) {
  gl::drawSolid();
  program_.use();
  setView(program_, view);
  setLight(program_, light, eye);
  glBindVertexArray(attributes_.name());
  for (std::size_t m = 0; m < models_.size(); ++m)
    for (const ModelPart& part : models_[m].parts) {
      scratch_.clear();
      for (const ModelInstance& instance : instances)
        if (instance.model == m) scratch_.push_back(placed(instance, part, eye));
      if (scratch_.empty()) break;
      gl::upload(GL_ARRAY_BUFFER, instances_, scratch_, GL_STREAM_DRAW);
      for (unsigned row = 0; row < 3; ++row) gl::attribute(4 + row, 4, sizeof(Placed), offsetof(Placed, rows) + row * 4 * sizeof(float), 1);
      gl::attribute(7, 4, sizeof(Placed), offsetof(Placed, body), 1);
      gl::attribute(8, 4, sizeof(Placed), offsetof(Placed, accent), 1);
      glDrawArraysInstanced(GL_TRIANGLES, static_cast<GLint>(first_[m] + part.first), static_cast<GLsizei>(part.count), static_cast<GLsizei>(scratch_.size()));
    }
}

}  // namespace npsee::render
