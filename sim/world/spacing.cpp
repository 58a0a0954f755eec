#include "sim/world/vehicle_state.h"

#include <algorithm>
#include <cmath>

namespace npsee::world {
namespace {

/// Two courses are compared at such steps; between them both are taken as straight, s.
constexpr double kStep_s = 1.0;
/// After its plan a driver is expected to go straight on for this long; what he does then nobody knows, s.
constexpr double kBeyond_s = 8.0;

double timeOf(std::int64_t tick) { return static_cast<double>(tick) * kMissionTick_s; }

/// Least distance from the origin of a point that moves straight from (ax, az) to (bx, bz), squared.
double leastSquared(double ax, double az, double bx, double bz) {
  const double dx = bx - ax, dz = bz - az, dd = dx * dx + dz * dz;
  const double share = dd > 0.0 ? std::clamp(-(ax * dx + az * dz) / dd, 0.0, 1.0) : 0.0;
  const double x = ax + share * dx, z = az + share * dz;
  return x * x + z * z;
}

/// Whether two courses keep `apart_m`. Those that are nearer already must only not come nearer still.
bool keepApart(const Course& a, const Course& b, double now_s, double apart_m) {
  const double until = std::min(a.known_until_s, b.known_until_s);
  Pose pa = a.at(now_s), pb = b.at(now_s);
  double dx = pb.x_m - pa.x_m, dz = pb.z_m - pa.z_m;
  const double least = std::min(apart_m * apart_m, 0.98 * (dx * dx + dz * dz));
  for (double t = now_s; t < until;) {
    t = std::min(t + kStep_s, until);
    pa = a.at(t);
    pb = b.at(t);
    const double next_x = pb.x_m - pa.x_m, next_z = pb.z_m - pa.z_m;
    if (leastSquared(dx, dz, next_x, next_z) < least) return false;
    dx = next_x;
    dz = next_z;
  }
  return true;
}

bool still(const Leg& leg) { return leg.speed_mps <= kStanding_mps && leg.acceleration_mps2 == 0.0; }

}  // namespace

Pose Course::at(double time_s) const {
  int i = count - 1;
  while (i > 0 && legs[static_cast<std::size_t>(i)].start_s > time_s) --i;
  return poseOn(legs[static_cast<std::size_t>(i)], time_s);
}

void Course::then(const Leg& leg, std::int64_t ticks) {
  legs[static_cast<std::size_t>(count++)] = leg;
  const Pose end = poseOn(leg, leg.start_s + timeOf(ticks));
  legs[static_cast<std::size_t>(count)] = {leg.start_s + timeOf(ticks), end.x_m, end.z_m, end.heading_rad, end.speed_mps, 0.0, 0.0};
}

void Course::goOn() {
  const Leg& last = legs[static_cast<std::size_t>(count++)];
  known_until_s = still(last) ? last.start_s + kForever_s : last.start_s + kBeyond_s;
}

void Course::then(const Move& move) {
  const Leg& from = legs[static_cast<std::size_t>(count)];
  then(Leg{from.start_s, from.x_m, from.z_m, from.heading_rad, move.speed_mps, move.acceleration_mps2, move.turn_radps}, move.ticks);
}

/// What a driver is about, from now on.
Course Vehicles::State::courseOf(std::size_t v, std::int64_t tick) const {
  const Driver& driver = drivers[v];
  Course course;
  if (driver.due == kNever || (driver.next_move >= driver.planned && still(driver.leg))) {
    course.legs[0] = driver.leg;
    course.count = 1;
    course.known_until_s = timeOf(tick) + Course::kForever_s;
    return course;
  }
  const Leg& leg = driver.leg;
  course.then(leg, driver.due - static_cast<std::int64_t>(std::floor(leg.start_s / kMissionTick_s + 0.5)));
  for (int i = driver.next_move; i < driver.planned; ++i) course.then(driver.moves[static_cast<std::size_t>(i)]);
  course.goOn();
  return course;
}

/// Aircraft fly over all; a column is kept apart by its gaps.
bool Vehicles::State::canMeet(std::size_t v, std::size_t u) const {
  const Driver &mine = drivers[v], &other = drivers[u];
  return v != u && (mine.medium == Medium::air) == (other.medium == Medium::air) && other.leader != static_cast<int>(v) && mine.leader != static_cast<int>(u);
}

bool Vehicles::State::clearOfOthers(std::size_t v, std::int64_t tick, const Manoeuvre& plan) const {
  const Pose pose = poseAt(v, tick);
  Course mine;
  mine.legs[0] = {timeOf(tick), pose.x_m, pose.z_m, pose.heading_rad, pose.speed_mps, 0.0, 0.0};
  for (int i = 0; i < plan.count; ++i) mine.then(plan.moves[static_cast<std::size_t>(i)]);
  mine.goOn();
  return std::ranges::all_of(neighbours(v, tick, mine), [&](std::size_t u) { return !canMeet(v, u) || keepApart(mine, courseOf(u, tick), timeOf(tick), apart(v, u)); });
}

/// Those that the course might meet.
const std::vector<std::size_t>& Vehicles::State::neighbours(std::size_t v, std::int64_t tick, const Course& course) const {
  nearby.clear();
  const double now = timeOf(tick), lasts = std::min(course.known_until_s - now, Course::kForever_s);
  for (std::size_t u = 0; u < drivers.size(); ++u) {
    // Positions are those of the last step; a tick's way is little.
    const double dx = x[u] - x[v], dz = z[u] - z[v], reach = (drivers[v].greatest_mps + drivers[u].greatest_mps) * lasts + apart(v, u);
    if (dx * dx + dz * dz < reach * reach) nearby.push_back(u);
  }
  return nearby;
}

double Vehicles::State::apart(std::size_t v, std::size_t u) const { return drivers[v].radius_m + drivers[u].radius_m + kBetween_m; }

void Vehicles::State::makeWay(std::size_t v, std::int64_t tick) {
  const Course mine = courseOf(v, tick);
  for (const std::size_t u : neighbours(v, tick, mine)) {
    Driver& other = drivers[u];
    const bool looks = (other.behaviour == Behaviour::meander || other.behaviour == Behaviour::goals) && !other.person && !other.immobile && !other.retiring;
    if (!looks || still(other.leg) || !canMeet(u, v) || keepApart(mine, courseOf(u, tick), timeOf(tick), apart(v, u))) continue;
    other.planned = other.next_move = 0;
    other.due = std::min(other.due, tick);
  }
}

}  // namespace npsee::world
