#pragma once

#include "app/render/mission_camera.h"
#include "app/render/strokes.h"

#include <string_view>
#include <utility>
#include <vector>

namespace npsee::render {

/// A polyline in the world, or, with one point, a dot; drawn with a width in pixels. Parts behind hills are drawn with the opacity
/// times `style.hidden`.
struct WorldStroke {
  std::vector<Vec3> points;
  StrokeStyle style;
  double nearer = 0.0;  ///< share of the distance by which it is drawn before its place: lines on the ground must not sink into it
};

/// A polyline or dot on the picture, pixels from the upper left, in front of everything.
struct ScreenStroke {
  std::vector<std::pair<double, double>> points;
  StrokeStyle style;
};

/// Triangles for a StrokePass; lines are cut at the near plane.
void addStrokes(const std::vector<WorldStroke>& strokes, const MissionEye& eye, std::vector<StrokeVertex>& out);
void addStrokes(const std::vector<ScreenStroke>& strokes, int width, int height, std::vector<StrokeVertex>& out);

/// Strokes of a text in capitals, digits and . , - + / : with the letters' height in pixels, its lower left corner or, if `centred`,
/// the middle of its lower edge at (x, y).
void addText(std::string_view text, double x, double y, double height_px, bool centred, const StrokeStyle& style, std::vector<ScreenStroke>& out);

}  // namespace npsee::render
