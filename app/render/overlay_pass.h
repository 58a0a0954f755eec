#pragma once

#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/world_strokes.h"

#include <npsee/preset.h>

#include <array>
#include <vector>

namespace npsee::render {

/// A corner of a coloured, see-through area in the world.
struct AreaVertex {
  std::array<float, 3> place;   ///< relative to the eye, m
  std::array<float, 4> colour;  ///< sRGB-coded, opacity
};

/// Lines, areas and the binoculars' mask over a mission, into the bound framebuffer.
class OverlayPass {
 public:
  static Expected<OverlayPass> create();

  /// Areas, three vertices a triangle, hidden by what is nearer; `view` has its eye at the origin. Air dims them.
  void drawAreas(const std::vector<AreaVertex>& vertices, const View& view, double extinction_per_m);
  /// Strokes; with `over_all` nothing hides them.
  void drawStrokes(const std::vector<StrokeVertex>& vertices, bool over_all);
  /// Everything outside a circle of that radius (pixels) around the picture's middle becomes dark.
  void drawMask(int width, int height, double radius_px);

 private:
  gl::Program stroke_, area_, mask_;
  gl::VertexArray stroke_attributes_, area_attributes_, nothing_;
  gl::Buffer stroke_vertices_, area_vertices_;
};

}  // namespace npsee::render
