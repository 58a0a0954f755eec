#include "sim/world/route.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace npsee::world {
namespace {

constexpr double kCellsAlong = 400.0, kFinest_m = 30.0;
constexpr std::size_t kFieldsKept = 32;
/// How far a goal or a start may lie from an open cell, cells.
constexpr int kSearch = 4;
/// Within this of its goal a vehicle may stop, m.
constexpr double kNear_m = 30.0;

constexpr int kStepX[] = {-1, 0, 1, -1, 1, -1, 0, 1}, kStepZ[] = {-1, -1, -1, 0, 0, 1, 1, 1};

double distanceBetween(const Place& a, const Place& b) {
  const double dx = b.x_m - a.x_m, dz = b.z_m - a.z_m;
  return std::sqrt(dx * dx + dz * dz);
}

}  // namespace

void Router::layOut() {
  if (columns_ > 0) return;
  const Terrain& terrain = passable_.terrain();
  const double cell = std::max(kFinest_m, std::max(terrain.sizeX(), terrain.sizeZ()) / kCellsAlong);
  columns_ = std::max(1, static_cast<int>(terrain.sizeX() / cell));
  rows_ = std::max(1, static_cast<int>(terrain.sizeZ() / cell));
  cell_x_ = terrain.sizeX() / columns_;
  cell_z_ = terrain.sizeZ() / rows_;
}

const std::vector<std::uint8_t>& Router::open(Medium medium) {
  layOut();
  std::vector<std::uint8_t>& cells = open_[static_cast<std::size_t>(medium)];
  if (!cells.empty()) return cells;
  cells.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (std::int32_t cell = 0; cell < columns_ * rows_; ++cell) {
    const Place p = centre(cell);
    const double dx = 0.33 * cell_x_, dz = 0.33 * cell_z_;
    cells[static_cast<std::size_t>(cell)] = passable_.good(medium, p.x_m, p.z_m) && passable_.good(medium, p.x_m - dx, p.z_m - dz) && passable_.good(medium, p.x_m + dx, p.z_m - dz) &&
                                            passable_.good(medium, p.x_m - dx, p.z_m + dz) && passable_.good(medium, p.x_m + dx, p.z_m + dz);
  }
  return cells;
}

std::int32_t Router::nearestOpen(Medium medium, const Place& place) {
  const auto& cells = open(medium);
  const int column = std::clamp(static_cast<int>(place.x_m / cell_x_), 0, columns_ - 1), row = std::clamp(static_cast<int>(place.z_m / cell_z_), 0, rows_ - 1);
  std::int32_t best = -1;
  double least = INFINITY;
  for (int r = std::max(0, row - kSearch); r <= std::min(rows_ - 1, row + kSearch); ++r)
    for (int c = std::max(0, column - kSearch); c <= std::min(columns_ - 1, column + kSearch); ++c) {
      const std::int32_t cell = r * columns_ + c;
      const double away = distanceBetween(centre(cell), place);
      if (cells[static_cast<std::size_t>(cell)] == 0 || away >= least) continue;
      least = away;
      best = cell;
    }
  return best;
}

const Router::Field& Router::field(Medium medium, std::int32_t goal) {
  const auto known = std::find_if(fields_.begin(), fields_.end(), [&](const Field& f) { return f.medium == medium && f.goal == goal; });
  if (known != fields_.end()) {
    fields_.splice(fields_.begin(), fields_, known);
    return fields_.front();
  }
  if (fields_.size() >= kFieldsKept) fields_.pop_back();
  const auto& cells = open(medium);
  Field& out = fields_.emplace_front(Field{medium, goal, std::vector<std::int32_t>(cells.size(), -1)});
  // Dijkstra from the goal: one field serves every vehicle that drives there.
  std::vector<double> cost(cells.size(), INFINITY);
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  cost[static_cast<std::size_t>(goal)] = 0.0;
  out.next[static_cast<std::size_t>(goal)] = goal;
  queue.emplace(0.0, goal);
  const double diagonal = std::sqrt(cell_x_ * cell_x_ + cell_z_ * cell_z_);
  while (!queue.empty()) {
    const auto [here, cell] = queue.top();
    queue.pop();
    if (here > cost[static_cast<std::size_t>(cell)]) continue;
    const int column = cell % columns_, row = cell / columns_;
    for (int k = 0; k < 8; ++k) {
      const int c = column + kStepX[k], r = row + kStepZ[k];
      if (c < 0 || r < 0 || c >= columns_ || r >= rows_) continue;
      const auto n = static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
      // A diagonal step needs both cells beside it: vehicles do not squeeze through corners.
      if (cells[n] == 0 || cells[static_cast<std::size_t>(row * columns_ + c)] == 0 || cells[static_cast<std::size_t>(r * columns_ + column)] == 0) continue;
      const double there = here + (kStepX[k] != 0 && kStepZ[k] != 0 ? diagonal : kStepX[k] != 0 ? cell_x_ : cell_z_);
      if (there >= cost[n]) continue;
      cost[n] = there;
      out.next[n] = cell;
      queue.emplace(there, static_cast<std::int32_t>(n));
    }
  }
  return out;
}

bool Router::straight(Medium medium, const Place& from, const Place& to, double slack_m) const {
  const double distance = distanceBetween(from, to);
  const Pose pose{from.x_m, from.z_m, azimuthTo(from.x_m, from.z_m, to.x_m, to.z_m), 0.0};
  return passable_.freeLength(medium, pose, 0.0, distance) >= distance - slack_m;
}

std::vector<Place> Router::route(Medium medium, const Place& from, const Place& goal) {
  if (straight(medium, from, goal, kNear_m)) return {goal};
  const std::int32_t start = nearestOpen(medium, from), end = nearestOpen(medium, goal);
  if (start < 0 || end < 0) return {};
  const std::vector<std::int32_t>& next = field(medium, end).next;
  if (next[static_cast<std::size_t>(start)] < 0) return {};
  std::vector<Place> cells{from};
  for (std::int32_t cell = start;; cell = next[static_cast<std::size_t>(cell)]) {
    cells.push_back(centre(cell));
    if (cell == end) break;
  }
  cells.push_back(goal);
  // Pulled tight: from each corner to the farthest cell that is seen along a free way.
  std::vector<Place> corners;
  for (std::size_t at = 0; at + 1 < cells.size();) {
    std::size_t reach = at + 1;
    for (std::size_t stride = 1; stride > 0 && reach + 1 < cells.size();) {
      const std::size_t wanted = std::min(reach + stride, cells.size() - 1);
      const bool free = straight(medium, cells[at], cells[wanted], wanted + 1 == cells.size() ? kNear_m : 0.0);
      if (free) reach = wanted;
      stride = free ? stride * 2 : stride / 2;
    }
    corners.push_back(cells[reach]);
    at = reach;
  }
  return corners;
}

}  // namespace npsee::world
