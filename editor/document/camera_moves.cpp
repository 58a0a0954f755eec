#include "editor/document/camera_moves.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {
namespace {

using render::Camera;

constexpr double kNearest_m = 0.05, kFarthest_m = 50000.0;
constexpr double kSteepest_rad = 1.5533430342749532;  // 89 deg: at the pole "up" has no direction in the picture

struct ViewAxes {
  Vec3 forward, right, up;
};

Vec3 normalised(const Vec3& v) {
  const double l = length(v);
  return l > 0.0 ? (1.0 / l) * v : Vec3{0.0, 0.0, -1.0};
}

ViewAxes frameOf(const Camera& camera) {
  const Vec3 forward = normalised(camera.target - camera.eye);
  Vec3 right = cross(forward, {0.0, 1.0, 0.0});
  right = length(right) > 1e-9 ? normalised(right) : Vec3{1.0, 0.0, 0.0};
  return {forward, right, cross(right, forward)};
}

}  // namespace

double keyStep_m(double radius_m) {
  const double wish = std::clamp(radius_m / 20.0, 0.01, 1000.0);
  const double decade = std::pow(10.0, std::floor(std::log10(wish)));
  const double lead = wish / decade;
  return decade * (lead < 1.5 ? 1.0 : lead < 3.5 ? 2.0 : lead < 7.5 ? 5.0 : 10.0);
}

Camera moved(const Camera& camera, CameraKey key, double step) {
  Camera out = camera;
  switch (key) {
    case CameraKey::viewpoint_x_plus: out.eye.x += step; break;
    case CameraKey::viewpoint_x_minus: out.eye.x -= step; break;
    case CameraKey::viewpoint_y_plus: out.eye.y += step; break;
    case CameraKey::viewpoint_y_minus: out.eye.y -= step; break;
    case CameraKey::viewpoint_z_plus: out.eye.z += step; break;
    case CameraKey::viewpoint_z_minus: out.eye.z -= step; break;
    case CameraKey::reference_x_plus: out.target.x += step; break;
    case CameraKey::reference_x_minus: out.target.x -= step; break;
    case CameraKey::reference_y_plus: out.target.y += step; break;
    case CameraKey::reference_y_minus: out.target.y -= step; break;
  }
  return length(out.target - out.eye) > 1e-6 ? out : camera;
}

Camera orbited(const Camera& camera, double yaw, double pitch) {
  const Vec3 arm = camera.eye - camera.target;
  const double distance = std::max(length(arm), kNearest_m);
  const double turned = std::atan2(arm.x, arm.z) + yaw;
  const double raised = std::clamp(std::asin(std::clamp(arm.y / distance, -1.0, 1.0)) + pitch, -kSteepest_rad, kSteepest_rad);
  Camera out = camera;
  out.eye = camera.target + distance * Vec3{std::cos(raised) * std::sin(turned), std::sin(raised), std::cos(raised) * std::cos(turned)};
  return out;
}

Camera panned(const Camera& camera, double dx, double dy) {
  const ViewAxes frame = frameOf(camera);
  const double height = 2.0 * length(camera.target - camera.eye) * std::tan(0.5 * camera.fov_y_rad);
  const Vec3 shift = (-dx * height) * frame.right + (dy * height) * frame.up;
  Camera out = camera;
  out.eye = camera.eye + shift;
  out.target = camera.target + shift;
  return out;
}

Camera dollied(const Camera& camera, double factor, double x, double y) {
  const double distance = length(camera.target - camera.eye);
  const double wanted = std::clamp(distance * factor, kNearest_m, kFarthest_m);
  const ViewAxes frame = frameOf(camera);
  // The point under the pointer stays there when the centre moves towards it as the half height shrinks.
  const double shrink = (distance - wanted) * std::tan(0.5 * camera.fov_y_rad);
  Camera out = camera;
  out.target = camera.target + (shrink * x) * frame.right + (shrink * y) * frame.up;
  out.eye = out.target - wanted * frame.forward;
  return out;
}

}  // namespace npsee::editor
