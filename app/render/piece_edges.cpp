#include "app/render/piece_edges.h"

#include "app/gl/state.h"

#include <algorithm>
#include <limits>

namespace npsee::render {
namespace {

/// Pixels' widths that one piece's samples in a pixel may lie apart along the view: a steep facet, not two pieces.
constexpr double kOnePiece_px = 8.0;
/// Of the tiles that pieces are in, pixels: most pieces are a few pixels large.
constexpr int kTileSide = 8;

/// 0..1 as the depth buffer holds it; 2, which nothing reaches, from infinity.
float deviceDepth(const View& view, double along_m) {
  if (!(along_m < 1e30)) return 2.0f;
  const Vec3 at = view.eye - std::max(along_m, 0.0) * view.back;
  const auto row = [&](int r) {
    const auto m = [&](int column) { return static_cast<double>(view.view_projection[4 * column + r]); };
    return m(0) * at.x + m(1) * at.y + m(2) * at.z + m(3);
  };
  const double w = row(3);
  return w > 1e-9 ? static_cast<float>(std::clamp(0.5 + 0.5 * row(2) / w, -1.0, 2.0)) : -1.0f;
}

void bindTo(int unit, GLenum kind, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(kind, texture);
  glBindSampler(static_cast<GLuint>(unit), 0);
}

}  // namespace

Expected<PieceEdges> PieceEdges::create() {
  PieceEdges out;
  if (auto done = out.settle_.load("tiles.vert", "settle.frag"); !done) return tl::unexpected<Error>(done.error());
  if (auto done = out.lay_.load("tiles.vert", "lay_edges.frag"); !done) return tl::unexpected<Error>(done.error());
  return out;
}

Expected<void> PieceEdges::begin(Target& target, const FinishPass& finish, const PieceSpread& pieces) {
  if (auto begun = target.beginPieces(); !begun) return begun;
  mask_.reset(target.width(), target.height(), kTileSide);
  pieces.mark(mask_, -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
  tiles_.upload(mask_);
  finish.clear(tiles_);
  return {};
}

void PieceEdges::settle(const Target& target, const View& view) const {
  target.bindEdges();
  gl::blendOver();
  // What is kept replaces what an earlier picture kept.
  glDisablei(GL_BLEND, 1);
  glDisablei(GL_BLEND, 2);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glDepthMask(GL_TRUE);
  settle_.use();
  settle_.set("u_samples", 0);
  settle_.set("u_depths", 1);
  settle_.set("u_one_piece", static_cast<float>(1.0 + kOnePiece_px * view.metre_per_pixel));
  bindTo(1, GL_TEXTURE_2D_MULTISAMPLE, target.sampleDepths());
  bindTo(0, GL_TEXTURE_2D_MULTISAMPLE, target.samples());
  tiles_.draw(settle_, 0.0f);
  target.bindEffect();
}

void PieceEdges::lay(const Target& target, const PieceSpread& pieces, const View& view, double nearest_m, double farthest_m) {
  mask_.reset(target.width(), target.height(), kTileSide);
  pieces.mark(mask_, nearest_m, farthest_m);
  laid_.upload(mask_);
  gl::blendOver();
  glDisable(GL_DEPTH_TEST);
  lay_.use();
  lay_.set("u_edges", 0);
  lay_.set("u_depths", 1);
  lay_.set("u_between", deviceDepth(view, nearest_m), deviceDepth(view, farthest_m));
  bindTo(1, GL_TEXTURE_2D, target.edgeDepths());
  bindTo(0, GL_TEXTURE_2D, target.edges());
  laid_.draw(lay_, 0.0f);
}

}  // namespace npsee::render
