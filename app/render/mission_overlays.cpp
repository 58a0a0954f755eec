#include "app/render/mission_overlays.h"

#include "app/render/mission_models.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

constexpr Colour kShot{0.96, 0.78, 0.36}, kRing{0.55, 0.80, 0.92}, kBelief{0.90, 0.66, 0.25}, kDark{0.04, 0.05, 0.06};
/// Lines on the ground are drawn before it by this share of the distance, and this high, m.
constexpr double kNearer = 0.004, kLift_m = 0.6;

Vec3 onGround(const Terrain& terrain, double x, double z) { return {x, terrain.surface(x, z) + kLift_m, z}; }

/// A straight line laid over the ground.
std::vector<Vec3> draped(const Terrain& terrain, const Vec3& from, const Vec3& to, int pieces) {
  std::vector<Vec3> out;
  for (int i = 0; i <= pieces; ++i) {
    const double s = static_cast<double>(i) / pieces;
    out.push_back(onGround(terrain, from.x + s * (to.x - from.x), from.z + s * (to.z - from.z)));
  }
  return out;
}

std::vector<Vec3> ring(const Terrain& terrain, const Vec3& centre, double radius_m) {
  constexpr int kPieces = 180;
  std::vector<Vec3> out;
  for (int i = 0; i <= kPieces; ++i) {
    const double turn = kTwoPi * i / kPieces;
    out.push_back(onGround(terrain, centre.x + radius_m * std::sin(turn), centre.z - radius_m * std::cos(turn)));
  }
  return out;
}

StrokeStyle style(const Colour& colour, double width_px, double opacity, double hidden, double dash_px = 0.0) { return {colour, width_px, opacity, hidden, dash_px}; }

StrokeStyle wider(StrokeStyle style, double scale) {
  style.width_px *= scale;
  style.dash_px *= scale;
  return style;
}

class Lines {
 public:
  Lines(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const Weapons& weapons)
      : recording_(recording), time_s_(time_s), view_(view), eye_(eye), weapons_(weapons) {
    recording.shellsInAir(time_s, flying_);
  }

  OverlayDrawing collect(const std::vector<MissionMark>& marks) {
    const MissionOverlays& wanted = view_.overlays;
    if (wanted.range_rings) rangeRings();
    if (wanted.fire_lines && eye_.kind != MissionCamera::Kind::observer) fireLines();
    for (const int index : flying_) shell(recording_.shells[static_cast<std::size_t>(index)]);
    if (wanted.beliefs) beliefs();
    if (wanted.icons && eye_.kind != MissionCamera::Kind::observer) icons(marks);
    for (WorldStroke& stroke : out_.ground) stroke.style = wider(stroke.style, view_.scale);
    for (ScreenStroke& stroke : out_.screen) stroke.style = wider(stroke.style, view_.scale);
    return std::move(out_);
  }

 private:
  void rangeRings() {
    for (const GunRecord& gun : recording_.guns) {
      if (gun.battery < 0 || static_cast<std::size_t>(gun.battery) >= recording_.scenario.batteries.size()) continue;
      const Weapon* weapon = weapons_.find(std::to_string(recording_.scenario.batteries[static_cast<std::size_t>(gun.battery)].weapon));
      if (weapon == nullptr || weapon->range_m <= 0) continue;
      for (const double share : {0.5, 1.0}) out_.ground.push_back({ring(recording_.terrain, gun.muzzle_m, share * weapon->range_m), style(kRing, share < 1.0 ? 1.0 : 1.6, share < 1.0 ? 0.35 : 0.60, 0.15, share < 1.0 ? 7.0 : 0.0), kNearer});
    }
  }

  void fireLines() {
    for (const int index : flying_) {
      const ShellRecord& shot = recording_.shells[static_cast<std::size_t>(index)];
      if (shot.gun < 0) continue;
      out_.ground.push_back({draped(recording_.terrain, shot.muzzle_m, shot.burst_m, 96), style(kShot, 1.1, 0.40, 0.2, 8.0), kNearer});
    }
  }

  void shell(const ShellRecord& shot) {
    const MissionOverlays& wanted = view_.overlays;
    const double now = std::clamp(time_s_, shot.fired_s, shot.burst_s);
    const auto path = [&](double from_s, double to_s, int pieces) {
      std::vector<Vec3> points;
      for (int i = 0; i <= pieces; ++i) points.push_back(shot.at(from_s + (to_s - from_s) * i / pieces));
      return points;
    };
    if (wanted.trajectories) out_.ground.push_back({path(shot.fired_s, shot.burst_s, 96), style(kShot, 1.0, 0.45, 0.25, 6.0), 0.0});
    if (wanted.trails) {
      // Brighter towards the shell.
      const double flown = now - shot.fired_s;
      for (int part = 0; part < 3; ++part)
        out_.ground.push_back({path(shot.fired_s + flown * part / 3.0, shot.fired_s + flown * (part + 1) / 3.0, 24), style(kShot, 1.3 + 0.3 * part, 0.30 + 0.25 * part, 0.25), 0.0});
    }
    if (wanted.drop_lines) {
      const auto drop = [&](const Vec3& at, double opacity) {
        const Vec3 foot = onGround(recording_.terrain, at.x, at.z);
        if (at.y - foot.y > 5.0) out_.ground.push_back({{at, foot}, style(kShot, 1.0, opacity, 0.3), 0.0});
      };
      const Vec3 at = shot.at(now);
      drop(at, 0.55);
      out_.ground.push_back({{onGround(recording_.terrain, at.x, at.z)}, style(kShot, 4.0, 0.7, 0.4), kNearer});
      if (wanted.trails)
        for (double t = shot.fired_s + 2.0; t < now; t += std::max(2.0, (shot.burst_s - shot.fired_s) / 24.0)) drop(shot.at(t), 0.16);
    }
    if (eye_.kind != MissionCamera::Kind::observer) out_.ground.push_back({{shot.at(now)}, style({1.0, 0.93, 0.72}, 4.5, 1.0, 0.4), 0.0});
  }

  void beliefs() {
    for (std::size_t o = 0; o < recording_.observers.size(); ++o) {
      if (eye_.observer >= 0 && eye_.observer != static_cast<int>(o)) continue;
      for (const auto& [target, step] : latestBeliefs(recording_.observers[o])) {
        const Vec3 ghost = onGround(recording_.terrain, step->believed_m.x, step->believed_m.z), truth = recording_.vehiclePlace(static_cast<std::size_t>(target), time_s_);
        const double apart = std::hypot(ghost.x - truth.x, ghost.z - truth.z);
        if (recording_.vehicles[static_cast<std::size_t>(target)].destroyedAt(time_s_)) continue;
        // In his own eye a mark right on the target would only hide it.
        if (eye_.observer >= 0 && apart < 10.0) continue;
        const double strength = step->seen ? 0.85 : 0.45;
        const double top = 0.035 * length(ghost - eye_.lens.eye) * std::tan(0.5 * eye_.lens.fov_y_rad);
        const Vec3 head = ghost + Vec3{0.0, top, 0.0};
        out_.ground.push_back({{ghost, head}, style(kBelief, 1.4, strength, 0.35), kNearer});
        out_.ground.push_back({{head}, style(kBelief, 7.0, strength, 0.35), kNearer});
        out_.ground.push_back({ring(recording_.terrain, ghost, std::max(0.6 * top, 4.0)), style(kBelief, 1.2, 0.8 * strength, 0.35), kNearer});
        if (apart > 3.0) out_.ground.push_back({draped(recording_.terrain, ghost, truth, 24), style(kBelief, 1.4, strength, 0.35, 5.0), kNearer});
      }
    }
  }

  std::vector<std::pair<int, const BeliefStep*>> latestBeliefs(const ObserverRecord& observer) const {
    std::vector<const BeliefStep*> latest(recording_.vehicles.size(), nullptr);
    for (const BeliefStep& step : observer.beliefs) {
      if (step.t_s > time_s_) break;
      if (step.target >= 0 && static_cast<std::size_t>(step.target) < latest.size()) latest[static_cast<std::size_t>(step.target)] = &step;
    }
    std::vector<std::pair<int, const BeliefStep*>> out;
    for (std::size_t i = 0; i < latest.size(); ++i)
      if (latest[i] != nullptr && (latest[i]->seen || latest[i]->mission > 0)) out.emplace_back(static_cast<int>(i), latest[i]);
    return out;
  }

  void icon(const MissionMark& mark, Side side) {
    const double k = view_.scale, s = 5.5 * k, x = mark.x, y = mark.y - s - 5.0 * k;
    std::vector<std::pair<double, double>> outline;
    if (mark.kind == MissionMark::Kind::gun) outline = {{x - s, y - s}, {x + s, y - s}, {x + s, y + s}, {x - s, y + s}, {x - s, y - s}};
    else if (side == Side::hostile) outline = {{x, y - 1.25 * s}, {x + 1.25 * s, y}, {x, y + 1.25 * s}, {x - 1.25 * s, y}, {x, y - 1.25 * s}};
    else if (side == Side::friendly) outline = {{x - 1.4 * s, y - s}, {x + 1.4 * s, y - s}, {x + 1.4 * s, y + s}, {x - 1.4 * s, y + s}, {x - 1.4 * s, y - s}};
    else outline = {{x - s, y - s}, {x + s, y - s}, {x + s, y + s}, {x - s, y + s}, {x - s, y - s}};
    const double opacity = mark.hidden ? 0.35 : 1.0;
    out_.screen.push_back({outline, style(kDark, 4.0, 0.55 * opacity, 1.0)});
    out_.screen.push_back({outline, style(sideColour(side), 1.7, opacity, 1.0)});
    // A gun has a dot, an observer a triangle inside, as on maps.
    if (mark.kind == MissionMark::Kind::gun) out_.screen.push_back({{{x, y}}, style(sideColour(side), 4.0, opacity, 1.0)});
    if (mark.kind == MissionMark::Kind::observer) out_.screen.push_back({{{x - 3.0 * k, y + 2.5 * k}, {x, y - 3.0 * k}, {x + 3.0 * k, y + 2.5 * k}, {x - 3.0 * k, y + 2.5 * k}}, style(sideColour(side), 1.3, opacity, 1.0)});
  }

  void icons(const std::vector<MissionMark>& marks) {
    for (const MissionMark& mark : marks) {
      if (mark.size_px > 110.0 * view_.scale) continue;
      if (mark.kind == MissionMark::Kind::gun || mark.kind == MissionMark::Kind::observer) icon(mark, Side::friendly);
      if (mark.kind != MissionMark::Kind::vehicle) continue;
      const VehicleRecord& vehicle = recording_.vehicles[static_cast<std::size_t>(mark.index)];
      const bool carrier = std::ranges::any_of(recording_.observers, [&](const ObserverRecord& o) { return o.vehicle == mark.index; });
      // A wreck needs no mark; whom an observer rides with has his.
      if (!carrier && !vehicle.destroyedAt(time_s_)) icon(mark, vehicle.type.side);
    }
  }

  const Recording& recording_;
  double time_s_;
  const MissionView& view_;
  const MissionEye& eye_;
  const Weapons& weapons_;
  std::vector<int> flying_;
  OverlayDrawing out_;
};

}  // namespace

OverlayDrawing overlaysOf(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const std::vector<MissionMark>& marks, const Weapons& weapons) {
  return Lines(recording, time_s, view, eye, weapons).collect(marks);
}

std::vector<MissionMark> marksOf(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye) {
  std::vector<MissionMark> out;
  const double least = eye.kind == MissionCamera::Kind::observer ? 0.0 : view.least_px * view.scale;
  const double per_metre = 0.5 * eye.height / std::tan(0.5 * eye.lens.fov_y_rad);
  const auto add = [&](MissionMark::Kind kind, int index, int target, const Vec3& at, double length_m, double height_m) {
    const double depth = -dot(eye.lens.back, at - eye.lens.eye);
    if (depth <= eye.lens.near_m) return;
    const double larger = enlargement(eye, length_m, depth, least);
    const auto pixel = eye.project(at + Vec3{0.0, larger * height_m, 0.0});
    constexpr double kAround_px = 60.0;
    if (!pixel || pixel->x < -kAround_px || pixel->y < -kAround_px || pixel->x > eye.width + kAround_px || pixel->y > eye.height + kAround_px) return;
    MissionMark mark{kind, index, target, pixel->x, pixel->y, depth, std::max(larger * length_m * per_metre / depth, 6.0 * view.scale), false};
    if (eye.kind != MissionCamera::Kind::plan) mark.hidden = !recording.terrain.sight(eye.lens.eye, at + Vec3{0.0, std::max(height_m, 0.5), 0.0}).clear;
    out.push_back(mark);
  };
  using Mark = MissionMark::Kind;
  for (std::size_t i = 0; i < recording.vehicles.size(); ++i) {
    if (eye.observer >= 0 && recording.observers[static_cast<std::size_t>(eye.observer)].vehicle == static_cast<int>(i)) continue;
    add(Mark::vehicle, static_cast<int>(i), -1, recording.vehiclePlace(i, time_s), drawnLength(recording.vehicles[i].type), std::max(recording.vehicles[i].type.height_m, 1.0));
  }
  for (std::size_t i = 0; i < recording.guns.size(); ++i) {
    Vec3 at = recording.guns[i].muzzle_m;
    at.y = recording.terrain.surface(at.x, at.z);
    add(Mark::gun, static_cast<int>(i), -1, at, 6.2, 2.9);
  }
  for (std::size_t i = 0; i < recording.observers.size(); ++i) {
    if (eye.observer == static_cast<int>(i)) continue;
    Vec3 at = recording.observerEye(i, time_s);
    at.y = recording.terrain.surface(at.x, at.z);
    add(Mark::observer, static_cast<int>(i), -1, at, 4.9, 2.6);
  }
  std::vector<int> shells;
  recording.shellsInAir(time_s, shells);
  for (const int index : shells) add(Mark::shell, index, -1, recording.shells[static_cast<std::size_t>(index)].at(time_s), 0.7, 0.0);
  shells.clear();
  recording.burstsSince(time_s, 8.0, shells);
  for (const int index : shells) add(Mark::burst, index, -1, recording.shells[static_cast<std::size_t>(index)].burst_m, 10.0, 4.0);
  for (std::size_t o = 0; o < recording.observers.size(); ++o) {
    if (eye.observer >= 0 && eye.observer != static_cast<int>(o)) continue;
    std::vector<const BeliefStep*> latest(recording.vehicles.size(), nullptr);
    for (const BeliefStep& step : recording.observers[o].beliefs) {
      if (step.t_s > time_s) break;
      if (step.target >= 0 && static_cast<std::size_t>(step.target) < latest.size()) latest[static_cast<std::size_t>(step.target)] = &step;
    }
    for (std::size_t i = 0; i < latest.size(); ++i)
      if (latest[i] != nullptr && (latest[i]->seen || latest[i]->mission > 0)) {
        Vec3 at = latest[i]->believed_m;
        at.y = recording.terrain.surface(at.x, at.z);
        add(Mark::belief, static_cast<int>(o), static_cast<int>(i), at, 6.0, 2.0);
      }
  }
  return out;
}

}  // namespace npsee::render
