#include "sim/world/vehicle_state.h"

#include <algorithm>
#include <cmath>

namespace npsee::world {
namespace {

/// A follower looks at the vehicle ahead once a second; a person's vehicle looks ahead twice.
constexpr double kFollowEvery_s = 1.0, kPersonEvery_s = 0.5;
/// A retreat goes this far at most, and this far at least if it can, m.
constexpr double kRetreat_m = 1200.0, kLeastRetreat_m = 300.0;
constexpr double kEye_m = 2.0;
/// A leader's trail is read in such steps; one longer than this is not measured, s.
constexpr double kTrailStep_s = 0.5, kLongTrail_s = 120.0;

double between(const Pose& a, const Pose& b) { return std::sqrt((a.x_m - b.x_m) * (a.x_m - b.x_m) + (a.z_m - b.z_m) * (a.z_m - b.z_m)); }

}  // namespace

/// Takes the place of a leader that can move no more: follows who he followed, or drives on to his goals.
void Vehicles::State::succeedLeader(std::size_t v, std::int64_t tick) {
  Driver& driver = drivers[v];
  const Driver& leader = drivers[static_cast<std::size_t>(driver.leader)];
  const int next = leader.leader;
  if (leader.behaviour == Behaviour::follow && next >= 0 && next != static_cast<int>(v)) {
    driver.leader = next;
    driver.trail_s = 0.0;
    return stand(v, tick, kFollowEvery_s);
  }
  driver.leader = -1;
  if (leader.goals.empty()) return stand(v, tick);
  driver.behaviour = Behaviour::goals;
  driver.goals = leader.goals;
  driver.goal = leader.goal;
  driver.repeat = leader.repeat;
  driver.route.clear();
  if (driver.wished_mps <= kStanding_mps) driver.wished_mps = leader.wished_mps;
  driveToGoals(v, tick);
}

/// Moves along the leader's trail: the next point of it to steer for, and how far it still is along it to where he is now.
Vehicles::State::Trail Vehicles::State::trailAhead(std::size_t v, std::int64_t tick) {
  Driver& driver = drivers[v];
  const Track& trail = (*records)[static_cast<std::size_t>(driver.leader)].track;
  const double now = static_cast<double>(tick) * kMissionTick_s;
  const Pose pose = poseAt(v, tick);
  const double look_ahead = std::max(6.0, 1.2 * pose.speed_mps);
  Trail out;
  out.point = trail.at(driver.trail_s);
  while (driver.trail_s + kTrailStep_s <= now && between(out.point, pose) < look_ahead) {
    driver.trail_s += kTrailStep_s;
    out.point = trail.at(driver.trail_s);
  }
  out.leader = trail.at(now);
  out.distance_m = between(pose, out.point);
  // Far behind, the straight line will do.
  if (now - driver.trail_s > kLongTrail_s) {
    out.distance_m += between(out.point, out.leader);
    return out;
  }
  Pose last = out.point;
  for (double t = driver.trail_s + 1.0; t < now; t += 1.0) {
    const Pose next = trail.at(t);
    out.distance_m += between(last, next);
    last = next;
  }
  out.distance_m += between(last, out.leader);
  return out;
}

void Vehicles::State::followLeader(std::size_t v, std::int64_t tick) {
  Driver& driver = drivers[v];
  if (driver.leader < 0) return stand(v, tick);
  if (drivers[static_cast<std::size_t>(driver.leader)].immobile) return succeedLeader(v, tick);
  const Trail trail = trailAhead(v, tick);
  const Pose pose = poseAt(v, tick);
  const double away = between(pose, trail.point), over = trail.distance_m - driver.gap_m;
  double wished = trail.leader.speed_mps + 0.3 * over;
  if (over < 1.0 && trail.leader.speed_mps <= kStanding_mps) wished = 0.0;
  wished = std::clamp(wished, std::max(0.0, pose.speed_mps - kBrake_mps2 * kFollowEvery_s), std::min(driver.greatest_mps, pose.speed_mps + kAccelerate_mps2 * kFollowEvery_s));
  if (wished <= kStanding_mps && pose.speed_mps <= kStanding_mps) return stand(v, tick, kFollowEvery_s);

  const double off = away > 1.0 ? wrapped(azimuthTo(pose.x_m, pose.z_m, trail.point.x_m, trail.point.z_m) - pose.heading_rad) : 0.0;
  Move move{pose.speed_mps, (wished - pose.speed_mps) / kFollowEvery_s, 0.0, ticksFor(kFollowEvery_s)};
  if (std::fabs(move.acceleration_mps2) < 0.05) move.acceleration_mps2 = 0.0;
  if (std::fabs(off) > 0.01) {
    // The circle through the point ahead (pure pursuit). A leg either speeds up or turns, so the speed changes by a small step; far off the
    // line it turns first.
    const double speed_now = std::fabs(off) > 1.0 ? std::min(wished, 2.0) : std::max(wished, kStanding_mps);
    move = {speed_now, 0.0, std::clamp(2.0 * std::max(speed_now, 2.0) * off / away, -driver.turn_radps, driver.turn_radps), ticksFor(kFollowEvery_s)};
  }
  const double fastest = std::max(move.speed_mps, wished), length = fastest * kFollowEvery_s;
  const bool free = passable.freeLength(driver.medium, pose, move.turn_radps / std::max(0.5, move.speed_mps), length, true) >= length &&
                    passable.freeLength(driver.medium, pose, 0.0, brakingDistance(fastest), true) >= std::min(length, brakingDistance(fastest));
  if (!free) return breakOut(v, tick, wrapped(pose.heading_rad + off));
  driver.planned = driver.next_move = 0;
  start(v, tick, move);
  makeWay(v, tick);
}

void Vehicles::State::obeyPerson(std::size_t v, std::int64_t tick) {
  Driver& driver = drivers[v];
  const Pose pose = poseAt(v, tick);
  driver.planned = driver.next_move = 0;
  const double change = std::clamp(driver.asked_mps - pose.speed_mps, -kBrake_mps2 * kPersonEvery_s, kAccelerate_mps2 * kPersonEvery_s);
  const double then = pose.speed_mps + change;
  const bool moves = std::max(then, pose.speed_mps) > kStanding_mps;
  if (!moves && driver.asked_turn_radps == 0.0) return stand(v, tick);
  // A leg either speeds up or turns: in a turn the speed changes by small steps.
  Move move{pose.speed_mps, change / kPersonEvery_s, 0.0, ticksFor(kPersonEvery_s)};
  if (driver.asked_turn_radps != 0.0) move = {then <= kStanding_mps ? 0.0 : then, 0.0, driver.asked_turn_radps, ticksFor(kPersonEvery_s)};
  if (moves) {
    const double fastest = std::max(then, pose.speed_mps), length = fastest * kPersonEvery_s + brakingDistance(fastest);
    if (passable.freeLength(driver.medium, pose, move.turn_radps / std::max(fastest, 0.5), length, true) < length) {
      driver.asked_mps = 0.0;
      driver.asked_turn_radps = 0.0;
      return stand(v, tick);
    }
  }
  start(v, tick, move);
  makeWay(v, tick);
}

void Vehicles::State::retire(std::size_t v, std::int64_t tick, const Place& from) {
  Driver& driver = drivers[v];
  driver.fled = tick;
  driver.route.clear();
  const Pose pose = poseAt(v, tick);
  const Terrain& ground = passable.terrain();
  const double dx = pose.x_m - from.x_m, dz = pose.z_m - from.z_m;
  const double away = dx * dx + dz * dz > 1.0 ? azimuthTo(from.x_m, from.z_m, pose.x_m, pose.z_m) : pose.heading_rad;
  const Vec3 threat{from.x_m, ground.height(from.x_m, from.z_m) + kEye_m, from.z_m};
  Manoeuvre best(pose);
  double most = -INFINITY;
  for (int i = -4; i <= 4; ++i) {
    Manoeuvre moves(pose);
    const double free = plan(passable, driver.medium, {away + 28.0 * kDegree * i, driver.greatest_mps, kRetreat_m, driver.turn_radps}, moves);
    if (free < 0.0) continue;
    const Vec3 end{moves.end.x_m, ground.height(moves.end.x_m, moves.end.z_m) + kEye_m, moves.end.z_m};
    // Game values: away counts most, then room, then a place that the fire's origin does not see.
    const double worth = -0.12 * i * i + 1.5 * std::min(1.0, free / kLeastRetreat_m) + (ground.sight(threat, end).clear ? 0.0 : 0.6);
    if (worth <= most) continue;
    most = worth;
    best = moves;
  }
  driver.retiring = true;
  if (best.count == 0) return breakOut(v, tick, away);
  follow(v, tick, best);
  makeWay(v, tick);
}

}  // namespace npsee::world
