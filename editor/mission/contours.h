#pragma once

#include <npsee/scenario.h>
#include <npsee/terrain.h>

#include <vector>

namespace npsee::editor {

/// A part of the ground as a map draws it: relief on a coarse grid and contour lines.
struct GroundMap {
  Place from, to;               ///< north-west and south-east corner
  int columns = 0, rows = 0;    ///< samples of `shade`, both corners included
  std::vector<float> shade;     ///< 0..1: light from the north-west, 0.5 on level ground
  std::vector<float> height;    ///< 0..1 between the terrain's lowest and highest
  std::vector<std::uint8_t> sea;
  struct Segment {
    Place a, b;
    bool index = false;         ///< every fifth line is drawn stronger
    bool coast = false;
  };
  std::vector<Segment> contours;
  double interval_m = 0.0;
};

/// The map of a rectangle, which may reach beyond the world. `columns` and `rows` at least 2.
GroundMap groundMap(const Terrain& terrain, const Place& from, const Place& to, int columns, int rows);

/// Contour interval for heights between two limits: 1, 2 or 5 times a power of ten, at most `lines` of them.
double contourInterval(double lowest_m, double highest_m, int lines);

}  // namespace npsee::editor
