#pragma once

#include <npsee/preset.h>

#include <array>
#include <vector>

namespace npsee::render {

/// How a line or a dot is drawn. Where something lies before it its opacity is multiplied by `hidden`.
struct StrokeStyle {
  Colour colour;
  double width_px = 1.5;  ///< of a line, or diameter of a dot
  double opacity = 1.0;
  double hidden = 0.3;
  double dash_px = 0.0;   ///< length of dashes and gaps; 0 = unbroken
};

/// A corner of a line in the picture.
struct StrokePoint {
  double x = 0.0, y = 0.0;            ///< pixels from the upper left
  double clip_z = 0.0, clip_w = 1.0;  ///< of its place in clip space, for the depth
};

/// A stroke's corner, ready for the screen: expanded to its width, so that GL draws triangles only.
struct StrokeVertex {
  std::array<float, 4> clip;
  std::array<float, 2> offset;   ///< pixels from the middle of the line (0, across) or of the dot
  float half_width = 0.0f;       ///< pixels
  float dash_px = 0.0f, along_px = 0.0f;
  std::array<float, 4> colour;   ///< sRGB-coded, opacity
  float hidden = 0.0f;
};

/// Turns lines and dots of a picture into triangles, three vertices each, that are appended to `out`.
class StrokeBuilder {
 public:
  /// Size of the picture in pixels. `out` must outlive the builder.
  StrokeBuilder(int width, int height, std::vector<StrokeVertex>& out) : width_(width), height_(height), out_(out) {}

  /// One point is a dot, more are a line; that of a `closed` line ends at its first point and is joined there.
  void add(const std::vector<StrokePoint>& points, const StrokeStyle& style, bool closed = false);

 private:
  StrokeVertex vertex(const StrokePoint& at, double moved_x, double moved_y, double offset_x, double offset_y, const StrokeStyle& style) const;
  void addQuad(const StrokeVertex& a, const StrokeVertex& b, const StrokeVertex& c, const StrokeVertex& d);
  void addDot(const StrokePoint& at, const StrokeStyle& style);
  void addLine(const std::vector<StrokePoint>& points, const StrokeStyle& style, bool closed);

  double width_, height_;
  std::vector<StrokeVertex>& out_;
};

}  // namespace npsee::render
