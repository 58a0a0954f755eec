#include "sim/world/erosion.h"

#include "sim/world/noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

namespace npsee::world {
namespace {

constexpr double kDiagonal = 1.4142135623730951;
/// Added to the area: no water gathers on the very crest, where bare rivers would make walls.
constexpr double kCrestArea = 0.004;
constexpr double kCreep = 0.06;
constexpr std::uint32_t kUnevenness = 0x5bd1e995u;

struct Step {
  int columns, rows;
  double length;
};
constexpr std::array<Step, 8> kSteps{{{-1, -1, kDiagonal}, {0, -1, 1.0}, {1, -1, kDiagonal}, {-1, 0, 1.0}, {1, 0, 1.0}, {-1, 1, kDiagonal}, {0, 1, 1.0}, {1, 1, kDiagonal}}};

template <class Visit>
void eachNeighbour(const Landscape& land, std::uint32_t at, const Visit& visit) {
  const int c = static_cast<int>(at) % land.columns, r = static_cast<int>(at) / land.columns;
  for (const Step& step : kSteps) {
    const int nc = c + step.columns, nr = r + step.rows;
    if (nc < 0 || nr < 0 || nc >= land.columns || nr >= land.rows) continue;
    visit(static_cast<std::uint32_t>(nr * land.columns + nc), step.length);
  }
}

/// Height that water must reach to flow out, and the order in which it is reached; `receiver` becomes the neighbour it came from.
std::vector<double> flooded(const Landscape& land, Drainage& drainage) {
  using Entry = std::pair<double, std::uint32_t>;
  std::vector<Entry> storage;
  storage.reserve(land.size());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open(std::greater<>{}, std::move(storage));
  std::vector<double> level(land.size(), -1.0);
  std::vector<std::uint8_t> reached(land.size(), 0);
  for (std::uint32_t i = 0; i < land.size(); ++i) {
    if (land.outlet[i] == 0) continue;
    level[i] = land.height[i];
    drainage.receiver[i] = i;
    reached[i] = 1;
    open.emplace(level[i], i);
  }
  while (!open.empty()) {
    const auto [height, at] = open.top();
    open.pop();
    drainage.order.push_back(at);
    eachNeighbour(land, at, [&, height = height, at = at](std::uint32_t n, double) {
      if (reached[n] != 0) return;
      reached[n] = 1;
      level[n] = std::max(land.height[n], height);
      drainage.receiver[n] = at;
      open.emplace(level[n], n);
    });
  }
  return level;
}

void creep(Landscape& land) {
  std::vector<double> row_above(static_cast<std::size_t>(land.columns)), row(static_cast<std::size_t>(land.columns));
  for (int r = 1; r + 1 < land.rows; ++r) {
    for (int c = 0; c < land.columns; ++c) row[static_cast<std::size_t>(c)] = land.height[land.index(c, r)];
    if (r == 1)
      for (int c = 0; c < land.columns; ++c) row_above[static_cast<std::size_t>(c)] = land.height[land.index(c, 0)];
    for (int c = 1; c + 1 < land.columns; ++c) {
      const std::size_t i = land.index(c, r), k = static_cast<std::size_t>(c);
      if (land.outlet[i] != 0) continue;
      land.height[i] += kCreep * (row[k - 1] + row[k + 1] + row_above[k] + land.height[land.index(c, r + 1)] - 4.0 * row[k]);
    }
    row_above.swap(row);
  }
}

}  // namespace

Drainage drainageOf(const Landscape& land) {
  Drainage drainage;
  drainage.order.reserve(land.size());
  drainage.receiver.assign(land.size(), 0);
  const std::vector<double> level = flooded(land, drainage);
  for (const std::uint32_t at : drainage.order) {
    if (land.outlet[at] != 0) continue;
    double steepest = 0.0;
    eachNeighbour(land, at, [&](std::uint32_t n, double distance) {
      // Ground is uneven: without it all water would run in the grid's eight directions.
      const double chance = (latticeBits(kUnevenness, static_cast<std::int32_t>(at), static_cast<std::int32_t>(n)) >> 8) / 16777216.0;
      const double slope = (level[at] - level[n]) / distance * (0.6 + 0.8 * chance);
      if (slope <= steepest) return;
      steepest = slope;
      drainage.receiver[at] = n;
    });
  }
  drainage.area.assign(land.size(), land.spacing * land.spacing);
  for (auto at = drainage.order.rbegin(); at != drainage.order.rend(); ++at)
    if (drainage.receiver[*at] != *at) drainage.area[drainage.receiver[*at]] += drainage.area[*at];
  return drainage;
}

void erode(Landscape& land, int steps, double dt) {
  for (int step = 0; step < steps; ++step) {
    const Drainage drainage = drainageOf(land);
    for (const std::uint32_t at : drainage.order) {
      const std::uint32_t below = drainage.receiver[at];
      if (below == at) continue;
      const bool straight = below + 1 == at || at + 1 == below || below + static_cast<std::uint32_t>(land.columns) == at || at + static_cast<std::uint32_t>(land.columns) == below;
      const double distance = land.spacing * (straight ? 1.0 : kDiagonal);
      const double cut = dt * std::sqrt(drainage.area[at] + kCrestArea) / (land.hardness[at] * distance);
      land.height[at] = (land.height[at] + dt * land.uplift[at] + cut * land.height[below]) / (1.0 + cut);
    }
    creep(land);
  }
}

Landscape resampled(const Landscape& land, int columns, int rows) {
  Landscape out;
  out.columns = columns;
  out.rows = rows;
  out.spacing = land.spacing * (land.columns - 1) / (columns - 1);
  out.height.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int r = 0; r < rows; ++r) {
    const double gz = static_cast<double>(r) * (land.rows - 1) / (rows - 1);
    const int r0 = std::min(static_cast<int>(gz), land.rows - 2);
    for (int c = 0; c < columns; ++c) {
      const double gx = static_cast<double>(c) * (land.columns - 1) / (columns - 1);
      const int c0 = std::min(static_cast<int>(gx), land.columns - 2);
      const double u = gx - c0, v = gz - r0;
      const double north = land.height[land.index(c0, r0)] * (1.0 - u) + land.height[land.index(c0 + 1, r0)] * u;
      const double south = land.height[land.index(c0, r0 + 1)] * (1.0 - u) + land.height[land.index(c0 + 1, r0 + 1)] * u;
      out.height[out.index(c, r)] = north * (1.0 - v) + south * v;
    }
  }
  return out;
}

}  // namespace npsee::world
