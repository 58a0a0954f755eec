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

/// A camera given by its axes and planes instead of a reference point.
struct Lens {
  Vec3 eye;
  Vec3 right{1.0, 0.0, 0.0}, up{0.0, 1.0, 0.0}, back{0.0, 0.0, 1.0};  ///< unit vectors; back is towards the eye
  double fov_y_rad = 0.7;
  double near_m = 0.5, far_m = 4e5;
  double aside_x = 0.0, aside_y = 0.0;  ///< what is seen moves to the right and up by this share of half the picture
  friend bool operator==(const Lens&, const Lens&) = default;
};
View makeView(const Lens& lens, int width, int height);

/// View of a picture of `width` x `height` pixels.
View makeView(const Camera& camera, int width, int height);

/// Sets the uniforms that a program asks for: u_view_projection, u_eye, u_right, u_up, u_back, u_metre_per_pixel, u_ray_*.
void setView(const gl::Program& program, const View& view);

/// Sets a vec3 uniform.
void setVec3(const gl::Program& program, const char* uniform, const Vec3& value);

}  // namespace npsee::render
