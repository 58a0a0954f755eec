#pragma once

#include "app/render/blend_order.h"
#include "app/render/glow_pass.h"
#include "app/render/piece_edges.h"
#include "app/render/pieces_pass.h"
#include "app/render/smoke_shade.h"
#include "app/render/smoke_shadow_pass.h"
#include "app/render/scorch_pass.h"
#include "app/render/shadow_pass.h"
#include "app/render/shock_pass.h"
#include "app/render/soft_pass.h"
#include "app/render/solid_pass.h"

#include <optional>
#include <span>

namespace npsee::render {

/// The passes that draw an explosion's particles into the bound framebuffer, in this order: what lies on the ground (outlines of shadows, burnt
/// patches under them, other shadows, light, blast fronts), opaque forms, then what is blended, from back to front.
class EffectPasses {
 public:
  static Expected<EffectPasses> create();

  /// Whether clouds are drawn with all their noise, or for a draft.
  void setDetail(bool detail) { detail_ = detail; }
  /// Hands the frame to GL; the other calls draw the frame uploaded last.
  void upload(const Frame& frame, std::span<const LayerSpan> layers) { frame_.upload(frame, layers); }
  /// Shadows of models' pieces, as outlines, into tiles that hold nothing yet; not over a terrain, where they are blobs.
  Expected<void> drawOutlines(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground);
  /// Burnt ground, which belongs to the ground: under all else, outlines too.
  Expected<void> drawScorch(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground);
  /// The other shadows: blobs under pieces, and smoke's.
  Expected<void> drawShadows(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground);
  /// The light of the ground's glow on the ground; nothing where it does not shine.
  Expected<void> drawGlow(const View& view, const GroundLevel& ground);
  /// Blast fronts: where they meet the ground, before pieces; in the air, after everything else.
  Expected<void> drawShockRings(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground);
  Expected<void> drawShockShells(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground);
  Expected<void> drawOpaque(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground);
  /// Pieces that are not opaque, with their depth: for a picture of pieces alone.
  Expected<void> drawFading(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground);
  /// All that is blended; or, where pieces have been drawn before, the soft forms, with the edges of the pieces in their places.
  Expected<void> drawBlended(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, const PiecesDrawn* pieces = nullptr);

  /// Draws depth and motion instead: of pieces that cover at least half of what is behind them, the nearest; of soft forms, blended (see
  /// shaders/soft_surface.frag).
  Expected<void> drawSolidSurfaces(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, const SurfaceFrame& surface);
  Expected<void> drawSoftSurfaces(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, const SurfaceFrame& surface);

 private:
  /// Draws the runs of the order in turn.
  Expected<void> drawRuns(const View& view, const GroundLevel& ground, bool with_depth);
  /// Instances of soft forms; those of smoke alone by themselves, where they are many.
  Expected<void> drawSoft(std::size_t first, std::size_t end, const View& view, const GroundLevel& ground);
  Expected<void> drawAmong(const PiecesDrawn& pieces, const View& view, const GroundLevel& ground);
  /// Calls draw(pass, layer, count) for each layer of a form that has particles in the frame, with the pass made.
  template <class Pass, class Draw>
  Expected<void> drawLayers(std::optional<Pass>& pass, Form form, const Frame& frame, std::span<const LayerSpan> layers, Draw draw);

  bool detail_ = true;
  SolidPass solid_;
  ShadowPass shadow_;
  // Compiled when a picture needs them: start-up time counts.
  std::optional<ScorchPass> scorch_;
  std::optional<ShockPass> shock_;
  std::optional<GlowPass> glow_;
  std::optional<SmokeShadowPass> smoke_shadow_;
  std::optional<SoftPass> soft_;
  std::optional<PiecesPass> pieces_, pieces_surfaces_;
  std::optional<SolidPass> solid_surfaces_;
  std::optional<SoftPass> soft_surfaces_;
  FrameUpload frame_;
  BlendedUpload blended_;
  BlendOrder order_;
  SmokeShade shade_;
  SmokeShadowMap shadow_map_;
};

}  // namespace npsee::render
