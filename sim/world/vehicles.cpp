#include "sim/observer/sensing.h"
#include "sim/world/vehicle_state.h"

#include <algorithm>
#include <cmath>

namespace npsee::world {
namespace {

double timeOf(std::int64_t tick) { return static_cast<double>(tick) * kMissionTick_s; }
/// Fire is not fled from again within this time, s.
constexpr double kFleeAgain_s = 8.0;

}  // namespace

Pose Vehicles::State::poseAt(std::size_t v, std::int64_t tick) const { return poseOn(drivers[v].leg, timeOf(tick)); }

std::array<double, 4> Vehicles::State::draw(std::size_t v) { return observer::uniforms(seed, static_cast<std::uint32_t>(v), observer::Purpose::behaviour, drivers[v].draws++); }

void Vehicles::State::start(std::size_t v, std::int64_t tick, const Move& move) {
  Driver& driver = drivers[v];
  const Pose pose = poseAt(v, tick);
  const Leg leg{timeOf(tick), pose.x_m, pose.z_m, wrapped(pose.heading_rad), move.speed_mps, move.acceleration_mps2, move.turn_radps};
  driver.due = move.ticks == kNever ? kNever : tick + move.ticks;
  // Going on as before is no new leg.
  const bool level = leg.acceleration_mps2 == 0.0 && leg.turn_radps == 0.0 && driver.leg.acceleration_mps2 == 0.0 && driver.leg.turn_radps == 0.0;
  if (level && leg.speed_mps == driver.leg.speed_mps && !(*records)[v].track.legs.empty()) return;
  driver.leg = leg;
  (*records)[v].track.add(leg);
  ++legs;
}

void Vehicles::State::follow(std::size_t v, std::int64_t tick, const Manoeuvre& plan) {
  Driver& driver = drivers[v];
  driver.moves = plan.moves;
  driver.planned = plan.count;
  driver.next_move = 0;
  if (plan.count == 0) return stand(v, tick, 1.0);
  start(v, tick, driver.moves[static_cast<std::size_t>(driver.next_move++)]);
}

void Vehicles::State::stand(std::size_t v, std::int64_t tick, double again_s) {
  Driver& driver = drivers[v];
  driver.planned = driver.next_move = 0;
  const Pose pose = poseAt(v, tick);
  const std::int64_t again = again_s < 0.0 ? kNever : tick + ticksFor(again_s);
  if (pose.speed_mps <= kStanding_mps) {
    start(v, tick, {0.0, 0.0, 0.0, 1});
    driver.due = again;
    return;
  }
  const double brake = passable.freeLength(driver.medium, pose, 0.0, brakingDistance(pose.speed_mps), true) < brakingDistance(pose.speed_mps) ? kHardBrake_mps2 : kBrake_mps2;
  Manoeuvre moves(pose);
  moves.speedTo(0.0, brake);
  start(v, tick, moves.moves[0]);
  if (again != kNever) driver.due = std::max(driver.due, again);
  makeWay(v, tick);
}

void Vehicles::State::decide(std::size_t v, std::int64_t tick) {
  Driver& driver = drivers[v];
  if (driver.next_move < driver.planned) return start(v, tick, driver.moves[static_cast<std::size_t>(driver.next_move++)]);
  driver.retiring = false;
  if (driver.immobile) return stand(v, tick);
  if (driver.person) return obeyPerson(v, tick);
  switch (driver.behaviour) {
    case Behaviour::stationary:
    case Behaviour::user: return stand(v, tick);
    case Behaviour::straight: return keepStraight(v, tick);
    case Behaviour::meander: return meander(v, tick);
    case Behaviour::goals: return driveToGoals(v, tick);
    case Behaviour::follow: return followLeader(v, tick);
  }
}

Vehicles::Vehicles(std::unique_ptr<State> state) : state_(std::move(state)) {}
Vehicles::~Vehicles() = default;
Vehicles::Vehicles(Vehicles&&) noexcept = default;
Vehicles& Vehicles::operator=(Vehicles&&) noexcept = default;

void Vehicles::step(std::int64_t tick) {
  State& s = *state_;
  const double time = timeOf(tick);
  for (std::size_t v = 0; v < s.drivers.size(); ++v) {
    Driver& driver = s.drivers[v];
    if (driver.due <= tick) s.decide(v, tick);
    if (driver.leg.speed_mps == 0.0 && driver.leg.acceleration_mps2 == 0.0 && driver.leg.turn_radps == 0.0 && s.speed[v] == 0.0) continue;
    const Pose pose = poseOn(driver.leg, time);
    s.x[v] = pose.x_m;
    s.z[v] = pose.z_m;
    s.speed[v] = pose.speed_mps;
    s.heading[v] = pose.heading_rad;
  }
}

const std::vector<double>& Vehicles::x() const { return state_->x; }
const std::vector<double>& Vehicles::z() const { return state_->z; }
const std::vector<double>& Vehicles::speed() const { return state_->speed; }
std::size_t Vehicles::legs() const { return state_->legs; }

Vec3 Vehicles::velocity(std::size_t vehicle) const {
  // A pose one second on along a straight line is the velocity, without a second way to write sine and cosine.
  const Pose ahead = poseOn({0.0, 0.0, 0.0, state_->heading[vehicle], state_->speed[vehicle], 0.0, 0.0}, 1.0);
  return {ahead.x_m, 0.0, ahead.z_m};
}

bool Vehicles::noticesFire(std::size_t vehicle, std::int64_t tick, const Place& from) {
  const Driver& driver = state_->drivers[vehicle];
  const Reaction reaction = driver.reaction;
  if (driver.person) return false;
  const bool flees = reaction == Reaction::retire || reaction == Reaction::both;
  const bool again = driver.fled < 0 || tick - driver.fled >= ticksFor(kFleeAgain_s);
  if (flees && again) withdraw(vehicle, tick, from);
  return reaction == Reaction::return_fire || reaction == Reaction::both;
}

void Vehicles::withdraw(std::size_t vehicle, std::int64_t tick, const Place& from) {
  const Driver& driver = state_->drivers[vehicle];
  if (!driver.immobile && !driver.person) state_->retire(vehicle, tick, from);
}

void Vehicles::immobilise(std::size_t vehicle, std::int64_t tick) {
  Driver& driver = state_->drivers[vehicle];
  if (driver.immobile) return;
  driver.immobile = true;
  driver.planned = driver.next_move = 0;
  Manoeuvre moves(state_->poseAt(vehicle, tick));
  moves.speedTo(0.0, kHardBrake_mps2);
  if (moves.count == 0) return state_->stand(vehicle, tick);
  state_->start(vehicle, tick, moves.moves[0]);
  state_->makeWay(vehicle, tick);
}

void Vehicles::drive(std::size_t vehicle, std::int64_t tick, double speed_mps, double turn_radps) {
  Driver& driver = state_->drivers[vehicle];
  if (driver.immobile) return;
  driver.person = true;
  driver.retiring = false;
  driver.planned = driver.next_move = 0;
  driver.asked_mps = std::isfinite(speed_mps) ? std::clamp(speed_mps, 0.0, driver.greatest_mps) : 0.0;
  driver.asked_turn_radps = std::isfinite(turn_radps) ? std::clamp(turn_radps, -driver.turn_radps, driver.turn_radps) : 0.0;
  state_->obeyPerson(vehicle, tick);
}

void Vehicles::hand(std::size_t vehicle, std::int64_t tick, bool to_person) {
  Driver& driver = state_->drivers[vehicle];
  if (driver.immobile || driver.person == to_person) return;
  // It goes on as it was until the first command: nobody wants a jolt.
  if (to_person) return drive(vehicle, tick, state_->poseAt(vehicle, tick).speed_mps, 0.0);
  driver.person = false;
  driver.route.clear();
  state_->decide(vehicle, tick);
}

}  // namespace npsee::world
