#include "sim/fragments/cut.h"

#include "sim/fragments/polygon.h"

#include <algorithm>
#include <cmath>

namespace npsee::fragments {
namespace {

/// The cut through one edge.
struct Crossing {
  std::uint32_t low, high, point;
};

class Cut {
 public:
  Cut(const Solid& solid, const Plane& plane, double snap_m) : solid_(solid), points_(solid.points), normal_(plane.normal) {
    height_.reserve(points_.size());
    for (const Vec3& point : solid.points) {
      const double height = dot(plane.normal, point) - plane.offset;
      height_.push_back(std::fabs(height) <= snap_m ? 0.0 : height);
    }
    findCrossings();
  }

  Halves run() {
    for (const Facet& facet : solid_.facets) take(facet);
    std::vector<Facet> cap;
    fillArea(points_, loopsOf(std::move(rim_)), -1.0 * normal_, kTorn, cap);
    for (const Facet& facet : cap) {
      above_.push_back(facet);
      below_.push_back({{facet.corners[0], facet.corners[2], facet.corners[1]}, kTorn});
    }
    return {withOwnPoints(below_), withOwnPoints(above_)};
  }

 private:
  bool isAbove(std::uint32_t point) const { return height_[point] >= 0.0; }

  /// One point for every edge that passes through the plane, whichever facets use it: the cut has no cracks.
  void findCrossings() {
    for (const Facet& facet : solid_.facets)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = facet.corners[k], b = facet.corners[(k + 1) % 3];
        if (isAbove(a) != isAbove(b)) crossings_.push_back({std::min(a, b), std::max(a, b), 0});
      }
    const auto order = [](const Crossing& a, const Crossing& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; };
    std::ranges::sort(crossings_, order);
    // Not of std::ranges: clang 14, which builds the fuzzers, cannot compile the subrange that its unique returns.
    const auto same = [](const Crossing& a, const Crossing& b) { return a.low == b.low && a.high == b.high; };
    crossings_.erase(std::unique(crossings_.begin(), crossings_.end(), same), crossings_.end());
    for (Crossing& crossing : crossings_) {
      const double low = height_[crossing.low], high = height_[crossing.high];
      // A corner on the plane is its own crossing.
      if (low == 0.0 || high == 0.0) {
        crossing.point = low == 0.0 ? crossing.low : crossing.high;
        continue;
      }
      crossing.point = static_cast<std::uint32_t>(points_.size());
      const Vec3 a = points_[crossing.low], b = points_[crossing.high];
      points_.push_back(a + (low / (low - high)) * (b - a));
    }
  }

  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) const {
    const Crossing wanted{std::min(a, b), std::max(a, b), 0};
    return std::ranges::lower_bound(crossings_, wanted, [](const Crossing& p, const Crossing& q) { return p.low != q.low ? p.low < q.low : p.high < q.high; })->point;
  }

  void add(bool above, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint16_t material) {
    // Without area, and its edges cancel: nothing is lost.
    if (a == b || b == c || c == a) return;
    (above ? above_ : below_).push_back({{a, b, c}, material});
  }

  void take(const Facet& facet) {
    const auto& c = facet.corners;
    const bool side[3] = {isAbove(c[0]), isAbove(c[1]), isAbove(c[2])};
    if (side[0] == side[1] && side[1] == side[2]) return add(side[0], c[0], c[1], c[2], facet.material);
    const std::size_t lone = side[1] == side[2] ? 0 : side[0] == side[2] ? 1 : 2;
    const std::uint32_t a = c[lone], b = c[(lone + 1) % 3], d = c[(lone + 2) % 3];
    const std::uint32_t p = crossing(a, b), q = crossing(a, d);
    add(side[lone], a, p, q, facet.material);
    add(!side[lone], p, b, d, facet.material);
    add(!side[lone], p, d, q, facet.material);
    // The cap of the upper half goes along the cut the other way round.
    if (p != q) rim_.push_back(side[lone] ? Step{q, p} : Step{p, q});
  }

  Solid withOwnPoints(std::vector<Facet>& facets) const {
    Solid out;
    constexpr std::uint32_t kNone = 0xffffffffu;
    std::vector<std::uint32_t> own(points_.size(), kNone);
    for (Facet& facet : facets)
      for (std::uint32_t& corner : facet.corners) {
        if (own[corner] == kNone) {
          own[corner] = static_cast<std::uint32_t>(out.points.size());
          out.points.push_back(points_[corner]);
        }
        corner = own[corner];
      }
    out.facets = std::move(facets);
    return out;
  }

  const Solid& solid_;
  std::vector<Vec3> points_;
  Vec3 normal_;
  std::vector<double> height_;
  std::vector<Crossing> crossings_;
  std::vector<Step> rim_;  ///< of the upper half's cap
  std::vector<Facet> below_, above_;
};

}  // namespace

Halves cutBy(const Solid& solid, const Plane& plane, double snap_m) { return Cut(solid, plane, snap_m).run(); }

}  // namespace npsee::fragments
