#pragma once

#include <npsee/terrain.h>
#include <npsee/vec3.h>

#include <vector>

namespace npsee::editor {

/// A line between two picked points of the ground.
struct Ruler {
  bool active = false;     ///< clicks set its ends
  int points = 0;          ///< how many of them are set
  Vec3 from, to;
  double eye_m = 2.5;      ///< heights over the ground between which sight is tested
  double target_m = 2.0;
  bool complete() const { return points == 2; }
  /// Sets the next end; a third click starts a new line.
  void pick(const Vec3& ground);
};

/// What the ruler reads.
struct RulerReading {
  double level_m = 0.0, slope_m = 0.0;       ///< distances
  double height_m = 0.0;                     ///< of the far end over the near one
  double azimuth_mil = 0.0, back_azimuth_mil = 0.0;
  double elevation_mil = 0.0;                ///< of the far end seen from the near one
  std::vector<ProfilePoint> profile;         ///< at even steps, both ends included
  Sight sight;                               ///< from eye to target height
};
/// Reads the ruler on the ground; `samples` at least 2.
RulerReading readRuler(const Ruler& ruler, const Terrain& terrain, int samples);

}  // namespace npsee::editor
