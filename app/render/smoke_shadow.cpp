#include "app/render/smoke_shadow.h"

#include "app/render/frame_particles.h"
#include "app/render/smoke_shade.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace npsee::render {
namespace {

constexpr double kMostCells = 16384.0;
constexpr double kPenumbra = 0.005, kCore = 0.85;
/// Of the depth through the middle, what is left where noise has eaten the rim.
constexpr double kThickness = 0.6;
/// Of the ground's light the sun's part, which smoke can take; some comes from the sky.
constexpr float kMostDark = 0.68f;
/// A lit cloud passes on part of what it stops.
constexpr double kForward = 0.7;

/// A puff's shadow: an ellipse on the map.
struct Shade {
  double u, v, across, depth;
};

struct Sun {
  double x, z, stretch, throw_per_m;  ///< where shadows go to, unit; their length against their width; their way per metre of height
};

Sun sunOf(const Vec3& k) {
  const double flat = std::sqrt(k.x * k.x + k.z * k.z), up = std::max(k.y, 0.05);
  return flat > 1e-9 ? Sun{-k.x / flat, -k.z / flat, 1.0 / up, flat / up} : Sun{1.0, 0.0, 1.0 / up, 0.0};
}

bool shadeOf(const Frame& frame, std::size_t i, const ShadowPlane& ground, const Sun& sun, Shade& out) {
  const double size = static_cast<double>(frame.size[i]), opacity = std::min(static_cast<double>(frame.a[i]), 1.0);
  if (!(size > 0.0) || !(opacity > 0.004)) return false;
  const Vec3 at = placeOf(frame, i);
  const double height = at.y - ground.height_m - ground.slope_x * at.x - ground.slope_z * at.z;
  if (height < -0.5 * size) return false;
  const double r = 0.5 * size * kCore, above = std::max(height, 0.25 * size), penumbra = kPenumbra * above;
  const double albedo = std::clamp(0.3333 * (static_cast<double>(frame.r[i]) + static_cast<double>(frame.g[i]) + static_cast<double>(frame.b[i])), 0.0, 1.0);
  out.across = r + penumbra;
  // Spread over more ground it is thinner. The colours are coded: their square is about the light.
  out.depth = kThickness * opticalDepthOf(opacity) * (1.0 - kForward * albedo * albedo) * r * r / (out.across * out.across);
  out.u = at.x * sun.x + at.z * sun.z + sun.throw_per_m * above;
  out.v = at.z * sun.x - at.x * sun.z;
  return out.depth > 0.002;
}

template <class Take>
void forShades(const Frame& frame, std::span<const LayerSpan> layers, const ShadowPlane& ground, const Sun& sun, const Take& take) {
  Shade shade;
  for (const LayerSpan& layer : layers) {
    if (layer.form != Form::smoke) continue;
    const std::size_t end = endOf(layer, frame);
    for (std::size_t i = layer.first; i < end; ++i)
      if (shadeOf(frame, i, ground, sun, shade)) take(shade);
  }
}

/// Weights of cells along an axis around a place, in cells; the first one's index.
int weightsAround(double at, double reach, int count, std::vector<float>& weights) {
  const int first = std::max(static_cast<int>(std::ceil(at - reach)), 0), last = std::min(static_cast<int>(std::floor(at + reach)), count - 1);
  weights.clear();
  for (int i = first; i <= last; ++i) {
    const double d = (i - at) / reach;
    weights.push_back(static_cast<float>(std::max(1.0 - d * d, 0.0)));
  }
  return first;
}

}  // namespace

void mapSmokeShadow(const Frame& frame, std::span<const LayerSpan> layers, const ShadowPlane& ground, const Vec3& towards_sun, SmokeShadowMap& map) {
  const Sun sun = sunOf(towards_sun);
  map.columns = map.rows = 0;
  double low_u = 1e30, high_u = -1e30, low_v = 1e30, high_v = -1e30;
  forShades(frame, layers, ground, sun, [&](const Shade& s) {
    low_u = std::min(low_u, s.u - s.across * sun.stretch), high_u = std::max(high_u, s.u + s.across * sun.stretch);
    low_v = std::min(low_v, s.v - s.across), high_v = std::max(high_v, s.v + s.across);
  });
  const double size_u = high_u - low_u, size_v = high_v - low_v;
  if (!(size_u > 0.0 && size_v > 0.0 && size_u < 1e6 && size_v < 1e6)) return;
  const double least = std::max(size_u, size_v) / 256.0;
  map.cell_m = std::sqrt(std::max(size_u, least) * std::max(size_v, least) / kMostCells);
  // Two empty cells around it, where it fades out.
  map.origin_u = low_u - 2.0 * map.cell_m;
  map.origin_v = low_v - 2.0 * map.cell_m;
  map.columns = static_cast<int>(size_u / map.cell_m) + 5;
  map.rows = static_cast<int>(size_v / map.cell_m) + 5;
  map.dark.assign(static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows), 0.0f);
  std::array<std::vector<float>, 2> weights;
  forShades(frame, layers, ground, sun, [&](const Shade& s) {
    const double reach_u = std::max(s.across * sun.stretch / map.cell_m, 1.6), reach_v = std::max(s.across / map.cell_m, 1.6);
    const int first_u = weightsAround((s.u - map.origin_u) / map.cell_m - 0.5, reach_u, map.columns, weights[0]);
    const int first_v = weightsAround((s.v - map.origin_v) / map.cell_m - 0.5, reach_v, map.rows, weights[1]);
    // What had to be widened to be seen on the map is thinner for it.
    const double wide = s.across * s.across * sun.stretch / (map.cell_m * map.cell_m) / (reach_u * reach_v);
    const auto depth = static_cast<float>(s.depth * wide);
    for (std::size_t j = 0; j < weights[1].size(); ++j) {
      float* row = map.dark.data() + (first_v + static_cast<int>(j)) * map.columns + first_u;
      const float w = depth * weights[1][j];
      for (std::size_t i = 0; i < weights[0].size(); ++i) row[i] += w * weights[0][i];
    }
  });
  for (float& value : map.dark) value = kMostDark * (1.0f - leftThrough(value));
}

}  // namespace npsee::render
