#pragma once

#include "app/render/effect_tiles.h"
#include "app/render/finish_pass.h"

namespace npsee::render {

/// Pieces drawn with several samples a pixel in an effect that has one, since what is blended costs as many times as there are samples and has no
/// edges to smooth. A pixel that a piece covers whole goes into the effect with its depth. What covers a pixel in part is kept, and laid over the
/// effect between what is blended behind it and before it.
class PieceEdges {
 public:
  static Expected<PieceEdges> create();

  /// Binds the target's samples, emptied where the pieces are.
  Expected<void> begin(Target& target, const FinishPass& finish, const PieceSpread& pieces);
  /// From the samples into the target's effect, which is bound from then on.
  void settle(const Target& target, const View& view) const;
  /// Lays what was kept over the effect, which is bound: all from `nearest_m` to just before `farthest_m` along the view.
  void lay(const Target& target, const PieceSpread& pieces, const View& view, double nearest_m, double farthest_m);

 private:
  gl::Program settle_, lay_;
  TileMask mask_;
  TileMesh tiles_, laid_;
};

/// Pieces drawn and settled, for what is blended among them.
struct PiecesDrawn {
  PieceEdges& edges;
  const Target& target;
  const PieceSpread& spread;
};

}  // namespace npsee::render
