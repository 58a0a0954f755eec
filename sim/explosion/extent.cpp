#include "sim/explosion/extent.h"

#include <algorithm>
#include <cmath>

namespace npsee::explosion {
namespace {

constexpr std::size_t kSampledParticles = 300;
constexpr int kSampledAges = 16;
/// Share of all that is drawn which may lie beyond each side of the box, and beyond its top, where a picture cuts what is seen best.
constexpr double kStray = 0.035, kStrayAbove = 0.006;

double factorAt(const Curve& curve, double u) {
  if (curve.empty()) return 1.0;
  if (u <= curve.front().at) return curve.front().value;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const CurvePoint &a = curve[i - 1], &b = curve[i];
    if (u < b.at) return a.value + (b.value - a.value) * ((u - a.at) / (b.at - a.at));
  }
  return curve.back().value;
}

/// Age up to which a particle makes the picture: what hops on after its second contact would only push the camera away.
double untilSecondContact(const LayerConstants& c, const Chunk& chunk, std::size_t particle) {
  return !c.follow && chunk.last_arc[particle] >= 2 ? chunk.arcs[chunk.first_arc[particle] + 2].start_s : chunk.lifetime_s[particle];
}

/// One particle at one moment: what it covers, and how much of the picture it is.
struct Mark {
  Vec3 place;
  double radius_m, weight;
};

/// Share of a particle's radius that is seen, and of its area that counts. A shock passes in a moment and reaches far beyond the rest.
struct Seen {
  double radius, weight;
};
Seen seenOf(Form form) {
  switch (form) {
    case Form::flash: return {0.5, 1.0};
    case Form::smoke:
    case Form::fire: return {0.8, 1.0};
    case Form::shock: return {0.3, 0.0};
    case Form::scorch: return {0.9, 0.3};
    default: return {1.0, 1.0};
  }
}

void addMarks(const CompiledLayer& layer, double ground_y, std::vector<Mark>& marks) {
  // Something must count where nothing is seen.
  constexpr double kLeast_m2 = 1e-9;
  const LayerConstants& c = layer.constants;
  const Seen seen = seenOf(layer.form);
  const std::size_t stride = 1 + layer.count / kSampledParticles;
  for (std::size_t number = 0; number < layer.count; number += stride) {
    const Chunk& chunk = layer.chunks[number / kChunkParticles];
    const std::size_t particle = number % kChunkParticles;
    const double life = chunk.lifetime_s[particle], end = untilSecondContact(c, chunk, particle);
    for (int sample = 0; sample < kSampledAges; ++sample) {
      const double age = end * sample / (kSampledAges - 1), u = life > 0.0 ? age / life : 0.0;
      const Motion<double> m = stateOf(c, chunk, static_cast<int>(particle), age);
      const double radius = 0.5 * static_cast<double>(chunk.size_m[particle]) * factorAt(c.size_over_life, u);
      // What sinks into the ground is not drawn.
      const double above = m.y >= ground_y ? 1.0 : std::max(0.0, 1.0 - (ground_y - m.y) / std::max(radius, 1e-9));
      const double area = above * radius * radius * c.opacity * factorAt(c.opacity_over_life, u);
      marks.push_back({{m.x, m.y, m.z}, seen.radius * radius, kLeast_m2 + static_cast<double>(stride) * seen.weight * area});
    }
  }
}

/// Range along one axis beyond whose ends lie the given shares of the weight. `at` gives a mark's lower and upper edge.
template <class Edges>
std::pair<double, double> withoutStrays(const std::vector<Mark>& marks, double stray_low, double stray_high, Edges at) {
  constexpr std::size_t kBins = 1024;
  double least = 1e300, most = -1e300, whole = 0.0;
  for (const Mark& mark : marks) {
    const auto [low, high] = at(mark);
    least = std::min(least, low);
    most = std::max(most, high);
    whole += mark.weight;
  }
  const double bin = (most - least) / kBins;
  if (!(bin > 0.0)) return {least, most};
  std::vector<double> lows(kBins, 0.0), highs(kBins, 0.0);
  const auto binOf = [&](double value) { return std::min(kBins - 1, static_cast<std::size_t>(std::max(0.0, (value - least) / bin))); };
  for (const Mark& mark : marks) {
    const auto [low, high] = at(mark);
    lows[binOf(low)] += mark.weight;
    highs[binOf(high)] += mark.weight;
  }
  std::size_t first = 0, last = kBins - 1;
  for (double below = lows[first]; first + 1 < kBins && below <= stray_low * whole; below += lows[first]) ++first;
  for (double above = highs[last]; last > 0 && above <= stray_high * whole; above += highs[last]) --last;
  return {least + bin * static_cast<double>(first), least + bin * static_cast<double>(last + 1)};
}

}  // namespace

Extent extentOf(const std::vector<CompiledLayer>& layers, const Vec3& burst, double ground_y) {
  std::vector<Mark> marks;
  for (const CompiledLayer& layer : layers) addMarks(layer, ground_y, marks);
  Extent out{burst, burst};
  if (marks.empty()) return out;
  const auto [x_low, x_high] = withoutStrays(marks, kStray, kStray, [](const Mark& m) { return std::pair(m.place.x - m.radius_m, m.place.x + m.radius_m); });
  const auto [y_low, y_high] = withoutStrays(marks, kStray, kStrayAbove, [&](const Mark& m) { return std::pair(std::max(m.place.y - m.radius_m, ground_y), std::max(m.place.y + m.radius_m, ground_y)); });
  const auto [z_low, z_high] = withoutStrays(marks, kStray, kStray, [](const Mark& m) { return std::pair(m.place.z - m.radius_m, m.place.z + m.radius_m); });
  out.min = {std::min(burst.x, x_low), std::min(burst.y, y_low), std::min(burst.z, z_low)};
  out.max = {std::max(burst.x, x_high), std::max(burst.y, y_high), std::max(burst.z, z_high)};
  for (const Mark& mark : marks) out.reach_m = std::max(out.reach_m, length(mark.place - out.centre()) + mark.radius_m);
  return out;
}

}  // namespace npsee::explosion
