#pragma once

#include <npsee/ballistics.h>
#include <npsee/scenario.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace npsee {

/// What happened in a mission, kept so that any moment can be looked up without simulating again: motion as legs in closed form,
/// shells as flights with dense output, and the event log. Everything the viewport, the exports and the log show comes from here.

enum class EventKind {
  contact, lost, call, solution, refuse, fire, apex, detonation, spot, correction, damage, destroyed, danger_close, warning,
  end_of_mission, error, end,
};
inline constexpr int kEventKinds = 17;
/// "contact", ..., in enum order: the values of `ev` in the log.
std::span<const std::string_view> eventKindNames();

/// One line of the event log: `t`, `ev` and named values in the order they are written.
struct MissionEvent {
  using Value = std::variant<bool, std::int64_t, double, std::string, Vec3, std::vector<std::string>>;
  double t_s = 0.0;
  EventKind kind = EventKind::warning;
  std::vector<std::pair<std::string, Value>> fields;

  /// Null if the event has no such field.
  const Value* find(std::string_view key) const;
  std::string text(std::string_view key) const;       ///< empty if absent or no text
  double number(std::string_view key, double otherwise = 0.0) const;
  const Vec3* place(std::string_view key = "position") const;
  friend bool operator==(const MissionEvent&, const MissionEvent&) = default;
};
/// The event as one line of JSON without the line end: `t`, `ev`, then its values in the order of the schema. Numbers are rounded to
/// four decimals, in shortest form; positions are [x,y,z]; optional keys without a word to say are left out.
std::string eventJson(const MissionEvent& event);

/// One key that an event can have; the table of all is the schema of the log.
struct EventKey {
  std::string_view event, key, type, unit, doc;
  bool optional() const;  ///< left out of the line where there is nothing to say
};
std::span<const EventKey> eventSchema();  ///< All of them by event, in the order they are written. Static; thread-safe.

/// Constant acceleration along a straight line or, with a turn rate, constant speed around a circle.
struct Leg {
  double start_s = 0.0;
  double x_m = 0.0, z_m = 0.0, heading_rad = 0.0;
  double speed_mps = 0.0, acceleration_mps2 = 0.0, turn_radps = 0.0;
  friend bool operator==(const Leg&, const Leg&) = default;
};
struct Pose {
  double x_m = 0.0, z_m = 0.0, heading_rad = 0.0, speed_mps = 0.0;
};
/// Pose on a leg; times before its start count as its start. A decelerating leg stops at speed 0 and does not reverse.
Pose poseOn(const Leg& leg, double time_s);

struct Track {
  std::vector<Leg> legs;            ///< at least one, by start
  std::vector<std::uint32_t> index; ///< leg at every whole index_step_s: seek in constant time
  double index_step_s = 4.0;        ///< doubled where it would give many more entries than legs
  Pose at(double time_s) const;  ///< Pose at a time, s, clamped to the first and last leg; constant time.
  void add(const Leg& leg);         ///< replaces a leg of the same start
  friend bool operator==(const Track&, const Track&) = default;
};

struct DamageStep {
  double t_s = 0.0;
  double hull = 0.0;                ///< accumulated, 1 = destroyed
  bool mobility = true, firepower = true;
  friend bool operator==(const DamageStep&, const DamageStep&) = default;
};
struct VehicleRecord {
  std::string id;
  VehicleType type;
  Track track;
  std::vector<DamageStep> damage;   ///< by time; empty = unharmed
  const DamageStep* damageAt(double time_s) const;  ///< The last step up to a time, s; null while unharmed.
  bool destroyedAt(double time_s) const;  ///< Whether the hull is at 1 or above at a time, s.
};

/// The tube moves from one line to the next evenly between two times.
struct LayStep {
  double from_s = 0.0, to_s = 0.0;
  double azimuth_rad = 0.0, elevation_rad = 0.0;  ///< at the end
};
struct GunRecord {
  std::string id;
  int battery = 0;                  ///< index in the scenario
  Vec3 muzzle_m;
  std::vector<LayStep> lays;        ///< by time; the first is how it stands at the start
  /// Azimuth and elevation, rad.
  std::pair<double, double> lineAt(double time_s) const;
};

struct ShellRecord {
  int number = 0;                   ///< as in the log, from 1
  int gun = -1;                     ///< index of the gun, or -1 for direct fire of a vehicle
  int shooter = -1;                 ///< index of that vehicle
  int weapon = 0;                   ///< id in weapons.dat
  int mission = 0, target = -1;     ///< index of the vehicle aimed at, or -1
  double fired_s = 0.0, burst_s = 0.0;
  Vec3 burst_m;
  FlightPath path;                  ///< in flight time; empty (no nodes) for a straight line
  Vec3 muzzle_m;
  std::string preset;               ///< explosion preset of the burst, as named in the scenario
  std::uint64_t seed = 0;           ///< of that explosion
  bool illumination = false, smoke = false;
  /// Place and velocity while in the air.
  Vec3 at(double time_s) const;
  Vec3 velocityAt(double time_s) const;
};

/// What an observer believed of one contact from a moment on.
struct BeliefStep {
  double t_s = 0.0;
  int target = -1;                  ///< index of the vehicle
  bool seen = false;
  Vec3 believed_m;                  ///< where he believes it to be
  double hostile = 0.0, friendly = 0.0;
  int mission = 0;                  ///< fire mission against it, 0 = none
};
struct ObserverRecord {
  std::string id;
  int vehicle = -1;                 ///< that carries him
  double eye_height_m = 2.5;
  std::vector<BeliefStep> beliefs;  ///< by time
};

struct Recording {
  Scenario scenario;
  Terrain terrain;
  std::vector<VehicleRecord> vehicles;
  std::vector<GunRecord> guns;
  std::vector<ShellRecord> shells;  ///< by time of firing
  std::vector<ObserverRecord> observers;
  std::vector<MissionEvent> events;
  double duration_s = 0.0;          ///< simulated so far
  bool finished = false;
  std::string hash;                 ///< 64-bit FNV-1a of the log's lines before `end`, each with its line end, as 16 hexadecimal digits; empty until finished

  /// Standing on the ground (or the sea).
  Vec3 vehiclePlace(std::size_t vehicle, double time_s) const;
  Vec3 observerEye(std::size_t observer, double time_s) const;
  int findVehicle(std::string_view id) const;
  int findGun(std::string_view id) const;
  int findObserver(std::string_view id) const;
  /// Shells in the air at a time, as indexes, into `out`.
  void shellsInAir(double time_s, std::vector<int>& out) const;
  /// Shells that burst within the `lasting_s` before a time.
  void burstsSince(double time_s, double lasting_s, std::vector<int>& out) const;
};

/// The log as text, one JSON object per line, in order.
std::string eventLog(const Recording& recording);

/// Recording as a file: the scenario, legs, shots and events as JSON lines; shells are flown again when it is read, to the same
/// bits. Written atomically. Errors: output; input with line.
Expected<void> saveRecording(const Recording& recording, const std::filesystem::path& path);
Expected<Recording> loadRecording(const std::filesystem::path& path);

}  // namespace npsee
