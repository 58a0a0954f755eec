#include "app/render/pieces_pass.h"

#include "app/gl/state.h"
#include "app/gl/vertices.h"
#include "app/render/frame_particles.h"
#include "app/render/heat.h"
#include "app/render/solid_pass.h"

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

/// Models kept in buffers: those that a picture of a mission holds at most, drawn in the same order each time.
constexpr std::size_t kMostLoaded = kMostInPieces;

struct PieceVertex {
  float position[3], normal[3], colour[4], piece;
};

float asFloat(double v) { return static_cast<float>(v); }

void addPiece(const Piece& piece, std::size_t number, const std::vector<SolidModel::Material>& materials, std::vector<PieceVertex>& out) {
  for (const Facet& facet : piece.solid.facets) {
    const Vec3 a = piece.solid.points[facet.corners[0]], b = piece.solid.points[facet.corners[1]], c = piece.solid.points[facet.corners[2]];
    const Vec3 across = cross(b - a, c - a);
    const double size = length(across);
    if (!(size > 1e-14)) continue;
    const Vec3 n = (1.0 / size) * across;
    PieceVertex vertex{{}, {asFloat(n.x), asFloat(n.y), asFloat(n.z)}, {0.0f, 0.0f, 0.0f, 2.0f}, static_cast<float>(number)};
    if (facet.material < materials.size()) {
      const SolidModel::Material& material = materials[facet.material];
      const float values[4] = {asFloat(material.colour.r), asFloat(material.colour.g), asFloat(material.colour.b), material.paint == FacetPaint::own ? 0.0f : material.paint == FacetPaint::layer ? 1.0f : 2.0f};
      std::copy(values, values + 4, vertex.colour);
    }
    for (const Vec3& p : {a, b, c}) {
      const float place[3] = {asFloat(p.x), asFloat(p.y), asFloat(p.z)};
      std::copy(place, place + 3, vertex.position);
      out.push_back(vertex);
    }
  }
}

/// How far a turned piece reaches down from its centre, at scale 1. `turn` is body to world.
double reachDown(const Piece& piece, const float (&turn)[4]) {
  const double x = static_cast<double>(turn[0]), y = static_cast<double>(turn[1]), z = static_cast<double>(turn[2]), w = static_cast<double>(turn[3]);
  const Vec3 up{2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)};
  double reach = 0.0;
  for (const Vec3& point : piece.solid.points) reach = std::max(reach, -dot(up, point));
  return reach;
}

}  // namespace

Expected<PiecesPass> PiecesPass::create(ParticleOutput output) {
  PiecesPass pass;
  if (auto done = pass.program_.load("pieces.vert", output == ParticleOutput::surface ? "solid_surface.frag" : "solid.frag"); !done) return tl::unexpected<Error>(done.error());
  if (output == ParticleOutput::light)
    if (auto done = pass.shadow_.load("pieces_shadow.vert", "solid.frag"); !done) return tl::unexpected<Error>(done.error());
  pass.program_.use();
  setEmitted(pass.program_);
  pass.states_ = gl::Buffer::make();
  pass.states_texture_ = gl::Texture::make();
  return pass;
}

const PiecesPass::Loaded& PiecesPass::loaded(const std::shared_ptr<const Fragments>& pieces) {
  if (const auto found = std::ranges::find(loaded_, pieces, &Loaded::pieces); found != loaded_.end()) {
    loaded_.splice(loaded_.begin(), loaded_, found);
    return loaded_.front();
  }
  std::vector<PieceVertex> vertices;
  Loaded& out = loaded_.emplace_front();
  out.pieces = pieces;
  for (std::size_t i = 0; i < pieces->pieces.size(); ++i) {
    out.first.push_back(static_cast<GLint>(vertices.size()));
    addPiece(pieces->pieces[i], i, pieces->materials, vertices);
  }
  out.first.push_back(static_cast<GLint>(vertices.size()));
  out.attributes = gl::VertexArray::make();
  out.vertices = gl::Buffer::make();
  glBindVertexArray(out.attributes.name());
  gl::upload(GL_ARRAY_BUFFER, out.vertices, vertices, GL_STATIC_DRAW);
  gl::attribute(0, 3, sizeof(PieceVertex), offsetof(PieceVertex, position));
  gl::attribute(1, 3, sizeof(PieceVertex), offsetof(PieceVertex, normal));
  gl::attribute(2, 4, sizeof(PieceVertex), offsetof(PieceVertex, colour));
  gl::attribute(3, 1, sizeof(PieceVertex), offsetof(PieceVertex, piece));
  if (loaded_.size() > kMostLoaded) loaded_.pop_back();
  return out;
}

void PiecesPass::fill(const Frame& frame, std::size_t first, std::size_t count, const LayerSpan& layer, const GroundLevel& ground) {
  scratch_.clear();
  const bool turned = frame.qw.size() >= frame.count, moving = frame.vx.size() >= frame.count;
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t i = first + n;
    const Piece& piece = layer.pieces->pieces[n];
    State state{{frame.x[i], frame.y[i], frame.z[i]}, piece.radius_m > 0.0 ? asFloat(static_cast<double>(frame.size[i]) / (2.0 * piece.radius_m)) : 0.0f,
                {frame.r[i], frame.g[i], frame.b[i], frame.size[i] > 0.0f ? frame.a[i] : 0.0f}, {0.0f, 0.0f, 0.0f, 1.0f}, {}, asFloat(temperatureAt(layer, frame, i))};
    if (turned) {
      const float q[4] = {frame.qx[i], frame.qy[i], frame.qz[i], frame.qw[i]};
      std::copy(q, q + 4, state.turn);
    }
    if (moving) {
      const float v[3] = {frame.vx[i], frame.vy[i], frame.vz[i]};
      std::copy(v, v + 3, state.velocity);
    }
    if (state.scale > 0.0f) state.place[1] += liftOf(piece, state, ground);
    scratch_.push_back(state);
  }
}

float PiecesPass::liftOf(const Piece& piece, const State& state, const GroundLevel& ground) {
  const double x = static_cast<double>(state.place[0]), y = static_cast<double>(state.place[1]), z = static_cast<double>(state.place[2]);
  const double above = y - ground.height_m - ground.slope_x * x - ground.slope_z * z;
  const double scale = static_cast<double>(state.scale);
  if (std::fabs(above) >= piece.radius_m * scale) return 0.0f;
  const double reach = scale * reachDown(piece, state.turn);
  // What sinks through the ground (no collision) loses its lift as it goes, without a jump.
  return asFloat(above >= 0.0 ? std::max(reach - above, 0.0) : std::max(reach + above, 0.0));
}

void PiecesPass::upload() {
  glBindBuffer(GL_TEXTURE_BUFFER, states_.name());
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(scratch_.size() * sizeof(State)), scratch_.data(), GL_STREAM_DRAW);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_BUFFER, states_texture_.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, states_.name());
}

void PiecesPass::prepare(const gl::Program& program, const View& view, const GroundLevel& ground) const {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  program.use();
  setView(program, view);
  setGround(program, view, ground);
  program.set("u_states", 0);
  program.set("u_facets", 1.0f);
  program.set("u_state", -1);
}

void PiecesPass::drawModels(const gl::Program& program, const Frame& frame, const LayerSpan& layer, const GroundLevel& ground) {
  const Loaded& model = loaded(layer.pieces);
  const std::size_t each = layer.pieces->pieces.size(), end = endOf(layer, frame);
  for (std::size_t first = layer.first; first < end; first += each) {
    const std::size_t count = std::min(each, end - first);
    fill(frame, first, count, layer, ground);
    upload();
    program.use();
    glBindVertexArray(model.attributes.name());
    glDrawArrays(GL_TRIANGLES, 0, model.first[count]);
  }
}

void PiecesPass::drawOpaque(const View& view, const Frame& frame, const LayerSpan& layer, const GroundLevel& ground) {
  prepare(program_, view, ground);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  program_.set("u_opacity", kOpaque, 2.0f);
  drawModels(program_, frame, layer, ground);
}

void PiecesPass::drawSurfaces(const View& view, const Frame& frame, const LayerSpan& layer, const GroundLevel& ground, const SurfaceFrame& surface) {
  prepare(program_, view, ground);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  program_.set("u_opacity", 0.4999f, 2.0f);
  setSurfaceFrame(program_, surface);
  drawModels(program_, frame, layer, ground);
}

void PiecesPass::drawBlended(const View& view, const std::shared_ptr<const Fragments>& pieces, std::span<const BlendedInstance> instances, const GroundLevel& ground, bool with_depth) {
  const Loaded& model = loaded(pieces);
  scratch_.clear();
  for (const BlendedInstance& instance : instances) {
    const Piece& piece = pieces->pieces[static_cast<std::size_t>(instance.kind)];
    State state{{instance.x, instance.y, instance.z}, asFloat(static_cast<double>(instance.size) / (2.0 * piece.radius_m)), {instance.r, instance.g, instance.b, instance.a}, {}, {}, instance.light.sunward};
    std::copy(instance.p, instance.p + 4, state.turn);
    state.place[1] += liftOf(piece, state, ground);
    scratch_.push_back(state);
  }
  upload();
  prepare(program_, view, ground);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(with_depth ? GL_TRUE : GL_FALSE);
  program_.set("u_opacity", 0.0f, 2.0f);
  glBindVertexArray(model.attributes.name());
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const auto number = static_cast<std::size_t>(instances[i].kind);
    program_.set("u_state", static_cast<int>(i));
    glDrawArrays(GL_TRIANGLES, model.first[number], model.first[number + 1] - model.first[number]);
  }
}

void PiecesPass::drawShadows(const View& view, const Frame& frame, const LayerSpan& layer, const GroundLevel& ground, double strength) {
  prepare(shadow_, view, ground);
  glDisable(GL_CLIP_DISTANCE0);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glBlendEquation(GL_MAX);
  shadow_.set("u_strength", static_cast<float>(strength));
  drawModels(shadow_, frame, layer, ground);
  glBlendEquation(GL_FUNC_ADD);
}

}  // namespace npsee::render
