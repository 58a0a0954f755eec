#include "sim/explosion/extent.h"

#include <algorithm>

namespace npsee::explosion {
namespace {

constexpr std::size_t kSampledParticles = 1000;
constexpr int kSampledAges = 24;
constexpr double kStray = 0.025;

/// The values below and above which only strays lie.
std::pair<double, double> withoutStrays(std::vector<double>& values) {
  const auto count = static_cast<double>(values.size() - 1);
  const auto low = values.begin() + static_cast<std::ptrdiff_t>(kStray * count), high = values.begin() + static_cast<std::ptrdiff_t>((1.0 - kStray) * count);
  std::ranges::nth_element(values, low);
  const double least = *low;
  std::ranges::nth_element(values, high);
  return {least, *high};
}

/// Age up to which a particle makes the picture: what hops on after its second contact would only push the camera away.
double untilSecondContact(const Chunk& chunk, std::size_t particle) {
  return chunk.last_arc[particle] >= 2 ? chunk.arcs[chunk.first_arc[particle] + 2].start_s : chunk.lifetime_s[particle];
}

}  // namespace

Extent extentOf(const std::vector<CompiledLayer>& layers, const Vec3& burst) {
  std::vector<double> x, y, z;
  for (const CompiledLayer& layer : layers) {
    const std::size_t stride = 1 + layer.count / kSampledParticles;
    for (std::size_t number = 0; number < layer.count; number += stride) {
      const Chunk& chunk = layer.chunks[number / kChunkParticles];
      const auto particle = static_cast<int>(number % kChunkParticles);
      const double end = untilSecondContact(chunk, static_cast<std::size_t>(particle));
      for (int sample = 0; sample < kSampledAges; ++sample) {
        const Motion<double> m = stateOf(layer.constants, chunk, particle, end * sample / (kSampledAges - 1));
        x.push_back(m.x);
        y.push_back(m.y);
        z.push_back(m.z);
      }
    }
  }
  Extent out{burst, burst};
  if (x.empty()) return out;
  const auto [x_low, x_high] = withoutStrays(x);
  const auto [y_low, y_high] = withoutStrays(y);
  const auto [z_low, z_high] = withoutStrays(z);
  out.min = {std::min(burst.x, x_low), std::min(burst.y, y_low), std::min(burst.z, z_low)};
  out.max = {std::max(burst.x, x_high), std::max(burst.y, y_high), std::max(burst.z, z_high)};
  return out;
}

}  // namespace npsee::explosion
