#pragma once

#include "sim/world/manoeuvre.h"
#include "sim/world/route.h"
#include "sim/world/vehicles.h"

#include <limits>

namespace npsee::world {

/// Kept free between the circles around two vehicles, m.
inline constexpr double kBetween_m = 2.0;
inline constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();

/// One driver: what he was told, and what he is about.
struct Driver {
  Medium medium = Medium::tracks;
  Behaviour behaviour = Behaviour::stationary;
  Reaction reaction = Reaction::none;
  double wished_mps = 0.0, greatest_mps = 0.0, turn_radps = 0.3;
  double radius_m = 0.0;            ///< of a circle around it

  Leg leg;                          ///< under way
  std::int64_t due = 0;             ///< tick of the next decision
  std::array<Move, 4> moves;        ///< planned after this leg
  int next_move = 0, planned = 0;
  std::uint32_t draws = 0;
  bool immobile = false;

  bool person = false;              ///< driven by commands
  double asked_mps = 0.0, asked_turn_radps = 0.0;

  bool retiring = false;
  std::int64_t fled = -1;           ///< tick at which it last turned away from fire

  std::vector<Place> goals;
  bool repeat = false;
  std::size_t goal = 0;
  std::vector<Place> route;         ///< corners to the goal
  std::size_t corner = 0;
  int barred = 0;                   ///< plans in a row that came to nothing
  int waited = 0;                   ///< and those that others were in the way of
  double waited_m = 0.0;            ///< distance to the goal when they began

  int leader = -1;
  double gap_m = 50.0;
  double trail_s = 0.0;             ///< when the leader was where this one steers for
};

/// The legs to come of a driver, as far as they are known.
struct Course {
  /// Longer than any plan is looked at, s.
  static constexpr double kForever_s = 120.0;
  std::array<Leg, 6> legs;          ///< legs[count] begins where the ones before it end
  int count = 0;
  double known_until_s = 0.0;

  Pose at(double time_s) const;
  void then(const Leg& leg, std::int64_t ticks);
  void then(const Move& move);
  /// After the last leg it stands, or goes straight on for a while.
  void goOn();
};

struct Vehicles::State {
  std::int64_t seed = 0;
  Passable passable;
  Router router;
  std::vector<VehicleRecord>* records = nullptr;
  std::vector<Driver> drivers;
  std::vector<double> x, z, speed, heading;
  std::size_t legs = 0;             ///< added to the records
  mutable std::vector<std::size_t> nearby;  ///< reused

  State(const Terrain& terrain, std::int64_t seed_of_mission) : seed(seed_of_mission), passable(terrain), router(passable) {}

  // vehicles_make.cpp
  Expected<void> fill(const Scenario& scenario);
  void addVehicle(const std::string& id, const VehicleType& type, const VehicleSetup& setup);
  bool occupied(const Place& place, const VehicleType& type) const;
  Expected<void> addGroup(const Scenario& scenario, std::size_t group, const VehicleType& type);

  // vehicles.cpp
  Pose poseAt(std::size_t v, std::int64_t tick) const;
  std::array<double, 4> draw(std::size_t v);
  /// From now on along this move, the next decision when it ends.
  void start(std::size_t v, std::int64_t tick, const Move& move);
  void follow(std::size_t v, std::int64_t tick, const Manoeuvre& plan);
  /// Stands from now on (or brakes to it) and decides again after a time, or never.
  void stand(std::size_t v, std::int64_t tick, double again_s = -1.0);
  void decide(std::size_t v, std::int64_t tick);

  // behaviours.cpp
  void keepStraight(std::size_t v, std::int64_t tick);
  void meander(std::size_t v, std::int64_t tick);
  void driveToGoals(std::size_t v, std::int64_t tick);
  enum class Way { free, barred, crowded };
  Way approach(std::size_t v, std::int64_t tick, const Place& place, bool stop);
  /// The wish, or the free heading nearest to it.
  void head(std::size_t v, std::int64_t tick, const Wish& wish, double enough_m, bool left_first);
  void keepClear(std::size_t v, std::int64_t tick);
  void breakOut(std::size_t v, std::int64_t tick, double heading_rad);
  double speedOn(std::size_t v, const Pose& pose, double heading_rad, double length_m) const;

  // spacing.cpp
  Course courseOf(std::size_t v, std::int64_t tick) const;
  bool canMeet(std::size_t v, std::size_t u) const;
  double apart(std::size_t v, std::size_t u) const;
  const std::vector<std::size_t>& neighbours(std::size_t v, std::int64_t tick, const Course& course) const;
  /// Whether a plan keeps clear of where all others stand and of what they are about.
  bool clearOfOthers(std::size_t v, std::int64_t tick, const Manoeuvre& plan) const;
  /// After a change of course that did not look out for others: they decide anew where they would meet it.
  void makeWay(std::size_t v, std::int64_t tick);

  // reactions.cpp
  struct Trail {
    Pose point, leader;       ///< to steer for; where the leader is
    double distance_m = 0.0;  ///< along the trail to him
  };
  Trail trailAhead(std::size_t v, std::int64_t tick);
  void followLeader(std::size_t v, std::int64_t tick);
  void succeedLeader(std::size_t v, std::int64_t tick);
  void obeyPerson(std::size_t v, std::int64_t tick);
  void retire(std::size_t v, std::int64_t tick, const Place& from);
};

}  // namespace npsee::world
