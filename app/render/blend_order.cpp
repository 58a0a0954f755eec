#include "app/render/blend_order.h"

#include "app/render/frame_particles.h"
#include "app/render/heat.h"
#include "app/render/meshes.h"
#include "app/render/solid_pass.h"

#include <algorithm>

namespace npsee::render {
namespace {

float kindOf(Form form) {
  switch (form) {
    case Form::smoke: return kSmokeKind;
    case Form::fire: return 2.0f;
    case Form::flash: return 3.0f;
    default: return 0.0f;
  }
}

/// 0..1 from a particle's index, for the turn of its puff (golden-ratio sequence: neighbours differ).
float ownNumber(std::uint32_t index) { return static_cast<float>((index * 2654435769u) >> 8) * (1.0f / 16777216.0f); }

BlendedInstance instanceOf(const Frame& frame, std::uint32_t i, std::uint32_t in_layer, const LayerSpan& layer) {
  const Form form = layer.form;
  const double temperature = temperatureAt(layer, frame, i);
  BlendedInstance out{frame.x[i], frame.y[i], frame.z[i], frame.size[i], frame.r[i], frame.g[i], frame.b[i], frame.a[i], {0.0f, 0.0f, 0.0f, 1.0f}, kindOf(form), {}};
  if (!isSoft(form)) {
    if (frame.qw.size() > i) {
      const float q[4] = {frame.qx[i], frame.qy[i], frame.qz[i], frame.qw[i]};
      std::copy(q, q + 4, out.p);
    }
    out.kind = static_cast<float>(temperature);
    return out;
  }
  if (temperature > 0.0) {
    const Colour hot = hotColour({static_cast<double>(out.r), static_cast<double>(out.g), static_cast<double>(out.b)}, temperature);
    out.r = static_cast<float>(hot.r);
    out.g = static_cast<float>(hot.g);
    out.b = static_cast<float>(hot.b);
  }
  const bool moving = frame.vx.size() > i;
  out.p[0] = moving ? frame.vx[i] : 0.0f;
  out.p[1] = moving ? frame.vy[i] : 0.0f;
  out.p[2] = moving ? frame.vz[i] : 0.0f;
  out.p[3] = ownNumber(in_layer);
  return out;
}

}  // namespace

void BlendOrder::sort(const Frame& frame, std::span<const LayerSpan> layers, const View& view, Blended wanted, const SmokeShade* shade) {
  entries_.clear();
  instances_.clear();
  runs_.clear();
  for (std::size_t l = 0; l < layers.size(); ++l) {
    const LayerSpan& layer = layers[l];
    const bool soft = isSoft(layer.form);
    if (!soft && !isSolid(layer.form) && !layer.pieces) continue;
    if (wanted != Blended::all && soft != (wanted == Blended::soft)) continue;
    const std::size_t end = endOf(layer, frame);
    for (std::size_t i = layer.first; i < end; ++i) {
      const float a = frame.a[i];
      if (frame.size[i] <= 0.0f || a <= 0.0f || (!soft && a > kOpaque)) continue;
      const Vec3 at = placeOf(frame, i);
      const bool cloud = layer.form == Form::smoke || layer.form == Form::fire;
      if (shade != nullptr && cloud && shade->hidden(at, 0.5 * static_cast<double>(frame.size[i]), view.right, view.up)) continue;
      const double depth = view.depthOf(at.x, at.y, at.z);
      entries_.push_back({static_cast<float>(depth), static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(l)});
    }
  }
  std::ranges::sort(entries_, [](const Entry& a, const Entry& b) { return a.depth != b.depth ? a.depth > b.depth : a.index < b.index; });
  for (const Entry& entry : entries_) {
    const LayerSpan& layer = layers[entry.layer];
    const bool joins = !runs_.empty() && runs_.back().pieces == layer.pieces && (runs_.back().form == layer.form || (isSoft(runs_.back().form) && isSoft(layer.form)));
    if (!joins) runs_.push_back({layer.form, instances_.size(), 0, layer.pieces});
    ++runs_.back().count;
    const std::uint32_t in_layer = entry.index - static_cast<std::uint32_t>(layer.first);
    instances_.push_back(instanceOf(frame, entry.index, in_layer, layer));
    BlendedInstance& instance = instances_.back();
    if (layer.pieces) {
      instance.light.sunward = instance.kind;
      instance.kind = static_cast<float>(in_layer % layer.pieces->pieces.size());
    }
    if (shade != nullptr && layer.form == Form::smoke) instance.light = shade->at({static_cast<double>(instance.x), static_cast<double>(instance.y), static_cast<double>(instance.z)}, 0.5 * static_cast<double>(instance.size));
  }
}

}  // namespace npsee::render
