#include "app/render/camera.h"

#include "sim/core/text.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace npsee::render {
namespace {

/// Share of the picture's half width and height that the effect may fill.
constexpr double kFill = 0.96;
/// Share of the room left above and below an effect that is moved from below it to above.
constexpr double kSkyward = 0.45;
/// Camera distances that `framing` chooses, m; the upper end suits the largest preset there can be.
constexpr double kNearest = 2.0, kFarthest = 1e5;
constexpr double kMinFov = 1.0 / 180.0 * kPi, kMaxFov = 150.0 / 180.0 * kPi;

Vec3 unit(const Vec3& v) { return (1.0 / length(v)) * v; }

/// Points of the dome that stands in the extent's box: half an ellipsoid, flat side down. Effects spread from their burst and
/// fall to the ground, so the box's upper corners are empty; keeping them in view would make everything smaller.
std::vector<Vec3> dome(const Extent& extent) {
  constexpr int kTurns = 32, kTilts = 8;
  const Vec3 size = extent.max - extent.min;
  const Vec3 foot{extent.centre().x, extent.min.y, extent.centre().z};
  std::vector<Vec3> out;
  for (int tilt = 0; tilt <= kTilts; ++tilt)
    for (int turn = 0; turn < kTurns; ++turn) {
      const double up = 0.5 * kPi * tilt / kTilts, around = kTwoPi * turn / kTurns;
      out.push_back(foot + Vec3{0.5 * size.x * std::cos(up) * std::cos(around), size.y * std::sin(up), 0.5 * size.z * std::cos(up) * std::sin(around)});
    }
  return out;
}

/// Camera looking along -`back`, as near as it can be with the extent's dome in view, in the middle of the picture.
Camera frameFrom(const Extent& extent, Vec3 back, double aspect) {
  Camera camera;
  back = unit(back);
  const Vec3 upward = std::abs(back.y) > 0.999 ? Vec3{0.0, 0.0, -1.0} : Vec3{0.0, 1.0, 0.0};
  const Vec3 right = unit(cross(upward, back)), up = cross(back, right);
  const double tan_y = kFill * std::tan(0.5 * camera.fov_y_rad), tan_x = tan_y * std::clamp(aspect, 0.01, 100.0);
  const Vec3 centre = extent.centre();
  // An eye at (a, b, c) in the camera's axes sees a point (x, y, z) when |x - a| <= (c - z) tan_x, and likewise y. Both are
  // pairs of half-planes: the sum of the tightest opposite bounds gives c, their difference a and b.
  double x_high = -1e30, x_low = 1e30, y_high = -1e30, y_low = 1e30;
  for (const Vec3& point : dome(extent)) {
    const Vec3 from = point - centre;
    const double x = dot(from, right), y = dot(from, up), z = dot(from, back);
    x_high = std::max(x_high, x + z * tan_x);
    x_low = std::min(x_low, x - z * tan_x);
    y_high = std::max(y_high, y + z * tan_y);
    y_low = std::min(y_low, y - z * tan_y);
  }
  const double wanted = std::max((x_high - x_low) / (2.0 * tan_x), (y_high - y_low) / (2.0 * tan_y));
  const bool sane = std::isfinite(wanted) && wanted < kFarthest;
  // Room above and below is given to the sky rather than to an empty foreground.
  const double slack = std::max(0.0, wanted * tan_y - 0.5 * (y_high - y_low)), raised = std::abs(back.y) < 0.7 ? kSkyward * slack : 0.0;
  camera.target = sane ? centre + (0.5 * (x_high + x_low)) * right + (0.5 * (y_high + y_low) + raised) * up : Vec3{};
  camera.eye = camera.target + (sane ? std::max(wanted, kNearest) : kFarthest) * back;
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
