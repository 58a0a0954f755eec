#include "sim/fragments/polygon.h"

#include <algorithm>
#include <cmath>

namespace npsee::fragments {
namespace {

/// Beyond it a loop is filled from its first corner: clipping ears takes the square of the corners and more.
constexpr std::size_t kMostEars = 400;

struct Flat {
  double x = 0.0, y = 0.0;
};

/// Twice the signed area of a triangle.
double area2(const Flat& a, const Flat& b, const Flat& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// The plane's coordinates: the axis nearest to the normal is dropped, so that anticlockwise stays anticlockwise.
class Flattened {
 public:
  Flattened(const std::vector<Vec3>& points, const Vec3& normal) : points_(points) {
    const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
    axis_ = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
    turned_ = (axis_ == 0 ? normal.x : axis_ == 1 ? normal.y : normal.z) < 0.0;
  }
  Flat operator()(std::uint32_t point) const {
    const Vec3& p = points_[point];
    const Flat out = axis_ == 0 ? Flat{p.y, p.z} : axis_ == 1 ? Flat{p.z, p.x} : Flat{p.x, p.y};
    return turned_ ? Flat{out.y, out.x} : out;
  }

 private:
  const std::vector<Vec3>& points_;
  int axis_ = 0;
  bool turned_ = false;
};

double area2(const Flattened& flat, const Loop& loop) {
  double sum = 0.0;
  const Flat origin = flat(loop.front());
  for (std::size_t i = 0; i < loop.size(); ++i) sum += area2(origin, flat(loop[i]), flat(loop[(i + 1) % loop.size()]));
  return sum;
}

bool inside(const Flat& p, const Flat& a, const Flat& b, const Flat& c) { return area2(a, b, p) >= 0.0 && area2(b, c, p) >= 0.0 && area2(c, a, p) >= 0.0; }

bool same(const Flat& a, const Flat& b) { return a.x == b.x && a.y == b.y; }

/// Whether the corner can be cut off: it points outwards, and no other corner lies in the triangle.
bool isEar(const Flattened& flat, const Loop& loop, std::size_t at) {
  const std::size_t n = loop.size();
  const Flat a = flat(loop[(at + n - 1) % n]), b = flat(loop[at]), c = flat(loop[(at + 1) % n]);
  if (!(area2(a, b, c) > 0.0)) return false;
  for (const std::uint32_t corner : loop) {
    const Flat p = flat(corner);
    if (!same(p, a) && !same(p, b) && !same(p, c) && inside(p, a, b, c)) return false;
  }
  return true;
}

void clipEars(const Flattened& flat, Loop loop, std::uint16_t material, std::vector<Facet>& out) {
  std::size_t at = 0;
  while (loop.size() > 3) {
    std::size_t chosen = at % loop.size();
    for (std::size_t tried = 0; tried < loop.size(); ++tried)
      if (const std::size_t next = (at + tried) % loop.size(); isEar(flat, loop, next)) {
        chosen = next;
        break;
      }
    // Without an ear (a loop that crosses itself, or has no area) any corner will do: the surface stays closed.
    const std::size_t n = loop.size();
    out.push_back({{loop[(chosen + n - 1) % n], loop[chosen], loop[(chosen + 1) % n]}, material});
    loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(chosen));
    // Going on beside the last ear's neighbour makes fewer slivers than fanning around one corner.
    at = chosen + 1;
  }
  if (loop.size() == 3) out.push_back({{loop[0], loop[1], loop[2]}, material});
}

void fill(const Flattened& flat, const Loop& loop, std::uint16_t material, std::vector<Facet>& out) {
  if (loop.size() < 3) return;
  if (loop.size() <= kMostEars) return clipEars(flat, loop, material, out);
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) out.push_back({{loop[0], loop[i], loop[i + 1]}, material});
}

bool crosses(const Flat& a, const Flat& b, const Flat& c, const Flat& d) {
  if (same(a, c) || same(a, d) || same(b, c) || same(b, d)) return false;
  return (area2(a, b, c) > 0.0) != (area2(a, b, d) > 0.0) && (area2(c, d, a) > 0.0) != (area2(c, d, b) > 0.0);
}

bool freeWay(const Flattened& flat, const Flat& from, const Flat& to, const Loop& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (crosses(from, to, flat(loop[i]), flat(loop[(i + 1) % loop.size()]))) return false;
  return true;
}

/// Joins a hole to the loop around it by a bridge there and back between two corners, the shortest that crosses neither.
void join(const Flattened& flat, Loop& around, const Loop& hole) {
  std::size_t best_a = 0, best_h = 0;
  double best = -1.0;
  bool best_free = false;
  for (std::size_t a = 0; a < around.size(); ++a)
    for (std::size_t h = 0; h < hole.size(); ++h) {
      const Flat p = flat(around[a]), q = flat(hole[h]);
      const double distance = (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
      if (best >= 0.0 && best_free && distance >= best) continue;
      const bool way = freeWay(flat, p, q, around) && freeWay(flat, p, q, hole);
      if (best >= 0.0 && !way && (best_free || distance >= best)) continue;
      best = distance, best_free = way, best_a = a, best_h = h;
    }
  Loop joined(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(best_a) + 1);
  for (std::size_t i = 0; i <= hole.size(); ++i) joined.push_back(hole[(best_h + i) % hole.size()]);
  joined.insert(joined.end(), around.begin() + static_cast<std::ptrdiff_t>(best_a), around.end());
  around = std::move(joined);
}

bool contains(const Flattened& flat, const Loop& loop, const Flat& p) {
  bool in = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Flat a = flat(loop[i]), b = flat(loop[(i + 1) % loop.size()]);
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) in = !in;
  }
  return in;
}

/// Newell's normal of a loop in space.
Vec3 normalOf(const std::vector<Vec3>& points, const Loop& loop) {
  Vec3 out;
  for (std::size_t i = 0; i < loop.size(); ++i) out = out + cross(points[loop[i]] - points[loop[0]], points[loop[(i + 1) % loop.size()]] - points[loop[0]]);
  return out;
}

}  // namespace

void fillLoop(const std::vector<Vec3>& points, const Loop& loop, std::uint16_t material, std::vector<Facet>& out) {
  if (loop.size() < 3) return;
  fill(Flattened(points, normalOf(points, loop)), loop, material, out);
}

void fillArea(const std::vector<Vec3>& points, std::vector<Loop> loops, const Vec3& normal, std::uint16_t material, std::vector<Facet>& out) {
  const Flattened flat(points, normal);
  std::vector<Loop> areas;
  std::vector<double> sizes;
  std::vector<Loop> holes;
  for (Loop& loop : loops) {
    const double size = area2(flat, loop);
    if (size >= 0.0) {
      areas.push_back(std::move(loop));
      sizes.push_back(size);
    } else {
      holes.push_back(std::move(loop));
    }
  }
  for (const Loop& hole : holes) {
    std::size_t around = areas.size();
    for (std::size_t i = 0; i < areas.size(); ++i)
      if ((around == areas.size() || sizes[i] < sizes[around]) && areas[i].size() + hole.size() <= kMostEars && contains(flat, areas[i], flat(hole.front()))) around = i;
    // A hole in nothing is filled the other way round, so that the surface stays closed.
    if (around == areas.size()) fill(flat, hole, material, out);
    else join(flat, areas[around], hole);
  }
  for (const Loop& area : areas) fill(flat, area, material, out);
}

std::vector<Loop> loopsOf(std::vector<Step> steps) {
  std::ranges::sort(steps, [](const Step& a, const Step& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
  std::vector<bool> used(steps.size(), false);
  const auto nextFrom = [&](std::uint32_t corner) {
    auto at = static_cast<std::size_t>(std::ranges::lower_bound(steps, corner, {}, &Step::from) - steps.begin());
    while (at < steps.size() && steps[at].from == corner && used[at]) ++at;
    return at < steps.size() && steps[at].from == corner ? at : steps.size();
  };
  std::vector<Loop> out;
  for (std::size_t start = 0; start < steps.size(); ++start) {
    if (used[start]) continue;
    Loop path{steps[start].from};
    std::size_t at = start;
    while (at < steps.size()) {
      used[at] = true;
      const std::uint32_t corner = steps[at].to;
      // Back at a corner of the path: what lies since then is a loop of its own.
      if (const auto met = std::ranges::find(path, corner); met != path.end()) {
        out.emplace_back(met, path.end());
        path.erase(met + 1, path.end());
      } else {
        path.push_back(corner);
      }
      at = nextFrom(path.back());
    }
  }
  return out;
}

}  // namespace npsee::fragments
