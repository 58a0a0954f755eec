#pragma once

#include "app/render/frame_upload.h"
#include "app/render/ground_level.h"
#include "app/render/particle_output.h"
#include "app/render/view.h"

#include <npsee/explosion.h>

#include <list>
#include <memory>
#include <span>
#include <vector>

namespace npsee::render {

/// Most vehicles of a mission that are drawn in pieces in one picture: the nearest.
inline constexpr std::size_t kMostInPieces = 200;

/// Models that have come apart: the pieces of one lie in one buffer and are drawn in one call, facets with the model's colours and dark
/// where they were torn. A piece whose underside is in the ground is lifted onto it.
class PiecesPass {
 public:
  static Expected<PiecesPass> create(ParticleOutput output = ParticleOutput::light);

  /// The opaque pieces of a layer of the frame.
  void drawOpaque(const View& view, const Frame& frame, const LayerSpan& layer, const GroundLevel& ground);
  /// Depth and motion of those that cover at least half of what is behind them; needs a pass made for surfaces.
  void drawSurfaces(const View& view, const Frame& frame, const LayerSpan& layer, const GroundLevel& ground, const SurfaceFrame& surface);
  /// Pieces in the order given; the `kind` of an instance is the number of its piece.
  void drawBlended(const View& view, const std::shared_ptr<const Fragments>& pieces, std::span<const BlendedInstance> instances, const GroundLevel& ground, bool with_depth);
  /// Their shadows on the ground into a picture that holds nothing else yet: where shadows overlap it is no darker.
  void drawShadows(const View& view, const Frame& frame, const LayerSpan& layer, const GroundLevel& ground, double strength);

 private:
  /// As the shader reads it.
  struct State {
    float place[3], scale;
    float colour[4];
    float turn[4];
    float velocity[3], temperature;
  };
  struct Loaded {
    std::shared_ptr<const Fragments> pieces;  ///< held, so that its address names nothing else
    gl::VertexArray attributes;
    gl::Buffer vertices;
    std::vector<GLint> first;                 ///< vertex of each piece; one more at the end
  };
  const Loaded& loaded(const std::shared_ptr<const Fragments>& pieces);
  /// The states of one model's pieces, from particle `first` on.
  void fill(const Frame& frame, std::size_t first, std::size_t count, const LayerSpan& layer, const GroundLevel& ground);
  /// How far the piece is raised so that its underside is on the ground, m.
  static float liftOf(const Piece& piece, const State& state, const GroundLevel& ground);
  void upload();
  void prepare(const gl::Program& program, const View& view, const GroundLevel& ground) const;
  /// Every model of a layer in turn: fills, uploads and draws.
  void drawModels(const gl::Program& program, const Frame& frame, const LayerSpan& layer, const GroundLevel& ground);

  gl::Program program_, shadow_;
  std::list<Loaded> loaded_;  // the one drawn last first
  gl::Buffer states_;
  gl::Texture states_texture_;
  std::vector<State> scratch_;
};

}  // namespace npsee::render
