#include "sim/fragments/shells.h"

#include "sim/fragments/polygon.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace npsee::fragments {
namespace {

/// A shell of less than this share of the cube around it encloses nothing: a sheet.
constexpr double kLeastShare = 1e-9;

/// An edge as one facet uses it.
struct HalfEdge {
  std::uint32_t low, high;  ///< corners, low < high
  std::uint32_t facet;
  bool forward;             ///< the facet goes from low to high
};

std::vector<HalfEdge> halfEdgesOf(const Solid& surface) {
  std::vector<HalfEdge> out;
  out.reserve(3 * surface.facets.size());
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = surface.facets[f].corners[k], b = surface.facets[f].corners[(k + 1) % 3];
      out.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(f), a < b});
    }
  std::ranges::sort(out, [](const HalfEdge& a, const HalfEdge& b) { return std::tie(a.low, a.high, a.facet) < std::tie(b.low, b.high, b.facet); });
  return out;
}

void weld(Solid& surface) {
  std::vector<std::uint32_t> order(surface.points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) { return std::tie(surface.points[i].x, surface.points[i].y, surface.points[i].z); };
  std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  for (Facet& facet : surface.facets)
    for (std::uint32_t& corner : facet.corners) corner = first[corner];
  std::erase_if(surface.facets, [](const Facet& f) { return f.corners[0] == f.corners[1] || f.corners[1] == f.corners[2] || f.corners[2] == f.corners[0]; });
}

/// Two facets that belong together; `turned` if they go along their edge the same way.
struct Pair {
  std::uint32_t a, b;
  bool turned;
};

/// Grows with the angle of (x, y) from 0 to 4, without a function of the C library.
double around(double x, double y) {
  const double size = std::fabs(x) + std::fabs(y);
  if (size == 0.0) return 0.0;
  return y >= 0.0 ? 1.0 - x / size : 3.0 + x / size;
}

/// Where more than two facets meet at an edge: each goes with the next one around it through its inside.
void pairAround(const Solid& surface, const HalfEdge* edges, std::size_t count, std::vector<Pair>& out) {
  const Vec3 from = surface.points[edges[0].low], along = surface.points[edges[0].high] - from;
  const double length2 = dot(along, along);
  struct Spoke {
    long long angle;
    bool backward;
    std::uint32_t facet;
  };
  std::vector<Spoke> spokes;
  Vec3 zero_way, quarter_way;
  for (std::size_t i = 0; i < count; ++i) {
    const Facet& facet = surface.facets[edges[i].facet];
    std::uint32_t third = facet.corners[0];
    for (const std::uint32_t corner : facet.corners)
      if (corner != edges[i].low && corner != edges[i].high) third = corner;
    Vec3 way = surface.points[third] - from;
    if (length2 > 0.0) way = way - (dot(way, along) / length2) * along;
    if (i == 0) zero_way = way, quarter_way = cross(along, way);
    const double x = dot(way, zero_way) * std::sqrt(length2), y = dot(way, quarter_way);
    spokes.push_back({std::llround(around(x, y) * 1e6) % 4'000'000, !edges[i].forward, edges[i].facet});
  }
  // Facets that lie on one another: the one whose inside comes before them goes first.
  std::ranges::sort(spokes, [](const Spoke& a, const Spoke& b) { return std::tie(a.angle, a.backward, a.facet) < std::tie(b.angle, b.backward, b.facet); });
  for (std::size_t i = 0; i < count; ++i) {
    const Spoke &here = spokes[i], &next = spokes[(i + 1) % count];
    if (here.backward && !next.backward) out.push_back({here.facet, next.facet, false});
  }
}

std::vector<Pair> pairsOf(const Solid& surface) {
  std::vector<Pair> out;
  const std::vector<HalfEdge> edges = halfEdgesOf(surface);
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
    end = first + 1;
    while (end < edges.size() && edges[end].low == edges[first].low && edges[end].high == edges[first].high) ++end;
    if (end - first == 2) out.push_back({edges[first].facet, edges[first + 1].facet, edges[first].forward == edges[first + 1].forward});
    else if (end - first > 2) pairAround(surface, edges.data() + first, end - first, out);
  }
  return out;
}

/// Number of the group of each facet; with `turn`, turns facets so that neighbours go along their edges in opposite ways.
std::vector<std::uint32_t> groupsOf(Solid& surface, bool turn, std::uint32_t& groups) {
  const std::size_t count = surface.facets.size();
  std::vector<std::vector<std::pair<std::uint32_t, bool>>> beside(count);
  for (const Pair& pair : pairsOf(surface)) {
    beside[pair.a].push_back({pair.b, pair.turned});
    beside[pair.b].push_back({pair.a, pair.turned});
  }
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<std::uint32_t> group(count, kNone);
  std::vector<bool> flip(count, false);
  std::vector<std::uint32_t> open;
  groups = 0;
  for (std::uint32_t seed = 0; seed < count; ++seed) {
    if (group[seed] != kNone) continue;
    group[seed] = groups;
    open.assign(1, seed);
    while (!open.empty()) {
      const std::uint32_t here = open.back();
      open.pop_back();
      for (const auto& [next, turned] : beside[here]) {
        if (group[next] != kNone) continue;
        group[next] = groups;
        flip[next] = flip[here] != turned;
        open.push_back(next);
      }
    }
    ++groups;
  }
  for (std::size_t f = 0; turn && f < count; ++f)
    if (flip[f]) std::swap(surface.facets[f].corners[1], surface.facets[f].corners[2]);
  return group;
}

std::vector<Solid> splitBy(const Solid& surface, const std::vector<std::uint32_t>& group, std::uint32_t groups) {
  std::vector<Solid> out(groups);
  constexpr std::uint32_t kNone = 0xffffffffu;
  // A point may be used by several groups: it is looked up per group.
  std::vector<std::map<std::uint32_t, std::uint32_t>> shared(groups);
  std::vector<std::uint32_t> owner(surface.points.size(), kNone), index(surface.points.size(), 0);
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const std::uint32_t g = group[f];
    Facet facet = surface.facets[f];
    for (std::uint32_t& corner : facet.corners) {
      const std::uint32_t old = corner;
      if (owner[old] == g) {
        corner = index[old];
        continue;
      }
      if (owner[old] == kNone) {
        owner[old] = g;
        index[old] = corner = static_cast<std::uint32_t>(out[g].points.size());
        out[g].points.push_back(surface.points[old]);
        continue;
      }
      const auto [place, fresh] = shared[g].try_emplace(old, static_cast<std::uint32_t>(out[g].points.size()));
      if (fresh) out[g].points.push_back(surface.points[old]);
      corner = place->second;
    }
    out[g].facets.push_back(facet);
  }
  return out;
}

void closeHoles(Solid& shell) {
  const std::vector<HalfEdge> edges = halfEdgesOf(shell);
  std::vector<Step> missing;
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end) {
    int net = 0;
    for (end = first; end < edges.size() && edges[end].low == edges[first].low && edges[end].high == edges[first].high; ++end) net += edges[end].forward ? 1 : -1;
    for (; net > 0; --net) missing.push_back({edges[first].high, edges[first].low});
    for (; net < 0; ++net) missing.push_back({edges[first].low, edges[first].high});
  }
  if (missing.empty()) return;
  for (const Loop& loop : loopsOf(std::move(missing))) fillLoop(shell.points, loop, kTorn, shell.facets);
}

double cubeAround(const Solid& shell) {
  Vec3 low = shell.points.front(), high = low;
  for (const Vec3& p : shell.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double side = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  return side * side * side;
}

}  // namespace

std::vector<Solid> joinedParts(const Solid& surface) {
  Solid copy = surface;
  std::uint32_t groups = 0;
  const std::vector<std::uint32_t> group = groupsOf(copy, false, groups);
  if (groups == 1) return {std::move(copy)};
  return splitBy(copy, group, groups);
}

std::vector<Solid> shellsOf(Solid surface) {
  weld(surface);
  std::uint32_t groups = 0;
  const std::vector<std::uint32_t> group = groupsOf(surface, true, groups);
  std::vector<Solid> out;
  for (Solid& shell : splitBy(surface, group, groups)) {
    closeHoles(shell);
    const double volume = massOf(shell, 1.0).volume_m3;
    if (!(std::fabs(volume) > kLeastShare * cubeAround(shell))) continue;
    if (volume < 0.0)
      for (Facet& facet : shell.facets) std::swap(facet.corners[1], facet.corners[2]);
    out.push_back(std::move(shell));
  }
  return out;
}

}  // namespace npsee::fragments
