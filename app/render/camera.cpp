#include "app/render/camera.h"

#include "sim/core/text.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

/// Share of the picture's half width and height that the effect may fill.
constexpr double kFill = 0.96;
/// Camera distances that `framing` chooses, m; the upper end suits the largest preset there can be.
constexpr double kNearest = 2.0, kFarthest = 1e5;
constexpr double kMinFov = 1.0 / 180.0 * kPi, kMaxFov = 150.0 / 180.0 * kPi;

Vec3 unit(const Vec3& v) { return (1.0 / length(v)) * v; }

/// Half width of the ellipsoid in the box of half sides `half`, along `axis`.
double reach(const Vec3& half, const Vec3& axis) { return length({half.x * axis.x, half.y * axis.y, half.z * axis.z}); }

/// Camera looking along -`back`, as near as it can be with the ellipsoid in the extent's box in view and centred. The box's
/// corners are empty in every effect that spreads around its burst; keeping them in view would halve its size.
Camera frameFrom(const Extent& extent, Vec3 back, double aspect) {
  Camera camera;
  back = unit(back);
  const Vec3 upward = std::abs(back.y) > 0.999 ? Vec3{0.0, 0.0, -1.0} : Vec3{0.0, 1.0, 0.0};
  const Vec3 right = unit(cross(upward, back)), up = cross(back, right);
  const double tan_y = kFill * std::tan(0.5 * camera.fov_y_rad), tan_x = tan_y * std::clamp(aspect, 0.01, 100.0);
  const Vec3 half = 0.5 * (extent.max - extent.min);
  // A frustum side contains the eye and has the normal (axis + tangent * back); the ellipsoid touches it from inside when
  // tangent * distance equals its half width along that normal. By symmetry the centre stays in the middle.
  const double across = std::max(reach(half, right + tan_x * back), reach(half, tan_x * back - right)) / tan_x;
  const double upright = std::max(reach(half, up + tan_y * back), reach(half, tan_y * back - up)) / tan_y;
  const double wanted = std::max(across, upright);
  const double distance = std::isfinite(wanted) ? std::clamp(wanted, kNearest, kFarthest) : kNearest;
  camera.target = extent.centre();
  camera.eye = camera.target + distance * back;
  return camera;
}

/// A direction to look from for a named view; zero for an unknown name.
Vec3 namedDirection(std::string_view name) {
  if (name == "auto") return {0.375, 0.15, 0.905};
  if (name == "front") return {0.0, 0.08, 1.0};
  if (name == "back") return {0.0, 0.08, -1.0};
  if (name == "side") return {1.0, 0.08, 0.0};
  if (name == "left") return {-1.0, 0.08, 0.0};
  if (name == "top") return {0.0, 1.0, 0.0};
  return {};
}

constexpr const char* kRemedy = "Write \"eye=X,Y,Z target=X,Y,Z fov=40deg\" (metres; each part may be left out), or one of auto, front, back, side, left, top.";

tl::unexpected<Error> refused(std::string_view text, const std::string& why) {
  return fail(ErrorKind::usage, "--camera " + std::string(text) + ": " + why, kRemedy);
}

bool readPoint(std::string_view text, Vec3& out) {
  const auto parts = splitAt(text, ',');
  if (parts.size() != 3) return false;
  double* const values[] = {&out.x, &out.y, &out.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = parseQuantity(trimmed(parts[i]), Unit::metre);
    if (!value || !(std::abs(*value) <= kFarthest)) return false;
    *values[i] = *value;
  }
  return true;
}

/// Applies one "key=value"; empty, or what is wrong.
std::string applyPart(std::string_view part, Camera& camera) {
  const std::size_t equals = part.find('=');
  const std::string_view key = part.substr(0, equals), value = equals == std::string_view::npos ? std::string_view() : part.substr(equals + 1);
  if (key == "eye" || key == "target") {
    if (readPoint(value, key == "eye" ? camera.eye : camera.target)) return {};
    return std::string(key) + " wants three numbers of at most 100000 m, as in " + std::string(key) + "=12,5,40.";
  }
  if (key != "fov") return "there is no camera part \"" + std::string(part) + "\".";
  const auto angle = parseQuantity(value, Unit::degree);
  if (!angle || !(*angle >= kMinFov && *angle <= kMaxFov)) return "fov is the vertical field of view, from 1 to 150 deg.";
  camera.fov_y_rad = *angle;
  return {};
}

}  // namespace

Camera framing(const Extent& extent, double aspect) { return frameFrom(extent, namedDirection("auto"), aspect); }

Expected<Camera> parseCamera(std::string_view text, const Extent& extent, double aspect) {
  const std::string_view whole = trimmed(text);
  if (const Vec3 direction = namedDirection(whole); length(direction) > 0.0) return frameFrom(extent, direction, aspect);
  Camera camera = framing(extent, aspect);
  std::string spaced(whole);
  std::ranges::replace(spaced, ';', ' ');
  bool any = false;
  for (const std::string_view part : splitAt(spaced, ' ')) {
    if (trimmed(part).empty()) continue;
    any = true;
    if (const std::string wrong = applyPart(trimmed(part), camera); !wrong.empty()) return refused(text, wrong);
  }
  if (!any) return refused(text, "no camera is named.");
  if (length(camera.target - camera.eye) < 1e-3) return refused(text, "eye and target are the same place.");
  return camera;
}

std::string cameraText(const Camera& camera) {
  const auto point = [](const Vec3& p) { return shortest(p.x) + ',' + shortest(p.y) + ',' + shortest(p.z); };
  return "eye=" + point(camera.eye) + " target=" + point(camera.target) + " fov=" + shortest(camera.fov_y_rad) + "rad";
}

}  // namespace npsee::render
