#pragma once

#include "app/gl/program.h"
#include "app/render/camera.h"

namespace npsee::render {

/// A camera turned into what shaders want.
struct View {
  float view_projection[16] = {};  ///< world to clip, column-major
  Vec3 eye, right, up, back;       ///< world; the axes are unit vectors
  Vec3 ray_origin, ray_x, ray_y;   ///< world direction through the picture's lower left corner, and its change per pixel
  double metre_per_pixel = 0.0;    ///< metres a pixel spans at a distance of one metre
  double distance_m = 0.0;         ///< eye to reference point

  /// Depth along the viewing direction, m.
  double depthOf(double x, double y, double z) const { return -dot(back, Vec3{x, y, z} - eye); }

  friend bool operator==(const View&, const View&) = default;
};

/// View of a picture of `width` x `height` pixels.
View makeView(const Camera& camera, int width, int height);

/// Sets the uniforms that a program asks for: u_view_projection, u_eye, u_right, u_up, u_back, u_metre_per_pixel, u_ray_*.
void setView(const gl::Program& program, const View& view);

/// Sets a vec3 uniform.
void setVec3(const gl::Program& program, const char* uniform, const Vec3& value);

}  // namespace npsee::render
