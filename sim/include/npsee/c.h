#pragma once

#include <stddef.h>
#include <stdint.h>

/// @file
/// The simulator for C and for every language that can call C: opaque handles, plain structures, error texts. It is the library `libnpsee`
/// (CMake: `npsee::c`; pkg-config: `npsee`), a layer over the C++ interface that gives the same results to the bit.
///
/// Units are SI and radians; x is east, y up, z south; azimuths are clockwise from north (-z).
///
/// Every function that can fail returns a ::npsee_status; npsee_last_error() then has the reason. Null where a pointer is needed is an error
/// and no crash. No C++ exception leaves a function, also none that a callback throws. Texts are UTF-8 and end with a zero.
///
/// A function that fails sets the handle that it should have made to null, and leaves whatever else it should have filled as it was; only lengths of
/// texts are told then too.
///
/// A handle is freed by its own `_free`, which takes null. Handles do not depend on each other: a preset may be freed when it is compiled.
/// Explosions, ballistics, paths and recordings never change and may be used by many threads at once; a handle of another kind by one thread at a time.
///
/// Functions are added with a minor version; a structure or a function changes only together with ::NPSEE_ABI.

#if defined(__GNUC__)
#define NPSEE_API __attribute__((visibility("default")))
#else
#define NPSEE_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// Number of the binary interface this header describes. A program whose header and library differ in it must not go on.
#define NPSEE_ABI 1

/// How a call ended; 2 to 5 are the exit codes of the command line.
typedef enum npsee_status {
  NPSEE_OK = 0,
  NPSEE_NEGATIVE = 1, ///< done, and the answer is no: a target out of reach
  NPSEE_USAGE = 2,    ///< the call is wrong: a null pointer, a buffer too small, a setting that does not exist
  NPSEE_INPUT = 3,    ///< an input is unreadable or invalid
  NPSEE_OUTPUT = 5,   ///< a file could not be written
  NPSEE_MEMORY = 6,   ///< the memory does not suffice
  NPSEE_INTERNAL = 7  ///< a defect of the library, or an exception of a callback
} npsee_status;

/// Version of the library as text, "1.0.0". Static; never null. Thread-safe.
NPSEE_API const char* npsee_version(void);

/// ::NPSEE_ABI of the library. Thread-safe.
NPSEE_API unsigned npsee_abi(void);

/// Why the last call of this thread that failed did so: every fault on a line, with file and line where there is one, the remedy below it.
/// Empty before the first failure; a call that succeeds leaves it. Valid until the next failure in the same thread; never null.
NPSEE_API const char* npsee_last_error(void);

/// @name Presets
/// @{

/// An explosion preset. Changed only by npsee_preset_set().
typedef struct npsee_preset npsee_preset;

/// Reads and checks a preset file (`*.npsee.json`). Errors: input, with every fault.
NPSEE_API npsee_status npsee_preset_load(const char* path, npsee_preset** preset);

/// The same from `length` bytes of text. `name` (may be null) stands for the file in messages, `folder` (may be null: the current one) is where the
/// models that it names lie. Errors: input.
NPSEE_API npsee_status npsee_preset_parse(const char* text, size_t length, const char* name, const char* folder, npsee_preset** preset);

/// Applies "KEY=VALUE" or "LAYER.KEY=VALUE", units allowed, as `--set` does. Errors: usage; the preset is then unchanged.
NPSEE_API npsee_status npsee_preset_set(npsee_preset* preset, const char* setting);

/// The preset as the text of a file. `*length` (may be null) gets its length in bytes without the final zero; `buffer` may be null with a
/// capacity of 0 to ask only for that. Errors: usage, if the text with its zero does not fit into `capacity` bytes; nothing is written then.
NPSEE_API npsee_status npsee_preset_text(const npsee_preset* preset, char* buffer, size_t capacity, size_t* length);

/// Writes the preset's file whole or not at all. Errors: output; a file of that name is then as it was.
NPSEE_API npsee_status npsee_preset_save(const npsee_preset* preset, const char* path);

/// Frees a preset; null is allowed.
NPSEE_API void npsee_preset_free(npsee_preset* preset);

/// @}
/// @name Explosions
/// @{

/// A compiled preset: all random draws made, all ground contacts found. Immutable.
typedef struct npsee_explosion npsee_explosion;

/// Height of the ground at (x, z), metres, called while compiling, from several threads at once if there are several. Heights that are
/// not finite, or further than 1e7 m from 0, count as 0.
typedef double (*npsee_height_function)(void* user, double x_m, double z_m);

/// How to compile; start from npsee_compile_options_default().
typedef struct npsee_compile_options {
  int has_seed;                 ///< 1: `seed` replaces the preset's own
  uint64_t seed;
  int threads;                  ///< at least 1; the results have equal bits for every number
  uint64_t max_particles;       ///< refuse presets that may start more; 0 = the library's own limit of 4,000,000
  uint64_t max_bytes;           ///< refuse presets that may take more memory when compiled, bytes; 0 = the library's own limit
  npsee_height_function ground; ///< null = flat at the preset's ground height
  void* ground_user;            ///< handed to `ground`
  double ground_detail_m;       ///< shortest horizontal extent of a feature of `ground`, metres, above 0
} npsee_compile_options;

/// One thread, the preset's seed, the library's limits, flat ground. Thread-safe.
NPSEE_API npsee_compile_options npsee_compile_options_default(void);

/// Compiles a preset; `options` may be null for the default. Whatever is over a limit is refused before memory is taken.
/// Errors: input (an invalid preset, or one over a limit), usage, memory.
NPSEE_API npsee_status npsee_explosion_compile(const npsee_preset* preset, const npsee_compile_options* options, npsee_explosion** explosion);

/// Particles of all layers, and so the length of every array of a frame; 0 for null. Thread-safe.
NPSEE_API size_t npsee_explosion_particles(const npsee_explosion* explosion);

/// Time after which nothing changes any more, s; 0 for null. Thread-safe.
NPSEE_API double npsee_explosion_duration_s(const npsee_explosion* explosion);

/// Memory it holds, bytes; 0 for null. Thread-safe.
NPSEE_API size_t npsee_explosion_memory_bytes(const npsee_explosion* explosion);

/// Layers that have particles, in the order of the frames; 0 for null. Thread-safe.
NPSEE_API size_t npsee_explosion_layers(const npsee_explosion* explosion);

/// Where a layer's particles are in the frames.
typedef struct npsee_layer {
  const char* name; ///< valid as long as the explosion
  const char* form; ///< "tetrahedron", "smoke", ...; static
  size_t first;     ///< index of its first particle
  size_t count;     ///< its particles
} npsee_layer;

/// Layer `index` from 0. Errors: usage. Thread-safe.
NPSEE_API npsee_status npsee_explosion_layer(const npsee_explosion* explosion, size_t index, npsee_layer* layer);

/// Box that holds what is drawn over the whole effect, all but strays, metres: x, y, z of both corners; to point a camera at. Errors: usage.
/// Thread-safe.
NPSEE_API npsee_status npsee_explosion_extent(const npsee_explosion* explosion, double min_m[3], double max_m[3]);

/// Farthest that anything is drawn from the middle of that box, strays included, metres, estimated from at most 300 particles a layer; 0 for null.
/// Thread-safe.
NPSEE_API double npsee_explosion_reach_m(const npsee_explosion* explosion);

/// The state of all particles at one time in the caller's arrays, one entry per particle in layer order. A null array is not wanted.
typedef struct npsee_frame {
  size_t capacity;                ///< entries that every given array has room for, at least npsee_explosion_particles()
  double *x, *y, *z;              ///< place, m
  double *vx, *vy, *vz;           ///< velocity, m/s
  double *size;                   ///< m; 0 for particles not alive
  double *age;                    ///< s since birth, 0 to the lifetime
  double *r, *g, *b, *a;          ///< sRGB-coded colour and opacity, 0 to 1; a is 0 for particles not alive
  double *qx, *qy, *qz, *qw;      ///< orientation, unit quaternion, body to world
  uint8_t *alive;                 ///< 1 between birth and death, else 0; pieces that stand are there from time 0
  uint8_t *bounces;               ///< ground contacts so far
} npsee_frame;

/// The same in single precision, for drawing: each number is the rounded one of ::npsee_frame.
typedef struct npsee_float_frame {
  size_t capacity;                ///< entries that every given array has room for, at least npsee_explosion_particles()
  float *x, *y, *z;               ///< place, m
  float *vx, *vy, *vz;            ///< velocity, m/s
  float *size;                    ///< m; 0 for particles not alive
  float *age;                     ///< s since birth, 0 to the lifetime
  float *r, *g, *b, *a;           ///< sRGB-coded colour and opacity, 0 to 1; a is 0 for particles not alive
  float *qx, *qy, *qz, *qw;       ///< orientation, unit quaternion, body to world
  uint8_t *alive;                 ///< 1 between birth and death, else 0; pieces that stand are there from time 0
  uint8_t *bounces;               ///< ground contacts so far
} npsee_float_frame;

/// Fills the arrays with the state at `t_s` (s, finite; before 0 there is nothing but pieces that stand), on `threads` threads (at least 1; the bytes do not
/// depend on it). What it costs does not depend on the time. Errors: usage (arrays too short, a time that is not finite), memory.
/// Thread-safe. Each thread keeps room of its own for the next call, see npsee_release_scratch().
NPSEE_API npsee_status npsee_explosion_at(const npsee_explosion* explosion, double t_s, const npsee_frame* frame, int threads);

/// npsee_explosion_at() in single precision. Errors and thread safety as there.
NPSEE_API npsee_status npsee_explosion_at_float(const npsee_explosion* explosion, double t_s, const npsee_float_frame* frame, int threads);

/// Gives back what this thread keeps between calls of npsee_explosion_compile(), npsee_explosion_at() and npsee_explosion_at_float(); it does so by
/// itself when it ends. Thread-safe.
NPSEE_API void npsee_release_scratch(void);

/// Frees an explosion; null is allowed.
NPSEE_API void npsee_explosion_free(npsee_explosion* explosion);

/// @}
/// @name Projectiles, flights, aiming
/// @{

/// A projectile with its charges. Changed only by npsee_projectile_set().
typedef struct npsee_projectile npsee_projectile;

/// A shipped projectile by name ("m107"), or one from a file if `choice` has a dot or a slash. Errors: usage, input.
NPSEE_API npsee_status npsee_projectile_find(const char* choice, npsee_projectile** projectile);

/// A projectile from `length` bytes of a file's text; `name` (may be null) stands for the file in messages. Errors: input.
NPSEE_API npsee_status npsee_projectile_parse(const char* text, size_t length, const char* name, npsee_projectile** projectile);

/// Changes a constant: "mass=43kg", ... (`npsee fly --help` lists them). A fitting factor set so counts for every shot of
/// npsee_projectile_shot() and npsee_ballistics_aim() instead of the charge's. Errors: usage; the projectile is then unchanged.
NPSEE_API npsee_status npsee_projectile_set(npsee_projectile* projectile, const char* setting);

/// How many charges it has; 0 for null.
NPSEE_API size_t npsee_projectile_charges(const npsee_projectile* projectile);

/// Name and muzzle velocity (m/s) of charge `index` from 0; the name is valid as long as the projectile. Either pointer may be null.
/// Errors: usage.
NPSEE_API npsee_status npsee_projectile_charge(const npsee_projectile* projectile, size_t index, const char** name, double* speed_mps);

/// One shot; start from npsee_projectile_shot().
typedef struct npsee_shot {
  double speed_mps;                    ///< muzzle velocity
  double elevation_rad;
  double azimuth_rad;                  ///< clockwise from north
  double wind_mps[3];                  ///< velocity of the air along (downrange, up, right)
  double muzzle_m[3];                  ///< place of the muzzle in the world
  double form, lift, magnus, yaw_drag; ///< fitting factors, 1 = none
} npsee_shot;

/// A shot with the charge's muzzle velocity and its fitting factors at that elevation (rad), northward and without wind; with a null
/// `charge` the speed is 0 and to be set. Errors: usage.
NPSEE_API npsee_status npsee_projectile_shot(const npsee_projectile* projectile, const char* charge, double elevation_rad, npsee_shot* shot);

/// Frees a projectile; null is allowed.
NPSEE_API void npsee_projectile_free(npsee_projectile* projectile);

/// What many shots share; start from npsee_conditions_default(). Models, integrators and gravity by their names on the command line; null
/// means the default.
typedef struct npsee_conditions {
  const char* model;         ///< "modified-point-mass" (default), "point-mass", "vacuum", ...
  const char* integrator;    ///< "dormand-prince" (default), "predictor-corrector", "rk4"
  const char* gravity;       ///< "flat" (default), "inverse-square", "curved"
  double gravity_mps2;       ///< at height 0; 0 = standard
  int icao;                  ///< 1: the standard atmosphere; 0: the next two at any height
  double density_kgm3;       ///< of the air
  double sound_speed_mps;    ///< in it
  int coriolis;              ///< 1: the earth turns
  int has_latitude;          ///< 1: the next counts
  double latitude_rad;       ///< north positive
  double muzzle_altitude_m;  ///< above sea level, for the atmosphere
  double target_height_m;    ///< of the flat surface of impact above the muzzle
  double tolerance_m;        ///< of the adaptive integrator, at the impact
  double step_s;             ///< of the others
  double time_limit_s;       ///< longest flight
  int step_limit;            ///< and its most steps
} npsee_conditions;

/// The modified point-mass model in the standard atmosphere over flat ground at the muzzle's height. Thread-safe.
NPSEE_API npsee_conditions npsee_conditions_default(void);

/// One projectile under one set of conditions. Immutable.
typedef struct npsee_ballistics npsee_ballistics;

/// Makes ready to fly; `conditions` may be null for the default. Errors: input (the projectile), usage (the conditions).
NPSEE_API npsee_status npsee_ballistics_make(const npsee_projectile* projectile, const npsee_conditions* conditions, npsee_ballistics** ballistics);

/// Frees; null is allowed.
NPSEE_API void npsee_ballistics_free(npsee_ballistics* ballistics);

/// How a flight went. Frame: downrange along the line of fire, up, right of it; origin at the muzzle.
typedef struct npsee_flight {
  int impact;                      ///< 1: it came down; 0: it did not within the limits
  double range_m, drift_m, height_m; ///< of the impact
  double time_of_flight_s;
  double max_ordinate_m, apex_time_s, apex_range_m, apex_drift_m;
  double impact_speed_mps;
  double angle_of_fall_rad;        ///< below the horizontal
  double impact_velocity_mps[3];
  double spin_muzzle_radps, spin_impact_radps;
  double yaw_max_rad;              ///< greatest yaw of repose
  uint32_t doubts;                 ///< bits: 1 too steep, 2 yaw at its bound, 4 faster than the tables
  int32_t evaluations, steps;      ///< what it cost
} npsee_flight;

/// Flies a shot. Errors: usage, a shot that is impossible. Thread-safe.
NPSEE_API npsee_status npsee_ballistics_fly(const npsee_ballistics* ballistics, const npsee_shot* shot, npsee_flight* flight);

/// A flight that is kept: its state at any time. Immutable.
typedef struct npsee_path npsee_path;

/// Flies a shot and keeps the path. Errors: usage, a shot that is impossible. Thread-safe.
NPSEE_API npsee_status npsee_ballistics_path(const npsee_ballistics* ballistics, const npsee_shot* shot, npsee_path** path);

/// Place (m), velocity (m/s), each 3 numbers, and spin (rad/s) at a time after the shot (s, clamped to the flight), in the world if `world`
/// is not 0, else in the flight's frame. Each of the last three may be null. Errors: usage. Thread-safe.
NPSEE_API npsee_status npsee_path_at(const npsee_path* path, double t_s, int world, double* position_m, double* velocity_mps, double* spin_radps);

/// Frees a path; null is allowed.
NPSEE_API void npsee_path_free(npsee_path* path);

/// What is to be hit; set everything you do not need to 0.
typedef struct npsee_target {
  double range_m;       ///< horizontal distance
  double height_m;      ///< above the muzzle
  double azimuth_rad;   ///< bearing from the muzzle, clockwise from north
  double wind_mps[3];   ///< velocity of the air along (to the target, up, right of the line to it)
  double muzzle_m[3];   ///< place of the muzzle in the world
  const char* charge;   ///< name; null: `speed_mps` counts
  double speed_mps;     ///< muzzle velocity where there is no charge
  int high;             ///< 0: the lower of the two elevations, 1: the higher
} npsee_target;

/// An elevation that hits.
typedef struct npsee_solution {
  npsee_shot shot;
  npsee_flight flight;
  double azimuth_correction_rad; ///< to the right of the target's bearing
  double miss_m;                 ///< horizontal distance of the impact from the target
} npsee_solution;

/// Finds the elevation and azimuth for a target. Negative: out of reach, the error text names the greatest range, or says that the target is
/// higher than the shell flies. Errors: usage. Thread-safe.
NPSEE_API npsee_status npsee_ballistics_aim(const npsee_ballistics* ballistics, const npsee_target* target, npsee_solution* solution);

/// @}
/// @name Missions
/// @{

/// A fire mission as it stands in its file. Changed only by npsee_scenario_set().
typedef struct npsee_scenario npsee_scenario;

/// Reads and checks a mission file (`*.mission.json`). Errors: input, with every fault.
NPSEE_API npsee_status npsee_scenario_load(const char* path, npsee_scenario** scenario);

/// The same from `length` bytes of text. `name` (may be null) stands for the file in messages, `folder` (may be null: the current one) is where
/// the files that it names lie. Errors: input.
NPSEE_API npsee_status npsee_scenario_parse(const char* text, size_t length, const char* name, const char* folder, npsee_scenario** scenario);

/// Applies "PATH=VALUE", e.g. "world.weather.visibility=800". Errors: usage; the scenario is then unchanged.
NPSEE_API npsee_status npsee_scenario_set(npsee_scenario* scenario, const char* setting);

/// Frees a scenario; null is allowed.
NPSEE_API void npsee_scenario_free(npsee_scenario* scenario);

/// A mission being simulated, with the recording of all that happened.
typedef struct npsee_mission npsee_mission;

/// Sets a mission up; nothing is simulated yet. Errors: input, in the mission or in a file that it names; memory.
NPSEE_API npsee_status npsee_mission_start(const npsee_scenario* scenario, npsee_mission** mission);

/// Called with each event of the log: its time (s), its kind ("fire", "detonation", ...) and the whole of it as one line of JSON without
/// the line end. The texts are valid during the call. It may call npsee_mission_order(), but not advance or free the mission.
typedef void (*npsee_event_function)(void* user, double t_s, const char* kind, const char* json);

/// Simulates up to a time (s; more than the mission's duration means its end) and hands every new event, in order, to `on_event` (may be
/// null). The log is the same however it is cut into calls. Errors: usage.
NPSEE_API npsee_status npsee_mission_advance(npsee_mission* mission, double until_s, npsee_event_function on_event, void* user);

/// What a person does in a mission.
typedef enum npsee_order_kind {
  NPSEE_DRIVE = 0,           ///< vehicle `who`: wished speed and turn rate
  NPSEE_TAKE = 1,            ///< a person takes over the observer or vehicle `who`
  NPSEE_RELEASE = 2,         ///< and hands it back
  NPSEE_CALL_FOR_FIRE = 3,   ///< observer `who` calls fire on `target`, a vehicle that he sees or has seen, or on the place where that is null
  NPSEE_CORRECT = 4,         ///< observer `who` corrects his `mission` by right and add
  NPSEE_FIRE_FOR_EFFECT = 5, ///< observer `who`, for his `mission`
  NPSEE_END_MISSION = 6,     ///< observer `who` ends his `mission`
  NPSEE_SHOOT = 7            ///< direct fire of vehicle `who` at the place
} npsee_order_kind;

/// One order; set everything you do not need to 0.
typedef struct npsee_order {
  double t_s;                ///< when; a time already simulated counts as now
  int kind;                  ///< an npsee_order_kind; a plain number, since others than these are refused
  const char* who;           ///< id of an observer or vehicle
  double speed_mps, turn_radps;
  double x_m, z_m;           ///< the place
  const char* target;        ///< id of a vehicle, or null
  int mission;               ///< number of the fire mission, as in the log
  double right_m, add_m;     ///< as seen by the observer
} npsee_order;

/// Gives an order. Errors: usage. An order that cannot be obeyed when its time comes (nobody of that name, a vehicle that is destroyed, a mission that
/// is not open or another observer's, a target that he has never seen) changes nothing and is told by a "warning" of the log.
NPSEE_API npsee_status npsee_mission_order(npsee_mission* mission, const npsee_order* order);

/// Time simulated so far, s; 0 for null.
NPSEE_API double npsee_mission_time_s(const npsee_mission* mission);

/// 1 when the mission is at its end, else 0.
NPSEE_API int npsee_mission_finished(const npsee_mission* mission);

/// Events so far; 0 for null.
NPSEE_API size_t npsee_mission_events(const npsee_mission* mission);

/// Event `index` from 0 as one line of JSON without the line end; buffer, capacity and length as in npsee_preset_text(). Errors: usage.
NPSEE_API npsee_status npsee_mission_event(const npsee_mission* mission, size_t index, char* buffer, size_t capacity, size_t* length);

/// Vehicles of the mission; 0 for null.
NPSEE_API size_t npsee_mission_vehicles(const npsee_mission* mission);

/// Where a vehicle is at a moment, and how.
typedef struct npsee_vehicle {
  const char* id;          ///< valid as long as the mission or recording
  const char* type;        ///< name of its type; likewise
  double position_m[3];    ///< on the ground
  double heading_rad;      ///< clockwise from north
  double speed_mps;
  int destroyed;           ///< 1 or 0
} npsee_vehicle;

/// Vehicle `index` from 0 at a time (s, at most what is simulated). Errors: usage.
NPSEE_API npsee_status npsee_mission_vehicle(const npsee_mission* mission, size_t index, double t_s, npsee_vehicle* vehicle);

/// Shells fired so far; 0 for null.
NPSEE_API size_t npsee_mission_shells(const npsee_mission* mission);

/// A shell's flight and where it is at a moment.
typedef struct npsee_shell {
  int number;              ///< as in the log
  double fired_s, burst_s; ///< times of the mission
  double burst_m[3];       ///< where it bursts
  double position_m[3];    ///< at the moment asked for; before and after its flight where that begins and ends
  double velocity_mps[3];
  int in_air;              ///< 1 between firing and burst, else 0
} npsee_shell;

/// Shell `index` from 0, in the order of firing, at a time (s). Errors: usage.
NPSEE_API npsee_status npsee_mission_shell(const npsee_mission* mission, size_t index, double t_s, npsee_shell* shell);

/// The clauses of the mission's `expect` that are not met, a sentence on each line; empty if all are. Buffer, capacity and length as in
/// npsee_preset_text(). Errors: usage.
NPSEE_API npsee_status npsee_mission_unmet(const npsee_mission* mission, char* buffer, size_t capacity, size_t* length);

/// Writes the recording of a finished mission, for `npsee replay`, whole or not at all. Errors: usage (not finished), output.
NPSEE_API npsee_status npsee_mission_save(const npsee_mission* mission, const char* path);

/// Frees a mission; null is allowed.
NPSEE_API void npsee_mission_free(npsee_mission* mission);

/// @}
/// @name Recordings
/// @{

/// A mission as it was recorded: any moment can be looked up, in any order, without simulating. Immutable.
typedef struct npsee_recording npsee_recording;

/// Reads and checks what npsee_mission_save() or `npsee mission --record` wrote. Shells are flown again, to the same bits. Errors: input, with
/// the line.
NPSEE_API npsee_status npsee_recording_open(const char* path, npsee_recording** recording);

/// How long the mission lasted, s; 0 for null. Thread-safe.
NPSEE_API double npsee_recording_duration_s(const npsee_recording* recording);

/// Hash of the event log, as the log's last line tells it: 64-bit FNV-1a of all lines before that one, each with its line end (one byte 10), as 16
/// hexadecimal digits. It tells whether two runs were the same; it is no guard against forgery. Empty if the mission did not come to its end, or for
/// null. Valid as long as the recording. Thread-safe.
NPSEE_API const char* npsee_recording_hash(const npsee_recording* recording);

/// Events in the log; 0 for null. Thread-safe.
NPSEE_API size_t npsee_recording_events(const npsee_recording* recording);

/// Event `index` from 0 as one line of JSON without the line end; buffer, capacity and length as in npsee_preset_text(). Errors: usage.
/// Thread-safe.
NPSEE_API npsee_status npsee_recording_event(const npsee_recording* recording, size_t index, char* buffer, size_t capacity, size_t* length);

/// Time (s) and kind ("fire", "detonation", ...; static) of event `index` from 0; either pointer may be null. Errors: usage. Thread-safe.
NPSEE_API npsee_status npsee_recording_event_kind(const npsee_recording* recording, size_t index, double* t_s, const char** kind);

/// Index of the first event at a time or after it (s); the number of events if there is none. Errors: usage (a time that is NaN). Thread-safe.
NPSEE_API npsee_status npsee_recording_seek(const npsee_recording* recording, double t_s, size_t* index);

/// Vehicles of the mission; 0 for null. Thread-safe.
NPSEE_API size_t npsee_recording_vehicles(const npsee_recording* recording);

/// Vehicle `index` from 0 at a time (s, clamped to the mission); its texts are valid as long as the recording. Errors: usage. Thread-safe.
NPSEE_API npsee_status npsee_recording_vehicle(const npsee_recording* recording, size_t index, double t_s, npsee_vehicle* vehicle);

/// Shells fired; 0 for null. Thread-safe.
NPSEE_API size_t npsee_recording_shells(const npsee_recording* recording);

/// Shell `index` from 0, in the order of firing, at a time (s). Errors: usage. Thread-safe.
NPSEE_API npsee_status npsee_recording_shell(const npsee_recording* recording, size_t index, double t_s, npsee_shell* shell);

/// What shell `index` is drawn with when it bursts: the preset as the mission names it, valid as long as the recording and empty if it names none
/// (the program then draws its own `howitzer_155`, or `impact_small` for direct fire), and the seed for npsee_compile_options. Either pointer may
/// be null. Errors: usage. Thread-safe.
NPSEE_API npsee_status npsee_recording_burst(const npsee_recording* recording, size_t index, const char** preset, uint64_t* seed);

/// Height of the ground at a place, metres; beyond the border as at it. Errors: usage. Thread-safe.
NPSEE_API npsee_status npsee_recording_height(const npsee_recording* recording, double x_m, double z_m, double* height_m);

/// The clauses of the mission's `expect` that are not met; as npsee_mission_unmet(). Errors: usage. Thread-safe.
NPSEE_API npsee_status npsee_recording_unmet(const npsee_recording* recording, char* buffer, size_t capacity, size_t* length);

/// Frees a recording; null is allowed.
NPSEE_API void npsee_recording_free(npsee_recording* recording);

/// @}

#ifdef __cplusplus
}
#endif
