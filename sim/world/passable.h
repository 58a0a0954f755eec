#pragma once

#include <npsee/recording.h>
#include <npsee/terrain.h>

namespace npsee::world {

/// What carries a vehicle.
enum class Medium { tracks, foot, water, air };
Medium mediumOf(TargetClass target_class);

/// Where vehicles of each kind can be.
class Passable {
 public:
  explicit Passable(const Terrain& terrain);

  /// In the world and on the right element: land, water, or anything for what flies.
  bool allowed(Medium medium, double x, double z) const;
  /// Where a driver would go: allowed with a margin to shore and edge, and not too steep.
  bool good(Medium medium, double x, double z) const;
  /// Length of the path from a pose along heading and turn (rad per metre) up to which all of it is good, at most `length`. With
  /// `only_allowed`, or from a start that is not good itself, up to which it is allowed.
  double freeLength(Medium medium, const Pose& from, double turn_per_m, double length, bool only_allowed = false) const;
  const Terrain& terrain() const { return terrain_; }

 private:
  Terrain terrain_;
  double margin_m_, step_m_;
};

/// Azimuth, clockwise from north, of the way from one place to another, rad.
double azimuthTo(double from_x, double from_z, double to_x, double to_z);
/// The angle in (-pi, pi] that differs from `angle_rad` by whole turns.
double wrapped(double angle_rad);

}  // namespace npsee::world
