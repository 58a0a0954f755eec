#include "editor/document/launch_probe.h"

#include <npsee/explosion.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace npsee::editor {
namespace {

/// The layer alone, started at once around the burst, without what would change it in flight.
Preset alone(const Preset& preset, std::size_t index, std::size_t most) {
  Preset out = preset;
  Layer layer = preset.layers[index];
  layer.enabled = true;
  layer.parent.clear();
  layer.trigger = Trigger::none;
  layer.start_s = layer.duration_s = 0.0;
  layer.collide = false;
  layer.size_over_life.clear();
  layer.region_offset_m = {};
  // A child is thrown by its direction even where the burst throws all around.
  if (!preset.layers[index].parent.empty() && layer.directionality == Directionality::burst) layer.directionality = preset.burst == BurstKind::air ? Directionality::neutral : Directionality::cone;
  layer.count = std::clamp<std::int64_t>(particleCount(layer), 1, static_cast<std::int64_t>(most));
  out.layers = {std::move(layer)};
  return out;
}

double angleBetween(const Vec3& a, const Vec3& b) {
  const double size = length(a) * length(b);
  return size > 0.0 ? std::acos(std::clamp(dot(a, b) / size, -1.0, 1.0)) : 0.0;
}

}  // namespace

LaunchProbe probeLaunch(const Preset& preset, int layer, std::size_t most) {
  LaunchProbe out;
  if (layer < 0 || layer >= static_cast<int>(preset.layers.size()) || particleCount(preset.layers[static_cast<std::size_t>(layer)]) <= 0) return out;
  const Preset single = alone(preset, static_cast<std::size_t>(layer), most);
  const auto explosion = Explosion::compile(single);
  if (!explosion) return out;
  Frame frame;
  (*explosion)->at(0.0, frame, kVelocity);
  const double centre_y = preset.ground_height_m + (preset.burst == BurstKind::air ? preset.burst_height_m : 0.0);
  for (std::size_t i = 0; i < frame.count; ++i) {
    out.x_m.push_back(frame.x[i]);
    out.y_m.push_back(static_cast<float>(static_cast<double>(frame.y[i]) - centre_y));
    out.z_m.push_back(frame.z[i]);
    const Vec3 velocity{static_cast<double>(frame.vx[i]), static_cast<double>(frame.vy[i]), static_cast<double>(frame.vz[i])};
    out.speed_mps.push_back(static_cast<float>(length(velocity)));
    out.angle_rad.push_back(static_cast<float>(angleBetween(velocity, single.layers[0].direction)));
    out.size_m.push_back(frame.size[i]);
  }
  // Long after the last death the age has stopped at the lifetime.
  (*explosion)->at(1e6, frame, kAge);
  out.lifetime_s.assign(frame.age.begin(), frame.age.begin() + static_cast<std::ptrdiff_t>(frame.count));
  return out;
}

Histogram histogramOf(std::span<const float> values) {
  Histogram out;
  if (values.empty()) return out;
  const auto [least, most] = std::ranges::minmax(values);
  out.low = static_cast<double>(least);
  out.high = static_cast<double>(most);
  out.mean = std::accumulate(values.begin(), values.end(), 0.0, [](double sum, float v) { return sum + static_cast<double>(v); }) / static_cast<double>(values.size());
  if (!out.spread()) return out;
  constexpr auto kBins = static_cast<double>(Histogram::kBins);
  for (const float value : values) {
    const double share = (static_cast<double>(value) - out.low) / (out.high - out.low);
    ++out.bins[static_cast<std::size_t>(std::clamp(share * kBins, 0.0, kBins - 1.0))];
  }
  out.most = *std::ranges::max_element(out.bins);
  return out;
}

}  // namespace npsee::editor
