#include "sim/preset/stream.h"

#include "sim/core/text.h"

#include <npsee/parameters.h>

#include <algorithm>
#include <cmath>

namespace npsee {
namespace {

double shapeMeasure(const Layer& layer) {
  const bool surface = layer.region_fill == RegionFill::surface;
  const double r = layer.region_radius_m, a = layer.region_length_m, w = layer.region_width_m, h = layer.region_height_m;
  switch (layer.region_shape) {
    case RegionShape::point: return 1.0;
    case RegionShape::disc: return surface ? kTwoPi * r : kPi * r * r;
    case RegionShape::ring: {
      const double inner = std::min(layer.region_inner_radius_m, r);
      return surface ? kTwoPi * (r + inner) : kPi * (r * r - inner * inner);
    }
    case RegionShape::square: return surface ? 4.0 * a : a * a;
    case RegionShape::line: return surface ? 2.0 : a;
    case RegionShape::sphere: return surface ? 4.0 * kPi * r * r : 4.0 / 3.0 * kPi * r * r * r;
    case RegionShape::hemisphere: return surface ? kTwoPi * r * r : 2.0 / 3.0 * kPi * r * r * r;
    case RegionShape::box: return surface ? 2.0 * (a * w + a * h + w * h) : a * w * h;
    case RegionShape::cylinder: return surface ? kTwoPi * r * h : kPi * r * r * h;
  }
  return 1.0;
}

}  // namespace

double regionMeasure(const Layer& layer) { return shapeMeasure(layer); }

std::int64_t particleCount(const Layer& layer) {
  if (layer.count > 0) return layer.count;
  // Far above any limit is enough to be refused; it must not overflow on the way.
  return static_cast<std::int64_t>(std::min(1e15, std::round(layer.density * shapeMeasure(layer))));
}

int findLayer(const Preset& preset, std::string_view name) {
  if (name.empty()) return -1;
  for (std::size_t i = 0; i < preset.layers.size(); ++i)
    if (preset.layers[i].name == name) return static_cast<int>(i);
  return -1;
}

std::string freeLayerName(const Preset& preset, std::string_view wish) {
  std::string base(wish);
  // "sparks 2" copied becomes "sparks 3", not "sparks 2 2".
  if (const std::size_t space = base.rfind(' '); space != std::string::npos && space > 0 && space + 1 < base.size() &&
                                                 std::all_of(base.begin() + static_cast<std::ptrdiff_t>(space) + 1, base.end(), [](char c) { return c >= '0' && c <= '9'; }))
    base.resize(space);
  if (base.empty()) base = "layer";
  if (base.size() > 36) base.resize(36);
  if (findLayer(preset, base) < 0) return base;
  for (int number = 2;; ++number)
    if (std::string name = base + ' ' + std::to_string(number); findLayer(preset, name) < 0) return name;
}

std::uint32_t layerStream(const Layer& layer) {
  // FNV-1a, 32 bit: http://www.isthe.com/chongo/tech/comp/fnv/, public domain.
  std::uint32_t hash = 2166136261u;
  for (const char c : layer.name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return hash + static_cast<std::uint32_t>(layer.variation);
}

Expected<void> renameLayer(Preset& preset, std::size_t index, std::string_view name) {
  Preset changed = preset;
  Layer& layer = changed.layers.at(index);
  const std::uint32_t stream = layerStream(layer);
  const std::string old = layer.name;
  layer.name = std::string(name);
  layer.variation = static_cast<std::uint32_t>(layer.variation) + stream - layerStream(layer);
  for (Layer& other : changed.layers)
    if (other.parent == old) other.parent = layer.name;
  if (const std::vector<Fault> faults = validate(changed); !faults.empty()) return fail(ErrorKind::usage, faults.front());
  preset = std::move(changed);
  return {};
}

}  // namespace npsee
