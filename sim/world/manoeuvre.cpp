#include "sim/world/manoeuvre.h"

#include <algorithm>
#include <cmath>

namespace npsee::world {
namespace {

/// Angles and speeds closer than this are met, rad and m/s.
constexpr double kMet_rad = 1e-3, kMet_mps = 1e-3;
/// Less room than this is none, m.
constexpr double kRoom_m = 3.0;

}  // namespace

std::int64_t ticksFor(double seconds) { return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(std::min(seconds, 1e6) / kMissionTick_s - 1e-9))); }

void Manoeuvre::add(const Move& move) {
  if (count == static_cast<int>(moves.size())) return;
  moves[static_cast<std::size_t>(count++)] = move;
  end = poseOn({0.0, end.x_m, end.z_m, end.heading_rad, move.speed_mps, move.acceleration_mps2, move.turn_radps}, static_cast<double>(move.ticks) * kMissionTick_s);
}

void Manoeuvre::turnTo(double heading_rad, double rate_radps) {
  const double angle = wrapped(heading_rad - end.heading_rad);
  if (std::fabs(angle) < kMet_rad) return;
  const std::int64_t ticks = ticksFor(std::fabs(angle) / std::max(rate_radps, 1e-3));
  add({end.speed_mps, 0.0, angle / (static_cast<double>(ticks) * kMissionTick_s), ticks});
}

void Manoeuvre::speedTo(double speed_mps, double rate_mps2) {
  const double change = speed_mps - end.speed_mps;
  if (std::fabs(change) < kMet_mps) return;
  const std::int64_t ticks = ticksFor(std::fabs(change) / rate_mps2);
  add({end.speed_mps, change / (static_cast<double>(ticks) * kMissionTick_s), 0.0, ticks});
  end.speed_mps = speed_mps;
}

void Manoeuvre::keepFor(double seconds) {
  const auto ticks = static_cast<std::int64_t>(std::floor(std::min(seconds, 1e6) / kMissionTick_s + 1e-9));
  if (ticks > 0) add({end.speed_mps, 0.0, 0.0, ticks});
}

double plan(const Passable& passable, Medium medium, const Wish& wish, Manoeuvre& moves) {
  const Pose from = moves.end;
  moves.turnTo(wish.heading_rad, wish.turn_radps);
  if (moves.count > 0 && from.speed_mps > kStanding_mps) {
    const Move& turn = moves.moves[0];
    const double arc = turn.speed_mps * static_cast<double>(turn.ticks) * kMissionTick_s;
    if (passable.freeLength(medium, from, turn.turn_radps / turn.speed_mps, arc) < arc) return -1.0;
  }
  const double room = passable.freeLength(medium, moves.end, 0.0, wish.length_m + brakingDistance(std::max(wish.speed_mps, from.speed_mps)));
  // The speed that leaves room to gain it and to brake again: v^2 / 2a + v^2 / 2b = room.
  const double fitting = std::sqrt(2.0 * room / (1.0 / kAccelerate_mps2 + 1.0 / kBrake_mps2));
  const double speed = std::min(wish.speed_mps, std::max(fitting, kStanding_mps));
  const double free = room - brakingDistance(std::max(speed, moves.end.speed_mps));
  if (free < kRoom_m) return -1.0;
  const Pose before = moves.end;
  moves.speedTo(speed, speed < before.speed_mps ? kBrake_mps2 : kAccelerate_mps2);
  const double dx = moves.end.x_m - before.x_m, dz = moves.end.z_m - before.z_m;
  moves.keepFor((std::min(free, wish.length_m) - std::sqrt(dx * dx + dz * dz)) / speed);
  return moves.count > 0 ? free : -1.0;
}

}  // namespace npsee::world
