#pragma once

#include <npsee/mission.h>

#include "sim/observer/fire_direction.h"
#include "sim/observer/mind.h"
#include "sim/observer/sensing.h"
#include "sim/world/vehicles.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace npsee::observer {

/// The parts of a running mission. One tick: commands, vehicles, shells and impacts with their damage, sensing and belief, rules, fire
/// direction, guns. Each part is a file: engine_*.cpp.

/// Ticks between two looks of one observer at one vehicle; looks are spread over the ticks so that each costs the same.
inline constexpr std::int64_t kLookTicks = 10;
/// Looks without sight after which a contact counts as lost.
inline constexpr int kLooksUntilLost = 3;
/// Seconds between two pieces of evidence that count as independent.
inline constexpr double kEvidence_s = 10.0;
/// Greatest distance at which the nearest friendly of a contact is looked for; beyond it the facts say "far".
inline constexpr double kFriendlySearch_m = 2000.0;
inline constexpr double kMilsPerRadian = 6400.0 / kTwoPi;

/// What one observer knows of one vehicle.
struct Acquaintance {
  bool known = false, seen = false;
  int misses = 0;
  Evidence evidence;
  double conflict = 0.0, evidence_s = -1e9, recorded_s = -1e9;
  std::uint32_t looks = 0;
  Vec3 error_m;                    ///< of the believed place, one draw per observer and target
  Vec3 believed_m;
  Contact fact;
};

struct Post {
  std::optional<Mind> mind;
  const ObserverSetup* setup = nullptr;
  int vehicle = -1;                ///< that carries him
  std::vector<int> batteries;      ///< he may call, in order of preference
  std::vector<Acquaintance> knows; ///< per vehicle
  Vec3 own_error_m;
  Vec3 eye_m;
  Place incoming_from;
  bool human = false, dirty = true, alive = true;
};

struct Piece {
  Gun gun;
  int index = 0;                   ///< in the recording
};

struct Battery {
  const BatterySetup* setup = nullptr;
  const Weapon* weapon = nullptr;
  std::optional<FireDirection> fdc;
  std::vector<Piece> pieces;
  int mission = 0;                 ///< it is busy with, 0 = none
  std::uint32_t shots = 0, lays = 0;
};

/// One gun's part in a mission.
struct Task {
  int piece = 0;
  FireSolution solution;
  double lay_error_rad = 0.0;
  double fire_s = 0.0;
  int rounds = 1;                  ///< still to be fired
};

struct FireMission {
  int number = 0;
  int post = -1, target = -1, battery = -1;
  FireMethod method = FireMethod::adjust_fire;
  Vec3 aim_m;                      ///< where the next rounds shall land: the target as believed, with the corrections
  Vec3 target_m;                   ///< where he believes the target
  Vec3 correction_m;               ///< sum of the corrections, in the world
  Vec3 ot{0.0, 0.0, -1.0};         ///< unit vector from observer to target, level; north while he stands on it
  double ot_distance_m = 1.0;
  MissionFact::State state = MissionFact::State::accepted;
  bool effect = false, over = false, waiting = true, danger_close = false, burning = false;
  int adjusting = 0, effects = 0, fired = 0, in_air = 0, messages = 0;
  double opened_s = 0.0, until_s = 0.0;
  Vec3 bursts_m;                   ///< sum of the places of the rounds of this volley that are down
  int bursts = 0;                  ///< their number
  std::vector<int> refused_guns;   ///< told once each
  std::vector<int> tried_guns;     ///< that have told which trajectory would not do
  double friendly_m = 1e9;
  std::vector<Task> tasks;
  std::optional<std::pair<double, double>> suggested;  ///< what the rules would correct while a person does it
};

struct Flying {
  int shell = 0;                   ///< index in the recording
  double apex_s = 0.0;
  bool apex_told = false;
  int mission = 0;
};

/// Light of an illuminating shell, or smoke, on the ground for a while.
struct Cloud {
  Vec3 place_m;
  double radius_m = 0.0, until_s = 0.0;
};
inline constexpr double kLightRadius_m = 1000.0, kLight_s = 60.0, kLightHeight_m = 600.0;
inline constexpr double kSmokeRadius_m = 40.0, kSmokeHeight_m = 25.0, kSmoke_s = 60.0;

/// A vehicle that shoots back along a straight line.
struct Duel {
  int vehicle = -1, enemy = -1;
  std::int64_t next_tick = 0;
  int rounds = 0;
};

}  // namespace npsee::observer

namespace npsee {

struct Mission::State {
  Recording rec;
  MissionLimits limits;
  Weapons weapons;
  std::vector<VehicleType> types;
  std::optional<world::Vehicles> vehicles;
  std::vector<observer::Post> posts;
  std::vector<observer::Battery> batteries;
  std::vector<observer::FireMission> missions;  ///< number n at n - 1
  std::vector<observer::Flying> flying;
  std::vector<observer::Duel> duels;
  std::vector<int> friendlies;                  ///< indexes of friendly vehicles
  std::vector<std::uint32_t> hits;              ///< per vehicle: bursts that touched it, for its draws
  std::vector<observer::Cloud> lights, smokes;
  std::vector<MissionCommand> commands;         ///< by time
  std::vector<observer::Decision> decisions;    ///< reused
  std::size_t next_command = 0;
  std::int64_t tick = 0;                        ///< next to simulate
  double now_s = 0.0;
  bool failed = false;

  Expected<void> setUp(const Scenario& scenario);
  void step();
  void keepLimits();
  void finish();

  // engine_setup.cpp
  Expected<void> setUpBatteries();
  Expected<void> setUpPosts();

  // engine_commands.cpp
  void obeyCommands();
  void obey(const MissionCommand& command);
  /// An order that cannot be obeyed is told by the log.
  void refuseOrder(const std::string& text);
  void handOver(const MissionCommand& command);
  void humanCall(const MissionCommand& command);
  void humanWord(const MissionCommand& command);
  int seenNear(const observer::Post& post, const Vec3& place) const;

  // engine_sense.cpp
  void sense();
  void look(int post, int vehicle);
  void gained(int post, int vehicle, double range_m);
  void missed(int post, int vehicle);
  void weigh(observer::Post& post, int vehicle, double range_m);
  void tell(int post, int vehicle, double range_m);
  bool sees(const observer::Post& post, const Vec3& point, double max_range_m) const;
  bool litAt(const Vec3& point) const;
  bool smokeBetween(const Vec3& from, const Vec3& to) const;
  double nearestFriendly(const Vec3& place, int except, int* who = nullptr) const;
  observer::Contact::Condition condition(int vehicle) const;

  // engine_decide.cpp
  void think();
  void decide(int post, const observer::Decision& decision);
  void call(int post, const observer::Decision& decision);
  /// Opens a mission of which post, target, method, place and aim are set; says so in the log and to the observer's mind.
  void open(observer::FireMission mission, const observer::Decision& why);
  void correct(int post, const observer::Decision& decision);
  /// How far off the target the aim is, without the lead, m.
  double aimError(const observer::FireMission& mission) const;
  void endMission(observer::FireMission& mission, const std::string& result, const std::string& reason, const observer::Decision* why);
  void tellMission(const observer::FireMission& mission, observer::MissionFact::State state, const std::string& reason = {});

  // engine_fire.cpp
  void direct();
  void prepare(observer::FireMission& mission);
  bool assign(observer::FireMission& mission);
  void follow(observer::FireMission& mission);
  void lookAlong(observer::FireMission& mission) const;
  int solveAll(observer::FireMission& mission, observer::Battery& battery);
  bool solveFor(observer::FireMission& mission, observer::Battery& battery, int piece);
  void layGun(observer::FireMission& mission, observer::Battery& battery, int piece, const observer::FireSolution& solution);
  void logSolution(const observer::FireMission& mission, const observer::Battery& battery, int piece, const observer::FireSolution& solution);
  void logRefusal(const observer::FireMission& mission, const observer::Battery& battery, int piece, bool high, observer::Refusal refusal, double elevation_rad, const std::string& reason);
  void fireGuns();
  void fire(observer::FireMission& mission, observer::Battery& battery, observer::Task& task);
  void release(observer::FireMission& mission);
  void launch(observer::FireMission& mission, observer::Battery& battery, const observer::Task& task, ShellRecord shell);

  // engine_lines.cpp
  observer::FireSolution solveLine(const observer::Battery& battery, const observer::FireRequest& request) const;
  ShellRecord flyLine(const observer::Battery& battery, const observer::FireSolution& solution, double along, double across) const;

  // engine_shells.cpp
  void flyShells(double from_s, double to_s);
  void burst(const observer::Flying& flying);
  void applyBurst(const ShellRecord& shell, const Weapon& weapon);
  void spot(observer::FireMission& mission, const ShellRecord& shell);
  void landed(observer::FireMission& mission, const ShellRecord& shell);
  void damage(int vehicle, const ShellRecord& shell, const Weapon& weapon, double miss_m);
  void noticed(int vehicle, const ShellRecord& shell);
  void shootBack();
  void shootDirect(int vehicle, const Vec3& at, int enemy);
  int enemyInSight(int vehicle, double range_m) const;

  // engine_log.cpp
  MissionEvent& log(EventKind kind, double t_s);
  const std::string& vehicleId(int vehicle) const;
  void fail(const std::string& text);
  Vec3 vehicleAt(int vehicle) const;
  const Weapon* weaponOf(int id) const;  ///< null if the weapons file has none of that number
  observer::FireMission& missionOf(int number) { return missions[static_cast<std::size_t>(number - 1)]; }
};

namespace observer {

/// Bearing clockwise from north, 0..2 pi, of `to` seen from `from`; 0 for the same place. Equal bits on every CPU.
double bearing(const Vec3& from, const Vec3& to);
double levelDistance(const Vec3& a, const Vec3& b);
/// Whether a side fights another.
constexpr bool enemies(Side a, Side b) {
  return (a == Side::friendly && b == Side::hostile) || (a == Side::hostile && b == Side::friendly);
}
std::string_view methodName(FireMethod method);

}  // namespace observer
}  // namespace npsee
