#include "app/render/mission_camera.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

using Kind = MissionCamera::Kind;

constexpr double kLeastClearance_m = 1.2;    ///< of a camera over ground and sea
constexpr double kPlanFov_rad = 2.0 * kPi / 180.0;
constexpr double kSteepest_rad = 1.5533430342749532;
constexpr double kFar_m = 5e5;
/// A shell in the air is followed from this share of the camera's distance; the camera steps back in the last seconds.
constexpr double kShellShare = 0.25, kStepBack_s = 2.0;

Vec3 unit(const Vec3& v, const Vec3& otherwise) {
  const double size = length(v);
  return size > 1e-9 ? (1.0 / size) * v : otherwise;
}

/// Horizontal direction of an azimuth.
Vec3 towards(double azimuth_rad) { return {std::sin(azimuth_rad), 0.0, -std::cos(azimuth_rad)}; }

void aim(Lens& lens, const Vec3& direction) {
  lens.back = -1.0 * unit(direction, {0.0, 0.0, -1.0});
  const Vec3 upward = std::abs(lens.back.y) > 0.99999 ? Vec3{0.0, 0.0, -1.0} : Vec3{0.0, 1.0, 0.0};
  lens.right = unit(cross(upward, lens.back), {1.0, 0.0, 0.0});
  lens.up = cross(lens.back, lens.right);
}

/// The eye on its arm around a point; `south` is the azimuth from which yaw 0 looks.
Vec3 armed(const Vec3& around, double distance_m, double yaw_rad, double pitch_rad) {
  const double pitch = std::clamp(pitch_rad, -kSteepest_rad, kSteepest_rad);
  const Vec3 side = towards(kPi + yaw_rad);
  return around + std::max(distance_m, 0.5) * (std::cos(pitch) * side + Vec3{0.0, std::sin(pitch), 0.0});
}

/// Lifts an eye out of the ground and chooses planes that keep depth precise where something can be.
void stand(const Terrain& terrain, Lens& lens, double nearest_m) {
  const double floor_m = terrain.surface(lens.eye.x, lens.eye.z) + kLeastClearance_m;
  lens.eye.y = std::max(lens.eye.y, floor_m);
  const double clearance = lens.eye.y - floor_m + kLeastClearance_m;
  lens.near_m = std::clamp(std::min(0.25 * clearance, 0.3 * nearest_m), 0.4, 200.0);
  lens.far_m = kFar_m;
}

int firstOr(int wanted, std::size_t count) {
  if (count == 0) return -1;
  return wanted >= 0 && static_cast<std::size_t>(wanted) < count ? wanted : 0;
}

MissionEye around(const Recording& recording, const MissionCamera& camera, const Vec3& subject, double yaw_rad) {
  MissionEye out;
  out.lens.fov_y_rad = camera.fov_y_rad;
  out.lens.eye = armed(subject, camera.distance_m, yaw_rad, camera.pitch_rad);
  stand(recording.terrain, out.lens, camera.distance_m);
  aim(out.lens, subject - out.lens.eye);
  return out;
}

MissionEye followed(const Recording& recording, double time_s, const MissionCamera& camera) {
  const int index = camera.subject >= 0 && static_cast<std::size_t>(camera.subject) < recording.shells.size() ? camera.subject : shellToFollow(recording, time_s);
  if (index < 0) return around(recording, camera, camera.target, camera.yaw_rad);
  const ShellRecord& shell = recording.shells[static_cast<std::size_t>(index)];
  const double t = std::clamp(time_s, shell.fired_s, shell.burst_s);
  const Vec3 velocity = shell.velocityAt(t);
  // In the air the shell is looked at, small as it is; at its end the burst, which is large.
  MissionCamera arm = camera;
  const double left = std::clamp((shell.burst_s - time_s) / kStepBack_s, 0.0, 1.0);
  arm.distance_m *= 1.0 - (1.0 - kShellShare) * left * left * (3.0 - 2.0 * left);
  // The heading of the flight, which hardly turns, and not the shell's own direction: the picture stays level.
  const Vec3 line = shell.burst_m - shell.muzzle_m;
  const Vec3 ahead = std::hypot(line.x, line.z) > 1.0 ? line : velocity;
  return around(recording, arm, shell.at(t), std::atan2(ahead.x, -ahead.z) + camera.yaw_rad);
}

MissionEye watched(const Recording& recording, double time_s, const MissionCamera& camera, int index, int width, int height) {
  MissionEye out;
  out.observer = index;
  out.reticle = camera.binoculars;
  Lens& lens = out.lens;
  lens.eye = recording.observerEye(static_cast<std::size_t>(index), time_s);
  const int target = camera.look_at >= 0 && static_cast<std::size_t>(camera.look_at) < recording.vehicles.size() ? camera.look_at : targetOf(recording, index, time_s);
  double azimuth = 0.0, elevation = 0.0;
  const int carrier = recording.observers[static_cast<std::size_t>(index)].vehicle;
  if (target >= 0) {
    const Vec3 line = recording.vehiclePlace(static_cast<std::size_t>(target), time_s) + Vec3{0.0, 1.0, 0.0} - lens.eye;
    azimuth = std::atan2(line.x, -line.z);
    elevation = std::atan2(line.y, std::hypot(line.x, line.z));
  } else if (carrier >= 0) {
    azimuth = recording.vehicles[static_cast<std::size_t>(carrier)].track.at(time_s).heading_rad;
  }
  azimuth += camera.turn_rad;
  elevation = std::clamp(elevation + camera.raise_rad, -1.5, 1.5);
  aim(lens, std::cos(elevation) * towards(azimuth) + Vec3{0.0, std::sin(elevation), 0.0});
  lens.fov_y_rad = camera.fov_y_rad;
  if (camera.binoculars) {
    // The circle's edge is half the field away from the middle; the picture is higher by the share.
    const double half = std::tan(0.5 * toSi(Unit::mil, std::clamp(camera.field_mil, 2.0, 1500.0)));
    const double smaller = std::min(1.0, static_cast<double>(width) / height);
    lens.fov_y_rad = 2.0 * std::atan(half / (kCircleShare * smaller));
  }
  const double clearance = lens.eye.y - recording.terrain.surface(lens.eye.x, lens.eye.z);
  lens.near_m = std::clamp(0.4 * clearance / std::max(std::tan(0.5 * lens.fov_y_rad), 0.05), 0.4, 8.0);
  lens.far_m = kFar_m;
  return out;
}

MissionEye mapped(const Recording& recording, const MissionCamera& camera) {
  MissionEye out;
  Lens& lens = out.lens;
  lens.fov_y_rad = kPlanFov_rad;
  const double span = std::clamp(camera.span_m, 20.0, 2e6);
  const double middle = recording.terrain.surface(camera.target.x, camera.target.z);
  const double height = 0.5 * span / std::tan(0.5 * kPlanFov_rad);
  lens.eye = {camera.target.x, middle + height, camera.target.z};
  lens.right = {1.0, 0.0, 0.0};
  lens.up = {0.0, 0.0, -1.0};
  lens.back = {0.0, 1.0, 0.0};
  // Shells fly up to some kilometres over the ground and are on the map too.
  lens.near_m = std::max(0.02 * height, height - 30000.0);
  lens.far_m = 1.1 * height + 30000.0;
  return out;
}

}  // namespace

View MissionEye::view() const { return viewFrom(lens.eye); }

View MissionEye::viewFrom(const Vec3& origin) const {
  Lens moved = lens;
  moved.eye = lens.eye - origin;
  return makeView(moved, width, height);
}

std::optional<MissionEye::Pixel> MissionEye::project(const Vec3& world) const {
  const Vec3 from = world - lens.eye;
  const double depth = -dot(lens.back, from);
  if (depth <= lens.near_m) return std::nullopt;
  const double scale = 0.5 * height / (std::tan(0.5 * lens.fov_y_rad) * depth);
  return Pixel{0.5 * width + scale * dot(lens.right, from), 0.5 * height - scale * dot(lens.up, from), depth};
}

Vec3 MissionEye::rayThrough(double x, double y) const {
  const double per_pixel = 2.0 * std::tan(0.5 * lens.fov_y_rad) / height;
  return ((x - 0.5 * width) * per_pixel) * lens.right + ((0.5 * height - y) * per_pixel) * lens.up - lens.back;
}

std::optional<Vec3> MissionEye::groundAt(const Terrain& terrain, double x, double y) const {
  const Vec3 ray = rayThrough(x, y);
  auto hit = terrain.raycast(lens.eye, ray, lens.far_m);
  // The sea's surface lies before its bed.
  if (ray.y < 0.0) {
    const double t = (terrain.seaLevel() - lens.eye.y) / ray.y;
    const Vec3 at = lens.eye + t * ray;
    if (t > 0.0 && terrain.sea(at.x, at.z) && (!hit || length(at - lens.eye) < length(*hit - lens.eye))) return at;
  }
  return hit;
}

int shellToFollow(const Recording& recording, double time_s) {
  int out = recording.shells.empty() ? -1 : 0;
  for (std::size_t i = 0; i < recording.shells.size(); ++i)
    if (recording.shells[i].fired_s <= time_s) out = static_cast<int>(i);
  return out;
}

int targetOf(const Recording& recording, int observer, double time_s) {
  if (observer < 0 || static_cast<std::size_t>(observer) >= recording.observers.size()) return -1;
  const Vec3 eye = recording.observerEye(static_cast<std::size_t>(observer), time_s);
  const auto& beliefs = recording.observers[static_cast<std::size_t>(observer)].beliefs;
  // The last word on each contact counts.
  std::vector<const BeliefStep*> latest(recording.vehicles.size(), nullptr);
  for (const BeliefStep& step : beliefs) {
    if (step.t_s > time_s) break;
    if (step.target >= 0 && static_cast<std::size_t>(step.target) < latest.size()) latest[static_cast<std::size_t>(step.target)] = &step;
  }
  int best = -1;
  double best_rank = 1e300;
  for (std::size_t i = 0; i < latest.size(); ++i) {
    const BeliefStep* step = latest[i];
    if (step == nullptr || (!step->seen && step->mission == 0)) continue;
    const double distance = length(step->believed_m - eye);
    // A mission's target first, then what is thought hostile, then the nearest.
    const double rank = distance + (step->mission > 0 ? 0.0 : step->hostile >= 0.5 ? 1e6 : 1e9);
    if (rank < best_rank) {
      best_rank = rank;
      best = static_cast<int>(i);
    }
  }
  return best;
}

MissionEye missionEye(const Recording& recording, double time_s, const MissionCamera& camera, int width, int height) {
  MissionEye out;
  switch (camera.kind) {
    case Kind::free:
      out.lens.eye = camera.eye;
      out.lens.fov_y_rad = camera.fov_y_rad;
      stand(recording.terrain, out.lens, 1e9);
      aim(out.lens, camera.target - out.lens.eye);
      break;
    case Kind::orbit: out = around(recording, camera, camera.target, camera.yaw_rad); break;
    case Kind::follow: out = followed(recording, time_s, camera); break;
    case Kind::gun: {
      const int gun = firstOr(camera.subject, recording.guns.size());
      const Vec3 at = gun >= 0 ? recording.guns[static_cast<std::size_t>(gun)].muzzle_m : camera.target;
      const double azimuth = gun >= 0 ? recording.guns[static_cast<std::size_t>(gun)].lineAt(time_s).first : 0.0;
      out = around(recording, camera, at, azimuth + camera.yaw_rad);
      break;
    }
    case Kind::observer: {
      const int observer = firstOr(camera.subject, recording.observers.size());
      out = observer >= 0 ? watched(recording, time_s, camera, observer, width, height) : around(recording, camera, camera.target, camera.yaw_rad);
      break;
    }
    case Kind::plan: out = mapped(recording, camera); break;
  }
  out.kind = camera.kind;
  out.width = width;
  out.height = height;
  return out;
}

MissionCamera overviewCamera(const Recording& recording, MissionCamera::Kind kind, double aspect) {
  Vec3 low{1e300, 0.0, 1e300}, high{-1e300, 0.0, -1e300};
  double apex_m = 0.0;
  const auto include = [&](double x, double z) {
    low = {std::min(low.x, x), 0.0, std::min(low.z, z)};
    high = {std::max(high.x, x), 0.0, std::max(high.z, z)};
  };
  for (const VehicleRecord& vehicle : recording.vehicles) {
    if (vehicle.track.legs.empty()) continue;
    const Pose start = vehicle.track.at(0.0), end = vehicle.track.at(recording.duration_s);
    include(start.x_m, start.z_m);
    include(end.x_m, end.z_m);
  }
  for (const GunRecord& gun : recording.guns) include(gun.muzzle_m.x, gun.muzzle_m.z);
  for (const ShellRecord& shell : recording.shells) {
    include(shell.burst_m.x, shell.burst_m.z);
    apex_m = std::max(apex_m, shell.path.flight().max_ordinate_m);
  }
  const bool empty = low.x > high.x;
  if (empty) {
    include(0.0, 0.0);
    include(recording.terrain.sizeX(), recording.terrain.sizeZ());
  }
  MissionCamera camera;
  camera.kind = kind;
  camera.target = 0.5 * (low + high);
  camera.target.y = recording.terrain.surface(camera.target.x, camera.target.z);
  const double across = std::max(high.x - low.x, 400.0), down = std::max(high.z - low.z, 400.0);
  camera.span_m = 1.15 * std::max(down, across / std::max(aspect, 0.1));
  camera.yaw_rad = 0.35;
  camera.pitch_rad = 0.55;
  const double tan_half = std::tan(0.5 * camera.fov_y_rad);
  camera.distance_m = std::max(1.05 * std::max(across / std::max(aspect, 0.1), 0.75 * down) / tan_half * 0.62, 250.0);
  // The corners of a whole world have to be seen, not only what lies within.
  if (empty) camera.distance_m *= 1.5;
  // High trajectories shall be in the picture too: seen from the side they need this much of its upper half.
  if (kind == Kind::orbit) {
    const double upper = apex_m * std::cos(camera.pitch_rad);
    const double seen = camera.distance_m * tan_half;
    if (upper > 0.8 * seen) {
      camera.pitch_rad = 0.35;
      camera.target.y += 0.4 * apex_m;
      camera.distance_m = std::max(camera.distance_m, 0.65 * apex_m / tan_half);
    }
  }
  return camera;
}

}  // namespace npsee::render
