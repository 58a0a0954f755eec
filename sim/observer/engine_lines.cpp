#include "sim/observer/engine.h"

#include <algorithm>
#include <cmath>

namespace npsee {

using namespace observer;

namespace {

/// A gravity bomb is released this high over its aim; the aircraft itself is not part of the world.
constexpr double kBombHeight_m = 1500.0;

}  // namespace

/// Weapons of path type 2 (laser) hit what they see along a straight line; those of type 3 fall on their aim from above.
FireSolution Mission::State::solveLine(const Battery& battery, const FireRequest& request) const {
  FireSolution out;
  const bool bomb = battery.weapon->path == PathType::gravity_bomb;
  const double speed = std::max(1.0, battery.weapon->muzzle_velocity_mps);
  out.aim_m = out.impact_m = request.target_m;
  out.shot.muzzle_m = bomb ? request.target_m + Vec3{0.0, kBombHeight_m, 0.0} : request.muzzle_m;
  const double level = levelDistance(request.muzzle_m, request.target_m);
  out.shot.azimuth_rad = bearing(request.muzzle_m, request.target_m);
  out.time_of_flight_s = bomb ? std::sqrt(2.0 * kBombHeight_m / kStandardGravity_mps2) : length(request.target_m - request.muzzle_m) / speed;
  if (level > battery.weapon->range_m) {
    out.refusal = Refusal::out_of_range;
    out.reason = "The place is " + std::to_string(static_cast<int>(level)) + " m away, beyond the " + std::to_string(battery.weapon->range_m) + " m of weapon " + battery.weapon->name + ".";
  } else if (!bomb && !rec.terrain.sees(request.muzzle_m, request.target_m + Vec3{0.0, 1.5, 0.0})) {
    out.refusal = Refusal::masked;
    out.reason = "Weapon " + battery.weapon->name + " shoots along a straight line, and ground is in the way.";
  }
  return out;
}

ShellRecord Mission::State::flyLine(const Battery& battery, const FireSolution& solution, double along, double across) const {
  ShellRecord shell;
  shell.muzzle_m = solution.shot.muzzle_m;
  const Vec3 flat{solution.aim_m.x - shell.muzzle_m.x, 0.0, solution.aim_m.z - shell.muzzle_m.z};
  const double distance = length(flat);
  const Vec3 ahead = distance > 0.0 ? (1.0 / distance) * flat : Vec3{0.0, 0.0, -1.0}, right{-ahead.z, 0.0, ahead.x};
  // Half of the shots fall within one probable error on either side: sigma = PE / 0.6745.
  shell.burst_m = solution.aim_m + (along * battery.setup->pe_range_m / 0.6745) * ahead + (across * battery.setup->pe_deflection_m / 0.6745) * right;
  shell.burst_m.y = rec.terrain.surface(shell.burst_m.x, shell.burst_m.z);
  shell.burst_s = now_s + solution.time_of_flight_s;
  return shell;
}

}  // namespace npsee
