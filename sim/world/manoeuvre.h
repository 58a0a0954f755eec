#pragma once

#include "sim/world/passable.h"

#include <array>
#include <cstdint>

namespace npsee::world {

/// Game values, m/s^2: how drivers speed up and brake, and how a hit vehicle stops.
inline constexpr double kAccelerate_mps2 = 1.5, kBrake_mps2 = 3.0, kHardBrake_mps2 = 7.0;
/// Slower than this is standing, m/s.
inline constexpr double kStanding_mps = 0.05;

inline double brakingDistance(double speed_mps) { return speed_mps * speed_mps / (2.0 * kBrake_mps2); }
/// Whole ticks that a time takes, at least one.
std::int64_t ticksFor(double seconds);

/// One leg to be: from wherever the vehicle then is.
struct Move {
  double speed_mps = 0.0, acceleration_mps2 = 0.0, turn_radps = 0.0;
  std::int64_t ticks = 1;
};

/// A few moves one after the other, and the pose they lead to.
struct Manoeuvre {
  Pose end;
  std::array<Move, 4> moves;
  int count = 0;

  explicit Manoeuvre(const Pose& from) : end(from) {}
  void add(const Move& move);
  /// Around to a heading at the present speed (on the spot when standing).
  void turnTo(double heading_rad, double rate_radps);
  /// Straight on to a speed.
  void speedTo(double speed_mps, double rate_mps2 = kAccelerate_mps2);
  void keepFor(double seconds);
};

/// What a driver wants: around to a heading, then on at a speed for a length.
struct Wish {
  double heading_rad = 0.0, speed_mps = 0.0, length_m = 0.0, turn_radps = 0.3;
};

/// The moves of a wish as far as the way is free, room for braking kept. The free length after the turn is returned; negative: not even the
/// turn is free, or there is no room to move.
double plan(const Passable& passable, Medium medium, const Wish& wish, Manoeuvre& moves);

}  // namespace npsee::world
