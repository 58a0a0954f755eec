#include "app/render/effect_passes.h"

#include "app/render/frame_particles.h"
#include "app/render/make_once.h"
#include "app/render/meshes.h"

#include <algorithm>
#include <limits>

namespace npsee::render {
namespace {

/// Darkness of the shadow under a piece. Light throws none, and smoke has a map of its own.
double shadowStrength(Form form) {
  switch (form) {
    case Form::pieces: return 0.5;
    case Form::tetrahedron:
    case Form::disc:
    case Form::sphere:
    case Form::shard: return 0.62;
    case Form::smoke:
    case Form::streak:
    case Form::fire:
    case Form::flash:
    case Form::shock:
    case Form::scorch: break;
  }
  return 0.0;
}

/// Shadows of models' pieces have their outlines; over a terrain, where pictures hold more than shadows by then, they are blobs as well.
bool hasOutlines(const GroundLevel& ground) { return ground.shadow_nearer <= 0.0; }

/// Of the strengths above, which are those of the day: what comes from the sky alone throws no shadow.
double shadowShare(const GroundLevel& ground) {
  static const double day = HourLight{}.keyShare();
  return ground.hour.keyShare() / day;
}

/// Puffs of smoke in a row for which a call of their own pays.
constexpr std::size_t kLongRun = 32;
/// Most steps in which what is blended and the edges of pieces among it are drawn in turn.
constexpr std::size_t kSteps = 32;

}  // namespace

Expected<EffectPasses> EffectPasses::create() {
  EffectPasses passes;
  auto solid = SolidPass::create();
  if (!solid) return tl::unexpected<Error>(solid.error());
  auto shadow = ShadowPass::create();
  if (!shadow) return tl::unexpected<Error>(shadow.error());
  passes.solid_ = std::move(*solid);
  passes.shadow_ = std::move(*shadow);
  return passes;
}

Expected<void> EffectPasses::drawOutlines(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground) {
  if (!hasOutlines(ground)) return {};
  for (const LayerSpan& layer : layers) {
    if (!layer.pieces) continue;
    if (auto made = makeOnce(pieces_, ParticleOutput::light); !made) return made;
    pieces_->drawShadows(view, frame, layer, ground, shadowShare(ground) * shadowStrength(layer.form));
  }
  return {};
}

template <class Pass, class Draw>
Expected<void> EffectPasses::drawLayers(std::optional<Pass>& pass, Form form, const Frame& frame, std::span<const LayerSpan> layers, Draw draw) {
  for (const LayerSpan& layer : layers) {
    const std::size_t count = countOf(layer, frame);
    if (count == 0 || layer.form != form) continue;
    if (auto made = makeOnce(pass); !made) return made;
    draw(*pass, layer, count);
  }
  return {};
}

Expected<void> EffectPasses::drawScorch(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground) {
  const bool under = hasOutlines(ground) && std::ranges::any_of(layers, [](const LayerSpan& layer) { return layer.pieces != nullptr; });
  return drawLayers(scorch_, Form::scorch, frame, layers, [&](ScorchPass& pass, const LayerSpan& layer, std::size_t count) { pass.draw(view, frame_, layer.first, count, ground, under); });
}

Expected<void> EffectPasses::drawShockRings(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground) {
  return drawLayers(shock_, Form::shock, frame, layers, [&](ShockPass& pass, const LayerSpan& layer, std::size_t count) { pass.drawRings(view, frame_, layer.first, count, ground); });
}

Expected<void> EffectPasses::drawShockShells(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground) {
  return drawLayers(shock_, Form::shock, frame, layers, [&](ShockPass& pass, const LayerSpan& layer, std::size_t count) { pass.drawShells(view, frame_, layer.first, count, ground); });
}

Expected<void> EffectPasses::drawShadows(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground) {
  const double share = shadowShare(ground);
  for (const LayerSpan& layer : layers) {
    const std::size_t count = countOf(layer, frame);
    const double strength = layer.pieces && hasOutlines(ground) ? 0.0 : share * shadowStrength(layer.form);
    if (count > 0 && strength > 0.0) shadow_.draw(view, frame_, layer.first, count, ground, strength);
  }
  mapSmokeShadow(frame, layers, {ground.height_m, ground.slope_x, ground.slope_z}, ground.hour.towards_key, shadow_map_);
  if (shadow_map_.empty()) return {};
  if (auto made = makeOnce(smoke_shadow_); !made) return made;
  smoke_shadow_->draw(view, ground, ground.hour.towards_key, share, shadow_map_);
  return {};
}

Expected<void> EffectPasses::drawGlow(const View& view, const GroundLevel& ground) {
  if (!ground.glow.shines()) return {};
  if (auto made = makeOnce(glow_); !made) return made;
  glow_->draw(view, ground);
  return {};
}

Expected<void> EffectPasses::drawOpaque(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground) {
  for (const LayerSpan& layer : layers) {
    const std::size_t count = countOf(layer, frame);
    if (count == 0) continue;
    if (isSolid(layer.form)) {
      solid_.drawOpaque(view, layer.form, frame_, layer.first, count, ground);
    } else if (layer.pieces) {
      if (auto made = makeOnce(pieces_, ParticleOutput::light); !made) return made;
      pieces_->drawOpaque(view, frame, layer, ground);
    }
  }
  return {};
}

Expected<void> EffectPasses::drawSoft(std::size_t first, std::size_t end, const View& view, const GroundLevel& ground) {
  if (first >= end) return {};
  if (auto made = makeOnce(soft_, ParticleOutput::light); !made) return made;
  soft_->setDetail(detail_);
  const auto isSmoke = [&](std::size_t i) { return order_.instances()[i].kind == kSmokeKind; };
  std::size_t pending = first;
  for (std::size_t i = first; i < end;) {
    std::size_t smoke_end = i;
    while (smoke_end < end && isSmoke(smoke_end)) ++smoke_end;
    if (smoke_end - i >= kLongRun || (i == pending && smoke_end == end)) {
      if (i > pending) soft_->draw(view, blended_, pending, i - pending, ground, false);
      soft_->draw(view, blended_, i, smoke_end - i, ground, true);
      pending = smoke_end;
    }
    i = smoke_end + 1;
  }
  if (pending < end) soft_->draw(view, blended_, pending, end - pending, ground, false);
  return {};
}

Expected<void> EffectPasses::drawRuns(const View& view, const GroundLevel& ground, bool with_depth) {
  for (const BlendOrder::Run& run : order_.runs()) {
    if (run.pieces != nullptr) {
      if (auto made = makeOnce(pieces_, ParticleOutput::light); !made) return made;
      pieces_->drawBlended(view, run.pieces, order_.instances().subspan(run.first, run.count), ground, with_depth);
    } else if (!isSoft(run.form)) {
      solid_.drawBlended(view, run.form, blended_, run.first, run.count, ground, with_depth);
    } else if (auto drawn = drawSoft(run.first, run.first + run.count, view, ground); !drawn) {
      return drawn;
    }
  }
  return {};
}

Expected<void> EffectPasses::drawFading(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground) {
  order_.sort(frame, layers, view, Blended::pieces);
  if (order_.instances().empty()) return {};
  blended_.upload(order_.instances());
  return drawRuns(view, ground, true);
}

Expected<void> EffectPasses::drawAmong(const PiecesDrawn& pieces, const View& view, const GroundLevel& ground) {
  double nearest_m = std::numeric_limits<double>::infinity(), farthest_m = 0.0;
  for (const PieceSpread::Extent& piece : pieces.spread.pieces) {
    nearest_m = std::min(nearest_m, piece.nearest_m);
    farthest_m = std::max(farthest_m, piece.farthest_m);
  }
  const auto soft = order_.instances();
  const auto depthOf = [&](const BlendedInstance& puff) { return view.depthOf(static_cast<double>(puff.x), static_cast<double>(puff.y), static_cast<double>(puff.z)); };
  const auto firstBefore = [&](double depth_m) { return static_cast<std::size_t>(std::ranges::partition_point(soft, [&](const BlendedInstance& puff) { return depthOf(puff) > depth_m; }) - soft.begin()); };
  const std::size_t begin = firstBefore(farthest_m), end = firstBefore(nearest_m), steps = std::min(kSteps, end - begin);
  double behind_m = std::numeric_limits<double>::infinity();
  std::size_t drawn = 0;
  for (std::size_t step = 0; step < steps; ++step) {
    const std::size_t next = begin + (end - begin) * step / steps;
    const double next_m = depthOf(soft[next]);
    if (!pieces.spread.reaches(next_m, behind_m)) continue;
    if (auto done = drawSoft(drawn, next, view, ground); !done) return done;
    pieces.edges.lay(pieces.target, pieces.spread, view, next_m, behind_m);
    behind_m = next_m;
    drawn = next;
  }
  if (auto done = drawSoft(drawn, end, view, ground); !done) return done;
  pieces.edges.lay(pieces.target, pieces.spread, view, 0.0, behind_m);
  return drawSoft(end, soft.size(), view, ground);
}

Expected<void> EffectPasses::drawBlended(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, const PiecesDrawn* pieces) {
  shade_.build(frame, layers, ground.hour.towards_key);
  shade_.lookFrom(view.eye);
  order_.sort(frame, layers, view, pieces != nullptr ? Blended::soft : Blended::all, &shade_);
  if (!order_.instances().empty()) blended_.upload(order_.instances());
  return pieces != nullptr ? drawAmong(*pieces, view, ground) : drawRuns(view, ground, false);
}

Expected<void> EffectPasses::drawSolidSurfaces(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, const SurfaceFrame& surface) {
  if (auto made = makeOnce(solid_surfaces_, ParticleOutput::surface); !made) return made;
  frame_.uploadVelocities(frame);
  for (const LayerSpan& layer : layers) {
    if (!layer.pieces) continue;
    if (auto made = makeOnce(pieces_surfaces_, ParticleOutput::surface); !made) return made;
    pieces_surfaces_->drawSurfaces(view, frame, layer, ground, surface);
  }
  for (const LayerSpan& layer : layers)
    if (const std::size_t count = countOf(layer, frame); count > 0 && isSolid(layer.form)) solid_surfaces_->drawSurfaces(view, layer.form, frame_, layer.first, count, ground, surface);
  return {};
}

Expected<void> EffectPasses::drawSoftSurfaces(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, const SurfaceFrame& surface) {
  if (auto made = makeOnce(soft_surfaces_, ParticleOutput::surface); !made) return made;
  order_.sort(frame, layers, view, Blended::soft);
  if (order_.instances().empty()) return {};
  blended_.upload(order_.instances());
  soft_surfaces_->drawSurfaces(view, blended_, 0, order_.instances().size(), ground, surface);
  return {};
}

}  // namespace npsee::render
