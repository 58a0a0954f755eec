#pragma once

#include "app/gl/objects.h"
#include "app/gl/program.h"
#include "app/render/view.h"

#include <array>
#include <vector>

namespace npsee::render {

/// A corner of a coloured, see-through area in the world.
struct AreaVertex {
  std::array<float, 3> place;   ///< relative to the eye, m
  std::array<float, 4> colour;  ///< sRGB-coded, opacity
};

/// Areas and the binoculars' mask over a mission, into the bound framebuffer.
class OverlayPass {
 public:
  static Expected<OverlayPass> create();

  /// Areas, three vertices a triangle, hidden by what is nearer; `view` has its eye at the origin. Air dims them.
  void drawAreas(const std::vector<AreaVertex>& vertices, const View& view, double extinction_per_m);
  /// Everything outside a circle of that radius (pixels) around the picture's middle becomes dark.
  void drawMask(int width, int height, double radius_px);

 private:
  gl::Program area_, mask_;
  gl::VertexArray area_attributes_, nothing_;
  gl::Buffer area_vertices_;
};

}  // namespace npsee::render
