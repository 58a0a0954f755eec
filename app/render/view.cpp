#include "app/render/view.h"

#include "app/gl/state.h"
#include "app/render/ground_level.h"

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

Vec3 unit(const Vec3& v, const Vec3& otherwise) {
  const double size = length(v);
  return size > 1e-12 ? (1.0 / size) * v : otherwise;
}

/// Rows of clip = matrix * (x, y, z, 1), row by row.
struct Rows {
  double m[4][4];
};

Rows perspective(const View& view, double tan_x, double tan_y, double near_m, double far_m) {
  const auto row = [&](const Vec3& axis, double scale, double offset, double* out) {
    out[0] = scale * axis.x;
    out[1] = scale * axis.y;
    out[2] = scale * axis.z;
    out[3] = -scale * dot(axis, view.eye) + offset;
  };
  Rows rows{};
  row(view.right, 1.0 / tan_x, 0.0, rows.m[0]);
  row(view.up, 1.0 / tan_y, 0.0, rows.m[1]);
  row(view.back, -(far_m + near_m) / (far_m - near_m), -2.0 * far_m * near_m / (far_m - near_m), rows.m[2]);
  row(view.back, -1.0, 0.0, rows.m[3]);
  return rows;
}

}  // namespace

View makeView(const Lens& lens, int width, int height) {
  View view;
  view.eye = lens.eye;
  view.right = lens.right;
  view.up = lens.up;
  view.back = lens.back;
  const double tan_y = std::tan(0.5 * lens.fov_y_rad);
  const double tan_x = tan_y * width / height;
  view.metre_per_pixel = 2.0 * tan_y / height;
  view.ray_x = view.metre_per_pixel * view.right;
  view.ray_y = view.metre_per_pixel * view.up;
  view.ray_origin = -0.5 * width * view.ray_x + (-0.5 * height) * view.ray_y - view.back;
  Rows rows = perspective(view, tan_x, tan_y, lens.near_m, lens.far_m);
  if (lens.aside_x != 0.0 || lens.aside_y != 0.0) {
    // A place on the picture is clip.xy / clip.w: moving it aside adds a share of the last row.
    for (int column = 0; column < 4; ++column) {
      rows.m[0][column] += lens.aside_x * rows.m[3][column];
      rows.m[1][column] += lens.aside_y * rows.m[3][column];
    }
    view.ray_origin = view.ray_origin - (0.5 * width * lens.aside_x) * view.ray_x - (0.5 * height * lens.aside_y) * view.ray_y;
  }
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) view.view_projection[4 * column + row] = static_cast<float>(rows.m[row][column]);
  return view;
}

View makeView(const Camera& camera, int width, int height) {
  Lens lens;
  lens.eye = camera.eye;
  lens.back = unit(camera.eye - camera.target, {0.0, 0.0, 1.0});
  // Looking straight up or down, north (-z) is up in the picture.
  const Vec3 upward = std::abs(lens.back.y) > 0.99999 ? Vec3{0.0, 0.0, -1.0} : Vec3{0.0, 1.0, 0.0};
  lens.right = unit(cross(upward, lens.back), {1.0, 0.0, 0.0});
  lens.up = cross(lens.back, lens.right);
  lens.fov_y_rad = camera.fov_y_rad;
  // The near plane follows the distance, so that depth keeps its precision where the effect is.
  const double distance_m = std::max(length(camera.target - camera.eye), 1e-3);
  lens.near_m = std::clamp(0.01 * distance_m, 0.02, 20.0);
  lens.far_m = 1e6 * lens.near_m;
  View view = makeView(lens, width, height);
  view.distance_m = distance_m;
  return view;
}

void setVec3(const gl::Program& program, const char* uniform, const Vec3& value) {
  program.set(uniform, static_cast<float>(value.x), static_cast<float>(value.y), static_cast<float>(value.z));
}

void setView(const gl::Program& program, const View& view) {
  program.setMatrix("u_view_projection", view.view_projection);
  setVec3(program, "u_eye", view.eye);
  setVec3(program, "u_right", view.right);
  setVec3(program, "u_up", view.up);
  setVec3(program, "u_back", view.back);
  setVec3(program, "u_ray_origin", view.ray_origin);
  setVec3(program, "u_ray_x", view.ray_x);
  setVec3(program, "u_ray_y", view.ray_y);
  program.set("u_metre_per_pixel", static_cast<float>(view.metre_per_pixel));
}

void setGround(const gl::Program& program, const View& view, const GroundLevel& ground) {
  const double side = !ground.solid ? 0.0 : view.eye.y >= ground.height_m ? 1.0 : -1.0;
  program.set("u_ground", static_cast<float>(ground.height_m));
  program.set("u_slope", static_cast<float>(ground.slope_x), static_cast<float>(ground.slope_z));
  program.set("u_clip", static_cast<float>(side), static_cast<float>(ground.height_m));
  program.set("u_fade", ground.fades ? 1.0f : 0.0f);
  setVec3(program, "u_daylight", ground.hour.daylight);
  setKey(program, ground.hour.towards_key, ground.hour.key);
  program.set("u_dimmed", static_cast<float>(ground.dimmed));
  program.set("u_haze_extinction", static_cast<float>(ground.extinction_per_m));
  setVec3(program, "u_haze_colour", ground.haze);
  setGlow(program, ground.glow);
  if (ground.solid) glEnable(GL_CLIP_DISTANCE0);
  else glDisable(GL_CLIP_DISTANCE0);
}

void layOnGround(const gl::Program& program, const View& view, const GroundLevel& ground) {
  gl::blendOver();
  if (ground.shadow_nearer > 0.0) glEnable(GL_DEPTH_TEST);
  else glDisable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  program.use();
  setView(program, view);
  setGround(program, view, ground);
  // What is drawn is the ground itself: rounding must not cut it off.
  glDisable(GL_CLIP_DISTANCE0);
  program.set("u_nearer", static_cast<float>(ground.shadow_nearer));
}

}  // namespace npsee::render
