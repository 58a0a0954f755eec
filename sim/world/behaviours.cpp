#include "sim/world/vehicle_state.h"

#include <algorithm>
#include <cmath>

namespace npsee::world {
namespace {

/// Room that a meandering driver wants ahead, and the least that is worth driving, m.
constexpr double kEnough_m = 150.0, kLeast_m = 15.0;
/// A straight piece towards a goal, s: the speed is then chosen anew for the slope.
constexpr double kPiece_s = 20.0;
/// A corner is passed within this, a goal is reached within this, and counts as reached where the way is barred, m.
constexpr double kCorner_m = 12.0, kReached_m = 3.0, kBarredNear_m = 80.0;
constexpr int kMostBarred = 4;
/// Where others are in the way, a driver looks again after this time, s, and gives a goal up after so many times without coming this much nearer, m.
constexpr double kWait_s = 2.0, kOnward_m = 100.0;
constexpr int kMostWaits = 15;

double distanceTo(const Pose& pose, const Place& place) {
  const double dx = place.x_m - pose.x_m, dz = place.z_m - pose.z_m;
  return std::sqrt(dx * dx + dz * dz);
}

double azimuthTo(const Pose& pose, const Place& place) { return world::azimuthTo(pose.x_m, pose.z_m, place.x_m, place.z_m); }

}  // namespace

double Vehicles::State::speedOn(std::size_t v, const Pose& pose, double heading_rad, double length_m) const {
  const Driver& driver = drivers[v];
  if (driver.medium == Medium::air || driver.medium == Medium::water) return driver.wished_mps;
  const Pose ahead = poseOn({0.0, pose.x_m, pose.z_m, heading_rad, 1.0, 0.0, 0.0}, length_m);
  const Terrain& ground = passable.terrain();
  const double slope = std::fabs(ground.height(ahead.x_m, ahead.z_m) - ground.height(pose.x_m, pose.z_m)) / std::max(1.0, length_m);
  // Game value: full speed up to a tenth, a third at six tenths.
  return driver.wished_mps * std::clamp(1.0 - 1.3 * (slope - 0.1), 0.33, 1.0);
}

void Vehicles::State::head(std::size_t v, std::int64_t tick, const Wish& wish, double enough_m, bool left_first) {
  const Driver& driver = drivers[v];
  const Pose pose = poseAt(v, tick);
  Manoeuvre best(pose);
  double widest = -1.0;
  bool crowded = false;
  for (int i = 0; i <= 18; ++i) {
    const int step = (i + 1) / 2;
    const double offset = 20.0 * kDegree * step * ((i % 2 == 0) == left_first ? -1.0 : 1.0);
    Wish tried = wish;
    tried.heading_rad = wrapped(wish.heading_rad + offset);
    Manoeuvre moves(pose);
    const double free = plan(passable, driver.medium, tried, moves);
    const bool enough = free >= std::min(enough_m, wish.length_m);
    if (!enough && free <= widest) continue;
    if (!clearOfOthers(v, tick, moves)) {
      crowded = true;
      continue;
    }
    if (enough) return follow(v, tick, moves);
    widest = free;
    best = moves;
  }
  if (widest >= kLeast_m) return follow(v, tick, best);
  if (crowded) return keepClear(v, tick);
  breakOut(v, tick, wish.heading_rad);
}

/// Others leave no way that is wanted: straight on for a moment, which they have reckoned with, or else brakes.
void Vehicles::State::keepClear(std::size_t v, std::int64_t tick) {
  const Pose pose = poseAt(v, tick);
  Manoeuvre on(pose);
  on.keepFor(kWait_s);
  const double length = pose.speed_mps * kWait_s + brakingDistance(pose.speed_mps);
  if (pose.speed_mps > kStanding_mps && passable.freeLength(drivers[v].medium, pose, 0.0, length) >= length && clearOfOthers(v, tick, on)) return follow(v, tick, on);
  stand(v, tick, kWait_s);
}

/// In a tight corner: stops, turns on the spot to where there is most room, and goes on slowly.
void Vehicles::State::breakOut(std::size_t v, std::int64_t tick, double heading_rad) {
  const Driver& driver = drivers[v];
  Pose pose = poseAt(v, tick);
  if (pose.speed_mps > kStanding_mps) return stand(v, tick, 0.1);
  pose.speed_mps = 0.0;
  Manoeuvre best(pose);
  double widest = -1.0;
  for (int i = 0; i < 16; ++i) {
    Manoeuvre moves(pose);
    const double free = plan(passable, driver.medium, {heading_rad + i * kTwoPi / 16.0, std::min(driver.wished_mps, 3.0), kEnough_m, driver.turn_radps}, moves);
    if (free <= widest || !clearOfOthers(v, tick, moves)) continue;
    widest = free;
    best = moves;
  }
  if (widest > 0.0) return follow(v, tick, best);
  stand(v, tick, 30.0);
}

void Vehicles::State::keepStraight(std::size_t v, std::int64_t tick) {
  const Driver& driver = drivers[v];
  const Pose pose = poseAt(v, tick);
  if (driver.wished_mps <= kStanding_mps) return stand(v, tick);
  Manoeuvre moves(pose);
  moves.speedTo(driver.wished_mps, pose.speed_mps < driver.wished_mps ? kAccelerate_mps2 : kBrake_mps2);
  const double run = 30.0 * driver.wished_mps, brake = brakingDistance(driver.wished_mps) + 1.0;
  const double free = passable.freeLength(driver.medium, pose, 0.0, run + brake, true);
  // Slopes do not stop it, only the shore and the edge.
  if (free < brake + driver.wished_mps) return stand(v, tick);
  if (moves.count == 0) moves.keepFor(std::max(0.1, std::min(run, free - brake) / driver.wished_mps));
  follow(v, tick, moves);
  makeWay(v, tick);
}

void Vehicles::State::meander(std::size_t v, std::int64_t tick) {
  Driver& driver = drivers[v];
  if (driver.wished_mps <= kStanding_mps) return stand(v, tick);
  const auto u = draw(v);
  const Pose pose = poseAt(v, tick);
  Wish wish;
  wish.heading_rad = pose.heading_rad + (u[0] - 0.5) * 140.0 * kDegree;
  wish.turn_radps = driver.turn_radps * (0.3 + 0.6 * u[3]);
  const double time = 15.0 + 35.0 * u[1];
  wish.length_m = driver.wished_mps * time;
  wish.speed_mps = (0.7 + 0.3 * u[2]) * speedOn(v, pose, wish.heading_rad, wish.length_m);
  head(v, tick, wish, kEnough_m, u[0] < 0.5);
}

/// Moves towards a place, or says why not.
Vehicles::State::Way Vehicles::State::approach(std::size_t v, std::int64_t tick, const Place& place, bool stop) {
  const Driver& driver = drivers[v];
  const Pose pose = poseAt(v, tick);
  const double distance = distanceTo(pose, place);
  Manoeuvre moves(pose);
  const auto followed = [&] {
    if (!clearOfOthers(v, tick, moves)) return Way::crowded;
    follow(v, tick, moves);
    return Way::free;
  };
  // What lies within the turning circle is reached only more slowly.
  const double off = std::fabs(wrapped(azimuthTo(pose, place) - pose.heading_rad));
  if (pose.speed_mps > kStanding_mps && off > 0.2 && distance < 2.5 * pose.speed_mps / driver.turn_radps) {
    const double slower = distance * driver.turn_radps / 3.0;
    moves.speedTo(slower < 1.0 ? 0.0 : slower, kBrake_mps2);
    const double length = distanceTo(pose, {moves.end.x_m, moves.end.z_m});
    if (moves.count > 0 && passable.freeLength(driver.medium, pose, 0.0, length) < length) return Way::barred;
    if (moves.count > 0) return followed();
  }
  // After the turn the place shall lie straight ahead: where the turn ends depends on how far it goes.
  double heading_to = azimuthTo(pose, place);
  for (int i = 0; i < 5; ++i) {
    Manoeuvre turned(pose);
    turned.turnTo(heading_to, 0.8 * driver.turn_radps);
    heading_to = azimuthTo(turned.end, place);
  }
  Manoeuvre turned(pose);
  turned.turnTo(heading_to, 0.8 * driver.turn_radps);
  const double rest = distanceTo(turned.end, place), v0 = pose.speed_mps;
  if (stop && turned.count == 0 && v0 > kStanding_mps && rest <= 1.02 * brakingDistance(v0) + v0 * kMissionTick_s) {
    const std::int64_t ticks = ticksFor(2.0 * rest / v0);
    moves.add({v0, -v0 / (static_cast<double>(ticks) * kMissionTick_s), 0.0, ticks});
    return followed();
  }
  Wish wish{heading_to, speedOn(v, turned.end, heading_to, std::min(rest, 200.0)), 0.0, 0.8 * driver.turn_radps};
  // To stop there: v^2 / 2a + v^2 / 2b of way is needed from a stand.
  if (stop) wish.speed_mps = std::min(wish.speed_mps, std::max(std::sqrt(2.0 * rest / (1.0 / kAccelerate_mps2 + 1.0 / kBrake_mps2)), std::min(v0, std::sqrt(2.0 * kBrake_mps2 * rest))));
  wish.length_m = std::min(std::max(wish.speed_mps, 1.0) * kPiece_s, rest - (stop ? brakingDistance(std::max(wish.speed_mps, v0)) : 0.0));
  if (wish.length_m <= 0.0) wish.length_m = 0.5 * rest;
  return plan(passable, driver.medium, wish, moves) >= std::min(wish.length_m, kLeast_m) - 1e-6 ? followed() : Way::barred;
}

void Vehicles::State::driveToGoals(std::size_t v, std::int64_t tick) {
  Driver& driver = drivers[v];
  const Pose pose = poseAt(v, tick);
  if (driver.wished_mps <= kStanding_mps) return stand(v, tick);
  for (std::size_t looked = 0; looked <= driver.goals.size(); ++looked) {
    if (driver.goal >= driver.goals.size() && driver.repeat) driver.goal = 0;
    if (driver.goal >= driver.goals.size()) return stand(v, tick);
    const Place goal = driver.goals[driver.goal];
    const bool last = !driver.repeat && driver.goal + 1 == driver.goals.size();
    const double far = distanceTo(pose, goal);
    bool reached = far <= (last ? kReached_m : kCorner_m);
    if (!reached && driver.route.empty()) {
      driver.route = router.route(driver.medium, {pose.x_m, pose.z_m}, goal);
      driver.corner = 0;
      // There is no way: on to the next goal.
      reached = driver.route.empty();
    }
    while (!reached && driver.corner + 1 < driver.route.size() && distanceTo(pose, driver.route[driver.corner]) <= kCorner_m) {
      ++driver.corner;
      driver.barred = 0;
    }
    if (!reached) {
      const bool to_goal = driver.corner + 1 == driver.route.size();
      const Way way = approach(v, tick, driver.route[driver.corner], to_goal && last);
      if (way == Way::free) return;
      // Around who is in the way, or after him.
      if (driver.waited == 0 || far < driver.waited_m - kOnward_m) {
        driver.waited = 0;
        driver.waited_m = far;
      }
      if (way == Way::crowded && ++driver.waited <= kMostWaits) return head(v, tick, {azimuthTo(pose, driver.route[driver.corner]), driver.wished_mps, 60.0, driver.turn_radps}, 30.0, driver.waited % 2 == 0);
      driver.route.clear();
      driver.waited = 0;
      reached = far <= kBarredNear_m || ++driver.barred > kMostBarred;
      if (!reached) return head(v, tick, {azimuthTo(pose, goal), driver.wished_mps, 60.0, driver.turn_radps}, 30.0, driver.barred % 2 == 0);
    }
    driver.route.clear();
    driver.barred = driver.waited = 0;
    ++driver.goal;
  }
  stand(v, tick, 30.0);
}

}  // namespace npsee::world
