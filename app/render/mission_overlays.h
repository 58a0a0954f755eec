#pragma once

#include "app/render/mission_scene.h"
#include "app/render/world_strokes.h"

#include <npsee/weapons.h>

#include <vector>

namespace npsee::render {

/// What lies over a mission's picture.
struct OverlayDrawing {
  std::vector<WorldStroke> ground;     ///< hidden by hills as their styles say
  std::vector<ScreenStroke> screen;    ///< in front of everything
};

/// Lines and marks of a moment. `marks` are those of the same picture.
OverlayDrawing overlaysOf(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const std::vector<MissionMark>& marks, const Weapons& weapons);

/// Places of everything in a picture, in order of kind and index.
std::vector<MissionMark> marksOf(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye);

/// Mil scale of the binoculars: ticks every 5 and 10 mil across and up from the middle, and the azimuth looked along.
std::vector<ScreenStroke> reticleOf(const MissionEye& eye, double field_mil, bool night);
/// Pixels from the picture's middle to what lies that many mils off the line of sight.
double pixelsOfMil(const MissionEye& eye, double mil);

/// A corner of a coloured area in the world.
struct GroundCorner {
  Vec3 at;
  std::array<float, 4> colour;
};

/// What an observer sees of the ground around him, as coloured areas: green where a man would stand clear of every crest between,
/// amber where barely, red where the ground hides him. Three corners a triangle.
std::vector<GroundCorner> sightFan(const Terrain& terrain, const Vec3& eye, double range_m);

/// Burnt ground where shells have burst, three corners a triangle; at most the last few hundred.
std::vector<GroundCorner> scorchMarks(const Recording& recording, double time_s, const MissionEye& eye);

}  // namespace npsee::render
