#pragma once

#include "sim/world/passable.h"

#include <cstdint>
#include <list>
#include <vector>

namespace npsee::world {

/// Ways around water, cliffs and the edge, for vehicles whose straight way is barred. Coarse: at most 400 cells along the world's longer side.
class Router {
 public:
  explicit Router(const Passable& passable) : passable_(passable) {}

  /// Corners to drive to in turn, the goal last; empty if it cannot be reached. Depends on its arguments only.
  std::vector<Place> route(Medium medium, const Place& from, const Place& goal);
  /// Whether the straight way is free, but for its last `slack_m`.
  bool straight(Medium medium, const Place& from, const Place& to, double slack_m) const;

 private:
  /// For every cell the neighbour through which the way to one goal leads.
  struct Field {
    Medium medium;
    std::int32_t goal;
    std::vector<std::int32_t> next;
  };
  void layOut();
  const std::vector<std::uint8_t>& open(Medium medium);
  std::int32_t nearestOpen(Medium medium, const Place& place);
  const Field& field(Medium medium, std::int32_t goal);
  Place centre(std::int32_t cell) const {
    const std::int32_t column = cell % columns_, row = cell / columns_;
    return {(column + 0.5) * cell_x_, (row + 0.5) * cell_z_};
  }

  const Passable& passable_;
  int columns_ = 0, rows_ = 0;
  double cell_x_ = 0.0, cell_z_ = 0.0;
  std::vector<std::uint8_t> open_[4];  ///< by medium, made when first needed
  std::list<Field> fields_;            ///< the last ones asked for, newest first
};

}  // namespace npsee::world
