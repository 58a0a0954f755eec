#include "app/render/mission_models.h"

#include "app/render/mission_overlays.h"
#include "app/render/mission_scene.h"
#include "app/render/mission_wrecks.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace npsee::render {
namespace {

/// A howitzer's length from the rear of its hull to the front, without the tube, m.
constexpr double kGunLength_m = 6.2;
constexpr double kShellLength_m = 0.7;
/// A vehicle that has just fired keeps its turret where it shot for this long, s.
constexpr double kTurretRest_s = 25.0;

std::string_view modelOf(const VehicleType& type) {
  const auto named = [&](std::string_view part) { return type.name.find(part) != std::string::npos; };
  if (named("M577") || named("M113")) return "m577";
  if (named("M109") || named("M110")) return "howitzer";
  // A private car is shorter than any truck.
  if (type.target_class == TargetClass::wheeled && type.length_m < 5.5) return "car";
  switch (type.target_class) {
    case TargetClass::heavy_armor: return "tank";
    case TargetClass::light_armor: return "ifv";
    case TargetClass::wheeled: return "truck";
    case TargetClass::personnel: return "squad";
    case TargetClass::aircraft: return "helicopter";
    case TargetClass::watercraft: return "boat";
  }
  return "tank";
}

Vec3 unit(const Vec3& v) {
  const double size = length(v);
  return size > 1e-12 ? (1.0 / size) * v : Vec3{0.0, 1.0, 0.0};
}

/// Puts something on the ground, level with it, its front towards a heading.
void standOn(const Terrain& terrain, const Vec3& at, double heading_rad, ModelInstance& out) {
  out.at_m = at;
  out.up = terrain.sea(at.x, at.z) ? Vec3{0.0, 1.0, 0.0} : terrain.normal(at.x, at.z);
  const Vec3 ahead{std::sin(heading_rad), 0.0, -std::cos(heading_rad)};
  out.right = unit(cross(ahead, out.up));
  out.back = cross(out.right, out.up);
}

/// Whether a ball may touch the picture.
bool inPicture(const MissionEye& eye, const Vec3& at, double radius_m) {
  const Vec3 from = at - eye.lens.eye;
  const double depth = -dot(eye.lens.back, from);
  if (depth < -radius_m) return false;
  const double tan_y = std::tan(0.5 * eye.lens.fov_y_rad), tan_x = tan_y * eye.width / eye.height;
  return std::abs(dot(eye.lens.right, from)) < depth * tan_x + 1.5 * radius_m * (1.0 + tan_x) && std::abs(dot(eye.lens.up, from)) < depth * tan_y + 1.5 * radius_m * (1.0 + tan_y);
}

double azimuthOf(const ShellRecord& shell) {
  const Vec3 line = shell.burst_m - shell.muzzle_m;
  return std::atan2(line.x, -line.z);
}

class Collector {
 public:
  Collector(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const ModelPass& models, std::span<const char> in_pieces)
      : recording_(recording), time_s_(time_s), eye_(eye), models_(models), in_pieces_(in_pieces), least_px_(eye.kind == MissionCamera::Kind::observer ? 0.0 : view.least_px * view.scale) {
    block_ = models.find("block", {});
    for (const ShellRecord& shell : recording.shells) {
      if (shell.fired_s > time_s) break;
      if (shell.shooter >= 0 && time_s - shell.fired_s <= kTurretRest_s) aimed_[shell.shooter] = azimuthOf(shell);
    }
  }

  std::vector<ModelInstance> collect() {
    for (std::size_t i = 0; i < recording_.vehicles.size(); ++i) vehicle(i);
    for (std::size_t i = 0; i < recording_.guns.size(); ++i) gun(recording_.guns[i]);
    for (std::size_t i = 0; i < recording_.observers.size(); ++i) observer(i);
    std::vector<int> flying;
    recording_.shellsInAir(time_s_, flying);
    for (const int index : flying) shell(recording_.shells[static_cast<std::size_t>(index)]);
    return std::move(out_);
  }

 private:
  bool ownVehicle(std::size_t index) const { return eye_.observer >= 0 && recording_.observers[static_cast<std::size_t>(eye_.observer)].vehicle == static_cast<int>(index); }

  /// Adds it at the size it needs to be seen; something of a few pixels gets the simple shape.
  void add(ModelInstance instance, double length_m) {
    const double depth = std::max(-dot(eye_.lens.back, instance.at_m - eye_.lens.eye), 0.1);
    const double larger = enlargement(eye_, length_m, depth, least_px_);
    if (!inPicture(eye_, instance.at_m, larger * length_m)) return;
    const double pixels = larger * length_m / depth / (2.0 * std::tan(0.5 * eye_.lens.fov_y_rad) / eye_.height);
    const Model& model = models_.models()[instance.model];
    instance.scale *= larger;
    if (pixels < 7.0 && model.name != "shell") {
      instance.scale = larger * length_m;
      instance.model = block_;
    }
    out_.push_back(instance);
  }

  void vehicle(std::size_t index) {
    const VehicleRecord& record = recording_.vehicles[index];
    if (ownVehicle(index) || record.track.legs.empty()) return;
    // What came apart is drawn with the bursts.
    if (index < in_pieces_.size() && in_pieces_[index] != 0) return;
    const auto aimed = aimed_.find(static_cast<int>(index));
    add(vehicleInstance(recording_, index, time_s_, aimed != aimed_.end() ? std::optional(aimed->second) : std::nullopt, models_), drawnLength(record.type));
  }

  void gun(const GunRecord& record) {
    ModelInstance instance;
    instance.model = models_.find("howitzer", "tank");
    const auto [azimuth, elevation] = record.lineAt(time_s_);
    // The hull stands as the battery came into position; the turret does the rest.
    const double hull = record.lays.empty() ? azimuth : record.lays.front().azimuth_rad;
    Vec3 at = record.muzzle_m;
    at.y = recording_.terrain.surface(at.x, at.z);
    standOn(recording_.terrain, at, hull, instance);
    instance.turret_rad = azimuth - hull;
    instance.tube_rad = elevation;
    instance.body = sidePaint(Side::friendly);
    instance.accent = sideColour(Side::friendly);
    add(instance, kGunLength_m);
  }

  /// An observer on foot stands beside his vehicle; without one, alone.
  void observer(std::size_t index) {
    if (eye_.observer == static_cast<int>(index)) return;
    const ObserverRecord& record = recording_.observers[index];
    Vec3 at = recording_.observerEye(index, time_s_);
    double heading = 0.0;
    if (record.vehicle >= 0) {
      const Pose pose = recording_.vehicles[static_cast<std::size_t>(record.vehicle)].track.at(time_s_);
      if (pose.speed_mps > 0.0) return;  // he rides
      heading = pose.heading_rad;
      at = at + Vec3{3.2 * std::cos(heading), 0.0, 3.2 * std::sin(heading)};
    }
    at.y = recording_.terrain.surface(at.x, at.z);
    if (const int target = targetOf(recording_, static_cast<int>(index), time_s_); target >= 0) {
      const Vec3 line = recording_.vehiclePlace(static_cast<std::size_t>(target), time_s_) - at;
      heading = std::atan2(line.x, -line.z);
    }
    ModelInstance instance;
    instance.model = models_.find("observer", "squad");
    standOn(recording_.terrain, at, heading, instance);
    instance.up = {0.0, 1.0, 0.0};
    instance.right = {std::cos(heading), 0.0, std::sin(heading)};
    instance.back = cross(instance.right, instance.up);
    instance.body = sidePaint(Side::friendly);
    instance.accent = sideColour(Side::friendly);
    // Not enlarged: his vehicle is, and he would stand inside it.
    if (!inPicture(eye_, at, 4.0)) return;
    out_.push_back(instance);
  }

  void shell(const ShellRecord& record) {
    ModelInstance instance;
    instance.model = models_.find("shell", {});
    instance.at_m = record.at(time_s_);
    instance.back = -1.0 * unit(record.velocityAt(time_s_));
    const Vec3 upward = std::abs(instance.back.y) > 0.999 ? Vec3{0.0, 0.0, -1.0} : Vec3{0.0, 1.0, 0.0};
    instance.right = unit(cross(upward, instance.back));
    instance.up = cross(instance.back, instance.right);
    instance.body = record.illumination ? Colour{0.85, 0.85, 0.80} : record.smoke ? Colour{0.45, 0.55, 0.45} : Colour{0.42, 0.44, 0.30};
    instance.accent = {0.95, 0.80, 0.25};
    add(instance, kShellLength_m);
  }

  const Recording& recording_;
  double time_s_;
  const MissionEye& eye_;
  const ModelPass& models_;
  std::span<const char> in_pieces_;
  double least_px_;
  std::size_t block_ = 0;
  std::map<int, double> aimed_;  // azimuth of the last shot of vehicles that have just fired
  std::vector<ModelInstance> out_;
};

}  // namespace

Colour sideColour(Side side) {
  switch (side) {
    case Side::friendly: return {0x5f / 255.0, 0xb3 / 255.0, 0xd9 / 255.0};
    case Side::hostile: return {0xe2 / 255.0, 0x57 / 255.0, 0x4c / 255.0};
    case Side::neutral: break;
  }
  return {0x8b / 255.0, 0x92 / 255.0, 0xa0 / 255.0};
}

Colour sidePaint(Side side) {
  switch (side) {
    case Side::friendly: return {0.38, 0.43, 0.36};
    case Side::hostile: return {0.43, 0.38, 0.27};
    case Side::neutral: break;
  }
  return {0.62, 0.62, 0.60};
}

ModelInstance vehicleInstance(const Recording& recording, std::size_t index, double time_s, std::optional<double> aimed_rad, const ModelPass& models) {
  const VehicleRecord& record = recording.vehicles[index];
  const Pose pose = record.track.at(time_s);
  ModelInstance instance;
  instance.model = models.find(record.type.model, modelOf(record.type));
  standOn(recording.terrain, recording.vehiclePlace(index, time_s), pose.heading_rad, instance);
  if (record.type.target_class == TargetClass::aircraft) instance.at_m.y += 60.0;
  instance.body = sidePaint(record.type.side);
  instance.accent = sideColour(record.type.side);
  if (record.destroyedAt(time_s)) instance.burnt = 1.0;
  else if (const DamageStep* harm = record.damageAt(time_s)) instance.burnt = std::clamp(0.5 * harm->hull, 0.0, 0.5);
  if (aimed_rad) instance.turret_rad = *aimed_rad - pose.heading_rad;
  // Knocked out, the gun hangs and points aside.
  if (instance.burnt >= 1.0) {
    instance.turret_rad += 0.45;
    instance.tube_rad = -0.10;
  }
  const Model& model = models.models()[instance.model];
  if (model.name == "howitzer") instance.turret_rad = 0.0, instance.tube_rad = std::max(instance.tube_rad, 0.05);
  // Models have their own proportions; the type says how long the real one is.
  if (record.type.length_m > 0.5 && model.name != "squad" && model.name != "helicopter" && model.name != "howitzer") instance.scale = record.type.length_m / model.hull_length_m;
  return instance;
}

std::optional<double> aimedAt(const Recording& recording, int vehicle, double time_s) {
  std::optional<double> out;
  for (const ShellRecord& shell : recording.shells) {
    if (shell.fired_s > time_s) break;
    if (shell.shooter == vehicle && time_s - shell.fired_s <= kTurretRest_s) out = azimuthOf(shell);
  }
  return out;
}

double enlargement(const MissionEye& eye, double length_m, double depth_m, double least_px) {
  const double metre_per_pixel = 2.0 * std::tan(0.5 * eye.lens.fov_y_rad) / eye.height * depth_m;
  return std::max(1.0, least_px * metre_per_pixel / std::max(length_m, 0.1));
}

double drawnLength(const VehicleType& type) { return std::max(type.length_m, 1.0); }

std::vector<GroundCorner> modelShadows(const Recording& recording, const std::vector<ModelInstance>& instances, const MissionEye& eye, const ModelPass& models) {
  constexpr int kSides = 16, kMost = 600;
  constexpr double kLeast_px = 9.0, kSofter = 1.4;
  // Away from the key light (shaders/common.glsl), as far as half a vehicle's height throws it.
  const Vec3 away{0.5263 / 0.7105, 0.0, -0.4671 / 0.7105};
  std::vector<GroundCorner> out;
  int count = 0;
  for (const ModelInstance& instance : instances) {
    const Model& model = models.models()[instance.model];
    if (model.name == "shell" || model.name == "block" || model.name == "squad") continue;
    const double length_m = model.name == "observer" ? 0.9 : model.hull_length_m * instance.scale, width_m = model.name == "observer" ? 0.9 : 0.58 * length_m;
    const auto pixel = eye.project(instance.at_m);
    if (!pixel || length_m / pixel->depth_m / (2.0 * std::tan(0.5 * eye.lens.fov_y_rad) / eye.height) < kLeast_px || ++count > kMost) continue;
    const Vec3 middle = instance.at_m + 0.28 * length_m * away;
    const auto at = [&](int side, double size, float alpha) {
      // A rounded oblong: the fourth power keeps the corners of the hull dark.
      const double turn = kTwoPi * side / kSides, sine = std::sin(turn), cosine = std::cos(turn);
      const double reach = size / std::sqrt(std::sqrt(sine * sine * sine * sine + cosine * cosine * cosine * cosine));
      const Vec3 p = middle + (reach * 0.5 * width_m * sine) * instance.right + (reach * 0.5 * length_m * cosine) * instance.back;
      return GroundCorner{{p.x, recording.terrain.surface(p.x, p.z) + 0.04, p.z}, {0.02f, 0.025f, 0.03f, alpha}};
    };
    constexpr float kDark = 0.68f;
    const GroundCorner centre{{middle.x, recording.terrain.surface(middle.x, middle.z) + 0.04, middle.z}, {0.02f, 0.025f, 0.03f, kDark}};
    for (int side = 0; side < kSides; ++side) {
      const GroundCorner a = at(side, 1.08, kDark), b = at(side + 1, 1.08, kDark), c = at(side + 1, kSofter, 0.0f), d = at(side, kSofter, 0.0f);
      for (const GroundCorner* g : {&centre, &a, &b, &a, &b, &c, &a, &c, &d}) out.push_back(*g);
    }
  }
  return out;
}

std::vector<ModelInstance> missionModels(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const ModelPass& models, std::span<const char> in_pieces) {
  return Collector(recording, time_s, view, eye, models, in_pieces).collect();
}

}  // namespace npsee::render
