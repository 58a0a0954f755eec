#include "editor/mission/contours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace npsee::editor {
namespace {

struct Corner {
  Place at;
  double height = 0.0;
};

/// Where a level crosses the side between two corners; the side must straddle it.
Place crossing(const Corner& a, const Corner& b, double level) {
  const double share = (level - a.height) / (b.height - a.height);
  return {a.at.x_m + share * (b.at.x_m - a.at.x_m), a.at.z_m + share * (b.at.z_m - a.at.z_m)};
}

/// Marching squares in one cell: up to two segments of a level.
void addLevel(const std::array<Corner, 4>& cell, double level, bool index, bool coast, std::vector<GroundMap::Segment>& out) {
  std::array<Place, 4> met;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Corner &a = cell[i], &b = cell[(i + 1) % 4];
    if ((a.height < level) != (b.height < level)) met[count++] = crossing(a, b, level);
  }
  if (count >= 2) out.push_back({met[0], met[1], index, coast});
  if (count == 4) out.push_back({met[2], met[3], index, coast});
}

}  // namespace

double contourInterval(double lowest, double highest, int lines) {
  const double wish = std::max(highest - lowest, 1e-6) / std::max(lines, 1);
  const double decade = std::pow(10.0, std::floor(std::log10(wish)));
  for (const double lead : {1.0, 2.0, 5.0})
    if (lead * decade >= wish) return std::max(lead * decade, 1.0);
  return std::max(10.0 * decade, 1.0);
}

GroundMap groundMap(const Terrain& terrain, const Place& from, const Place& to, int columns, int rows) {
  GroundMap out{from, to, std::max(columns, 2), std::max(rows, 2), {}, {}, {}, {}, 0.0};
  const double step_x = (to.x_m - from.x_m) / (out.columns - 1), step_z = (to.z_m - from.z_m) / (out.rows - 1);
  const double low = terrain.lowest(), span = std::max(terrain.highest() - low, 1.0);
  std::vector<double> heights;
  double seen_low = 1e300, seen_high = -1e300;
  for (int r = 0; r < out.rows; ++r)
    for (int c = 0; c < out.columns; ++c) {
      const double x = from.x_m + c * step_x, z = from.z_m + r * step_z, h = terrain.height(x, z);
      heights.push_back(h);
      seen_low = std::min(seen_low, h);
      seen_high = std::max(seen_high, h);
      const Vec3 n = terrain.normal(x, z);
      // Slopes are stretched, or most ground would look level from straight above.
      const double tilt = (-n.x - n.z) / std::max(n.y, 0.05);
      out.shade.push_back(static_cast<float>(std::clamp(0.5 + 1.6 * tilt / (1.0 + std::abs(3.0 * tilt)), 0.0, 1.0)));
      out.height.push_back(static_cast<float>(std::clamp((h - low) / span, 0.0, 1.0)));
      out.sea.push_back(terrain.sea(x, z) ? 1 : 0);
    }
  out.interval_m = contourInterval(seen_low, seen_high, 12);
  const double sea_level = terrain.seaLevel();
  const auto corner = [&](int c, int r) { return Corner{{from.x_m + c * step_x, from.z_m + r * step_z}, heights[static_cast<std::size_t>(r * out.columns + c)]}; };
  for (int r = 0; r + 1 < out.rows; ++r)
    for (int c = 0; c + 1 < out.columns; ++c) {
      const std::array<Corner, 4> cell{corner(c, r), corner(c + 1, r), corner(c + 1, r + 1), corner(c, r + 1)};
      const auto [least, most] = std::ranges::minmax(cell, {}, &Corner::height);
      const auto first = static_cast<long>(std::floor(least.height / out.interval_m)) + 1;
      const auto last = static_cast<long>(std::floor(most.height / out.interval_m));
      for (long i = first; i <= last; ++i) {
        const double level = static_cast<double>(i) * out.interval_m;
        if (level > sea_level) addLevel(cell, level, i % 5 == 0, false, out.contours);
      }
      if (least.height < sea_level && most.height >= sea_level) addLevel(cell, sea_level, false, true, out.contours);
    }
  return out;
}

}  // namespace npsee::editor
