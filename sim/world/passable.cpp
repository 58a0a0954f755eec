#include "sim/world/passable.h"

#include "sim/ballistics/angles.h"

#include <algorithm>
#include <cmath>

namespace npsee::world {
namespace {

/// Steepest ground taken on, as rise over run; game values.
constexpr double kSteepForTracks = 0.6, kSteepOnFoot = 1.0;
/// Kept from the edge of the world, and over (or under) the sea level, m.
constexpr double kEdge_m = 5.0, kShore_m = 0.5, kDraught_m = 1.0;

double slopeOf(const Vec3& normal) { return std::sqrt(std::max(0.0, 1.0 - normal.y * normal.y)) / std::max(1e-9, normal.y); }

}  // namespace

Medium mediumOf(TargetClass target_class) {
  switch (target_class) {
    case TargetClass::personnel: return Medium::foot;
    case TargetClass::aircraft: return Medium::air;
    case TargetClass::watercraft: return Medium::water;
    case TargetClass::heavy_armor:
    case TargetClass::light_armor:
    case TargetClass::wheeled: break;
  }
  return Medium::tracks;
}

Passable::Passable(const Terrain& terrain)
    : terrain_(terrain), margin_m_(std::min(kEdge_m, 0.05 * std::min(terrain.sizeX(), terrain.sizeZ()))), step_m_(std::clamp(0.5 * terrain.detail(), 4.0, 15.0)) {}

bool Passable::allowed(Medium medium, double x, double z) const {
  if (!terrain_.inside(x, z)) return false;
  return medium == Medium::air || terrain_.sea(x, z) == (medium == Medium::water);
}

bool Passable::good(Medium medium, double x, double z) const {
  if (!(x >= margin_m_ && z >= margin_m_ && x <= terrain_.sizeX() - margin_m_ && z <= terrain_.sizeZ() - margin_m_)) return false;
  if (medium == Medium::air) return true;
  const double over = terrain_.height(x, z) - terrain_.seaLevel();
  if (medium == Medium::water) return over <= -kDraught_m;
  return over >= kShore_m && slopeOf(terrain_.normal(x, z)) <= (medium == Medium::foot ? kSteepOnFoot : kSteepForTracks);
}

double Passable::freeLength(Medium medium, const Pose& from, double turn_per_m, double length, bool only_allowed) const {
  const bool strict = !only_allowed && good(medium, from.x_m, from.z_m);
  // At one metre a second, time is length.
  const Leg path{0.0, from.x_m, from.z_m, from.heading_rad, 1.0, 0.0, turn_per_m};
  const int steps = std::max(1, static_cast<int>(std::ceil(length / step_m_)));
  for (int i = 1; i <= steps; ++i) {
    const Pose pose = poseOn(path, length * i / steps);
    if (!(strict ? good(medium, pose.x_m, pose.z_m) : allowed(medium, pose.x_m, pose.z_m))) return length * (i - 1) / steps;
  }
  return length;
}

double azimuthTo(double from_x, double from_z, double to_x, double to_z) { return ballistics::angleOf(from_z - to_z, to_x - from_x); }

double wrapped(double angle_rad) { return angle_rad - kTwoPi * std::ceil((angle_rad - kPi) / kTwoPi); }

}  // namespace npsee::world
