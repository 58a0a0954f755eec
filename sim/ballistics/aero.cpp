#include "sim/ballistics/aero.h"

#include "sim/ballistics/curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace npsee::ballistics {
namespace {

constexpr std::size_t kRow = kCoefficients * 4;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Cubic Hermite pieces of a polynomial of higher degree on [0, width].
std::vector<Segment> cubicsOf(const Segment& segment, double width) {
  std::vector<double> fourth(segment.c.begin() + 4, segment.c.end());
  for (std::size_t k = 0; k < fourth.size(); ++k) fourth[k] *= static_cast<double>((k + 4) * (k + 3) * (k + 2) * (k + 1));
  double bound = 0.0, size = 0.0;
  for (std::size_t k = fourth.size(); k-- > 0;) bound = bound * width + std::fabs(fourth[k]);
  for (std::size_t k = segment.c.size(); k-- > 0;) size = size * width + std::fabs(segment.c[k]);
  // |error| <= h^4 / 384 max|f''''| of a cubic Hermite piece of width h.
  const double pieces = width * std::sqrt(std::sqrt(bound / (384.0 * 1e-9 * std::max(size, 1e-300))));
  const int n = static_cast<int>(std::clamp(std::ceil(pieces), 1.0, 512.0));
  std::vector<Segment> out;
  for (int i = 0; i < n; ++i) {
    const double x0 = width * i / n, h = width / n;
    const std::vector<double> here = shifted(segment.c, x0), there = shifted(segment.c, x0 + h);
    const double d = (there[0] - here[0]) / h;
    out.push_back({segment.from + x0, {here[0], here[1], (3.0 * d - 2.0 * here[1] - there[1]) / h, (here[1] + there[1] - 2.0 * d) / (h * h)}});
  }
  return out;
}

std::vector<Segment> asCubics(const std::vector<Segment>& segments) {
  std::vector<Segment> out;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (segments[i].c.size() <= 4) {
      out.push_back(segments[i]);
    } else {
      const std::vector<Segment> parts = cubicsOf(segments[i], segments[i + 1].from - segments[i].from);
      out.insert(out.end(), parts.begin(), parts.end());
    }
  }
  return out;
}

void fillColumn(CompiledAero& aero, std::size_t column, const std::vector<Segment>& segments) {
  std::size_t at = 0;
  for (std::size_t i = 0; i + 1 < aero.knots.size(); ++i) {
    while (at + 1 < segments.size() && segments[at + 1].from <= aero.knots[i]) ++at;
    const std::vector<double> c = shifted(segments[at].c, aero.knots[i] - segments[at].from);
    std::copy(c.begin(), c.end(), aero.rows.begin() + static_cast<std::ptrdiff_t>(i * kRow + column * 4));
  }
}

void fillBuckets(CompiledAero& aero) {
  const double top = aero.knots[aero.knots.size() - 2];
  double least = top;
  for (std::size_t i = 0; i + 2 < aero.knots.size(); ++i) least = std::min(least, aero.knots[i + 1] - aero.knots[i]);
  // One step of search suffices where buckets are no wider than the narrowest interval; absurdly narrow ones search longer.
  const int count = top > 0.0 ? static_cast<int>(std::clamp(std::ceil(top / least), 1.0, 4095.0)) : 1;
  aero.bucket_scale = top > 0.0 ? count / top : 1.0;
  std::int32_t interval = 0;
  for (int b = 0; b <= count; ++b) {
    while (aero.knots[static_cast<std::size_t>(interval) + 1] <= b / aero.bucket_scale) ++interval;
    // Rounding of mach * scale must not begin the search too far up.
    aero.buckets.push_back(std::max(0, interval - (aero.knots[static_cast<std::size_t>(interval)] >= b / aero.bucket_scale ? 1 : 0)));
  }
}

}  // namespace

CompiledAero compileAero(const AeroTable& table) {
  CompiledAero aero;
  std::array<std::vector<Segment>, kCoefficients> columns;
  aero.knots = {0.0};
  bool varies = false;
  for (std::size_t c = 0; c < kCoefficients; ++c) {
    columns[c] = asCubics(segmentsOf(table[c]));
    for (const Segment& segment : columns[c]) aero.knots.push_back(segment.from);
    if (std::ranges::any_of(columns[c], [](const Segment& s) { return s.c.size() > 1; })) {
      varies = true;
      aero.mach_top = std::max(aero.mach_top, columns[c].back().from);
    }
  }
  if (!varies) aero.mach_top = kInfinity;
  std::ranges::sort(aero.knots);
  aero.knots.erase(std::unique(aero.knots.begin(), aero.knots.end()), aero.knots.end());
  aero.knots.push_back(kInfinity);
  aero.rows.assign((aero.knots.size() - 1) * kRow, 0.0);
  for (std::size_t c = 0; c < kCoefficients; ++c)
    if (!columns[c].empty()) fillColumn(aero, c, columns[c]);
  fillBuckets(aero);
  aero.knot = aero.knots.data();
  aero.bucket = aero.buckets.data();
  aero.row = aero.rows.data();
  aero.last_bucket = static_cast<std::int64_t>(aero.buckets.size()) - 1;
  const auto has = [&](Coefficient c) { return !columns[static_cast<std::size_t>(c)].empty(); };
  const auto nonzero = [&](Coefficient c) { return std::ranges::any_of(columns[static_cast<std::size_t>(c)], [](const Segment& s) { return std::ranges::any_of(s.c, [](double v) { return v != 0.0; }); }); };
  aero.has_yaw = has(Coefficient::cma);
  aero.cubic_yaw = nonzero(Coefficient::cla3) || nonzero(Coefficient::cma3);
  return aero;
}

}  // namespace npsee::ballistics
