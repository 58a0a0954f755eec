#pragma once

#include <npsee/error.h>
#include <npsee/terrain.h>
#include <npsee/units.h>
#include <npsee/vec3.h>
#include <npsee/weapons.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace npsee {

/// A fire mission as it stands in a `*.mission.json` file: a plain value; copying, comparing and storing it is all that undo needs.
/// Places are metres in the thesis's frame (x east, z south); headings and azimuths are clockwise from north (-z), radians here and
/// degrees in files. Everything else is SI.

enum class Side { friendly, hostile, neutral };
/// Classes of targets, those of weapons.dat without `any`, in its order.
enum class TargetClass { heavy_armor, light_armor, wheeled, personnel, aircraft, watercraft };

/// A point on the ground.
struct Place {
  double x_m = 0.0, z_m = 0.0;
  friend bool operator==(const Place&, const Place&) = default;
};

struct VehicleType {
  int index = 0;            ///< as in `(mountedon 8)` and `(mission destroy 51)`
  std::string name;
  Side side = Side::hostile;
  TargetClass target_class = TargetClass::heavy_armor;
  double length_m = 7.0, width_m = 3.0, height_m = 2.4;
  double speed_mps = 12.0;  ///< greatest on level ground
  double turn_radps = 20.0 * (kPi / 180.0);  ///< greatest turn rate
  int weapon = 0;           ///< id in weapons.dat it shoots back with; 0 = unarmed
  std::string model;        ///< name of an OBJ model in assets/models; empty = by class
  friend bool operator==(const VehicleType&, const VehicleType&) = default;
};

enum class Behaviour {
  stationary,  ///< "static" in files
  straight,    ///< keeps heading and speed
  meander,     ///< wanders, turns back at the sea and at the terrain's edge
  goals,       ///< drives to its goals in turn
  follow,      ///< keeps behind another vehicle
  user,        ///< driven by commands; stands still without
};
/// What a vehicle does when it notices fire.
enum class Reaction { none, retire, return_fire, both };

struct VehicleSetup {
  std::string id;
  int type = 0;
  Place at;
  double heading_rad = 0.0;
  double speed_mps = 0.0;   ///< wished; limited by the type's
  Behaviour behaviour = Behaviour::stationary;
  Reaction reaction = Reaction::none;
  std::vector<Place> goals;
  bool repeat_goals = false;
  std::string follows;      ///< id of the vehicle ahead
  double gap_m = 50.0;      ///< to it
  friend bool operator==(const VehicleSetup&, const VehicleSetup&) = default;
};

/// Vehicles at random places: speed and heading are drawn too (thesis).
struct VehicleGroup {
  std::string id;           ///< vehicles are called id-1, id-2, ...
  int type = 0;
  int count = 0;
  Place from, to;           ///< corners of the area
  double speed_min_mps = 2.0, speed_max_mps = 10.0;
  Behaviour behaviour = Behaviour::meander;
  Reaction reaction = Reaction::none;
  friend bool operator==(const VehicleGroup&, const VehicleGroup&) = default;
};

struct GunSetup {
  std::string id;
  Place at;
  friend bool operator==(const GunSetup&, const GunSetup&) = default;
};

struct BatterySetup {
  std::string id;
  int weapon = 110;               ///< id in weapons.dat: radii, muzzle velocity, path type
  std::string projectile;         ///< of the ballistics library ("m107"); empty = by the weapon
  std::vector<std::string> charges;  ///< that may be used, weakest first; empty = the one nearest to the weapon's muzzle velocity
  std::vector<GunSetup> guns;
  double pe_range_m = 0.0, pe_deflection_m = 0.0;  ///< probable errors of the guns: half of the shells fall within, on either side
  double lay_time_s = 5.0, reload_time_s = 10.0;
  int rounds = 100;               ///< per gun
  double muzzle_height_m = 2.0;
  double max_elevation_rad = 75.0 * (kPi / 180.0);  ///< of the tube
  int volley_rounds = 1;          ///< rounds per gun in fire for effect
  std::string preset;             ///< explosion preset of its bursts: a shipped name or a file; empty = by the weapon
  friend bool operator==(const BatterySetup&, const BatterySetup&) = default;
};

/// How well an observer senses. The defaults are perfect; `perfect()` tells.
struct Sensing {
  bool limited_belief = false;    ///< belief falls with range; false: what is seen is known for certain
  double belief_near = 0.95, belief_far = 0.05, near_m = 200.0, far_m = 4000.0;
  double hostile_belief = 0.6;    ///< belief from which a contact counts as hostile
  double location_cep_m = 0.0;    ///< circular error probable of where he believes a target to be, one draw per scenario and target
  double own_cep_m = 0.0;         ///< of where he believes himself to be
  double bearing_error_mil = 0.0; ///< standard deviation of a spotting across the line, mil
  double range_error = 0.0;       ///< of a spotting along the line, fraction of the OT distance
  bool fog = true;                ///< contrast falls with distance by the weather's visibility
  double contrast = 0.3, contrast_threshold = 0.02;
  bool perfect() const;           ///< neither a belief that falls with range nor any error of place, bearing or range
  friend bool operator==(const Sensing&, const Sensing&) = default;
};

enum class FireMethod { automatic, adjust_fire, fire_for_effect, suppress, immediate_suppression, smoke, illuminate };
enum class MissionAction { destroy, neutralize, special };

/// `(mission destroy 51)`: what the observer is there for.
struct MissionOrder {
  MissionAction action = MissionAction::destroy;
  int type = 0;                   ///< vehicle type
  friend bool operator==(const MissionOrder&, const MissionOrder&) = default;
};

struct ObserverSetup {
  std::string id;
  Place at;
  int type = 8;                   ///< vehicle type he is mounted on
  std::string vehicle;            ///< id of the vehicle that carries him; empty = one of `type` is put at `at`
  double eye_height_m = 2.5;
  double max_range_m = 4000.0;
  std::filesystem::path rules;    ///< own rules or facts, loaded beside the shipped rules; relative to the mission file
  bool shipped_rules = true;      ///< false: only `rules`
  Sensing sensing;
  std::vector<MissionOrder> missions;
  FireMethod method = FireMethod::automatic;
  double suppress_s = 60.0;       ///< duration of suppression and illumination
  std::vector<std::string> batteries;  ///< he may call, in order of preference; empty = all
  bool self_preservation = true;  ///< moves away from fire and from close hostiles
  bool human = false;             ///< a person calls the fire; the rules only watch and grade
  friend bool operator==(const ObserverSetup&, const ObserverSetup&) = default;
};

enum class TrajectoryChoice { automatic, low, high };
enum class ElevationSolver { root, table };

struct FdcSetup {
  TrajectoryChoice trajectory = TrajectoryChoice::automatic;
  ElevationSolver solver = ElevationSolver::root;
  double table_step_m = 250.0;       ///< of the solver `table` (thesis)
  bool lead = true;                  ///< aim where a moving target will be
  bool absolute_relay = false;       ///< thesis: lay again on where the target is now instead of correcting from the burst
  bool sampled_visibility = false;   ///< thesis: 100 samples of the ground along the ray
  double misunderstanding = 0.0;     ///< probability that a message is misheard
  double read_back = 0.0;            ///< probability that reading back catches it
  double lay_error = 0.0;            ///< probability that a gun is laid 10 or 100 mils off
  double danger_close_m = 600.0;
  friend bool operator==(const FdcSetup&, const FdcSetup&) = default;
};

struct Weather {
  double visibility_m = 20000.0;     ///< meteorological: contrast 2 %
  bool night = false;
  double night_contrast = 0.3, night_range = 0.35;  ///< factors on contrast and on the observers' range at night
  Vec3 wind_mps;                     ///< of the air, x east, y up, z south
  friend bool operator==(const Weather&, const Weather&) = default;
};

struct WorldSetup {
  double size_x_m = 50000.0, size_z_m = 50000.0;
  double sea_level_m = 0.0;
  TerrainSource terrain;
  Weather weather;
  friend bool operator==(const WorldSetup&, const WorldSetup&) = default;
};

/// One thing that must (or must not) be found in the event log, matched against the events as they are written.
struct ExpectField {
  std::string key;                                ///< as in the log; "event" stands for "ev"
  std::variant<std::string, double, bool> value;  ///< equal to, unless a bound is given
  std::optional<double> min, max;
  friend bool operator==(const ExpectField&, const ExpectField&) = default;
};
struct Expectation {
  std::vector<ExpectField> fields;
  std::string within_of;            ///< id of a vehicle, gun or observer the event's position must be near
  double within_m = 0.0;
  std::optional<double> before_s, after_s;
  bool negated = false;
  int at_least = 1;
  std::optional<int> at_most;
  std::string text;                 ///< the clause as it stands in the file, on one line, for messages
  std::string file;                 ///< that it stands in, for messages
  int line = 0;
  friend bool operator==(const Expectation& a, const Expectation& b) { return a.text == b.text; }
};

struct Scenario {
  std::string name, title, description;
  std::int64_t seed = 1993;
  double duration_s = 400.0;
  WorldSetup world;
  std::filesystem::path weapons;    ///< weapons.dat; empty = the shipped one
  std::filesystem::path facts;      ///< facts file of the thesis: observer, guns and missions where the mission file gives none
  std::vector<VehicleType> types;   ///< added to the shipped ones, replacing those of the same index
  std::vector<VehicleSetup> vehicles;
  std::vector<VehicleGroup> groups;
  std::vector<BatterySetup> batteries;
  std::vector<ObserverSetup> observers;
  FdcSetup fdc;
  std::vector<Expectation> expect;

  std::filesystem::path folder;     ///< the file's folder, against which paths are resolved; not stored
  friend bool operator==(const Scenario&, const Scenario&) = default;
};

inline constexpr double kMissionTick_s = 0.05;
inline constexpr double kMaxMissionDuration_s = 86400.0;
inline constexpr std::size_t kMaxVehicles = 10000, kMaxObservers = 100, kMaxGuns = 1000;

/// Reads and validates a mission file. The error lists every fault with file, line and JSON pointer; unknown keys come with the
/// nearest known one. Files it names (weapons, facts, rules, terrain) must exist but are not read here. Thread-safe.
Expected<Scenario> loadScenario(const std::filesystem::path& path);
Expected<Scenario> parseScenario(std::string_view text, std::string_view name, const std::filesystem::path& folder = {});
/// The file's text in a fixed order, defaults left out; `parseScenario(scenarioText(s), "") == s`.
std::string scenarioText(const Scenario& scenario);
/// Writes atomically. Error kind output.
Expected<void> saveScenario(const Scenario& scenario, const std::filesystem::path& path);
/// Every fault of the value itself: ranges, names given twice or unknown, places outside the world. Empty = valid.
std::vector<Fault> validate(const Scenario& scenario);
/// One `PATH=VALUE` of the command line, e.g. "world.weather.visibility=800", "observers.fo1.sensing.location_cep=200",
/// "vehicles.t72-1.pos=25400,25000". Error kind usage; the scenario is then unchanged.
Expected<void> applySetting(Scenario& scenario, std::string_view expression);

/// The types that are always there (those of the thesis among them), by index.
const std::vector<VehicleType>& shippedVehicleTypes();
/// The shipped types with the scenario's own.
std::vector<VehicleType> vehicleTypes(const Scenario& scenario);

}  // namespace npsee
