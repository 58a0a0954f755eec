#include "app/render/effect_passes.h"

#include "app/render/make_once.h"
#include "app/render/meshes.h"

#include <algorithm>

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

/// As kKeyDirection of shaders/common.glsl.
constexpr Vec3 kTowardsSun{-0.5263, 0.7105, 0.4671};

/// The span cut to the particles the frame really holds.
std::size_t countIn(const LayerSpan& layer, const Frame& frame) {
  return layer.first >= frame.count ? 0 : std::min(layer.count, frame.count - layer.first);
}

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

Expected<void> EffectPasses::drawScorch(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground) {
  for (const LayerSpan& layer : layers) {
    const std::size_t count = countIn(layer, frame);
    if (count == 0 || layer.form != Form::scorch) continue;
    if (auto made = makeOnce(scorch_); !made) return made;
    scorch_->draw(view, frame_, layer.first, count, ground);
  }
  return {};
}

Expected<void> EffectPasses::drawShockRings(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground) {
  for (const LayerSpan& layer : layers) {
    const std::size_t count = countIn(layer, frame);
    if (count == 0 || layer.form != Form::shock) continue;
    if (auto made = makeOnce(shock_); !made) return made;
    shock_->drawRings(view, frame_, layer.first, count, ground);
  }
  return {};
}

Expected<void> EffectPasses::drawShockShells(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground) {
  for (const LayerSpan& layer : layers) {
    const std::size_t count = countIn(layer, frame);
    if (count == 0 || layer.form != Form::shock) continue;
    if (auto made = makeOnce(shock_); !made) return made;
    shock_->drawShells(view, frame_, layer.first, count, ground);
  }
  return {};
}

Expected<void> EffectPasses::drawShadows(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground) {
  // Those of pieces have their outlines; over a terrain, where pictures hold more than shadows by then, they are blobs as well.
  for (const LayerSpan& layer : layers)
    if (layer.pieces && ground.shadow_nearer <= 0.0) {
      if (auto made = makeOnce(pieces_, ParticleOutput::light); !made) return made;
      pieces_->drawShadows(view, frame, layer, ground, shadowStrength(layer.form));
    }
  for (const LayerSpan& layer : layers) {
    const std::size_t count = countIn(layer, frame);
    const double strength = layer.pieces && ground.shadow_nearer <= 0.0 ? 0.0 : shadowStrength(layer.form);
    if (count > 0 && strength > 0.0) shadow_.draw(view, frame_, layer.first, count, ground, strength);
  }
  mapSmokeShadow(frame, layers, {ground.height_m, ground.slope_x, ground.slope_z}, kTowardsSun, shadow_map_);
  if (shadow_map_.empty()) return {};
  if (auto made = makeOnce(smoke_shadow_); !made) return made;
  smoke_shadow_->draw(view, ground, kTowardsSun, shadow_map_);
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
    const std::size_t count = countIn(layer, frame);
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

Expected<void> EffectPasses::drawBlended(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground) {
  shade_.build(frame, layers, kTowardsSun);
  shade_.lookFrom(view.eye);
  order_.sort(frame, layers, view, &shade_);
  if (order_.instances().empty()) return {};
  blended_.upload(order_.instances());
  for (const BlendOrder::Run& run : order_.runs()) {
    if (run.pieces != nullptr) {
      if (auto made = makeOnce(pieces_, ParticleOutput::light); !made) return made;
      pieces_->drawBlended(view, run.pieces, order_.instances().subspan(run.first, run.count), ground);
      continue;
    }
    if (!isSoft(run.form)) {
      solid_.drawBlended(view, run.form, blended_, run.first, run.count, ground);
      continue;
    }
    if (auto made = makeOnce(soft_, ParticleOutput::light); !made) return made;
    soft_->setDetail(detail_);
    soft_->draw(view, blended_, run.first, run.count, ground);
  }
  return {};
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
    if (const std::size_t count = countIn(layer, frame); count > 0 && isSolid(layer.form)) solid_surfaces_->drawSurfaces(view, layer.form, frame_, layer.first, count, ground, surface);
  return {};
}

Expected<void> EffectPasses::drawSoftSurfaces(const Frame& frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, const SurfaceFrame& surface) {
  if (auto made = makeOnce(soft_surfaces_, ParticleOutput::surface); !made) return made;
  order_.sort(frame, layers, view);
  if (order_.instances().empty()) return {};
  blended_.upload(order_.instances());
  for (const BlendOrder::Run& run : order_.runs())
    if (isSoft(run.form)) soft_surfaces_->drawSurfaces(view, blended_, run.first, run.count, ground, surface);
  return {};
}

}  // namespace npsee::render
