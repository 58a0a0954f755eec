#pragma once

#include <npsee/ground.h>
#include <npsee/projectile.h>
#include <npsee/units.h>
#include <npsee/vec3.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace npsee {

/// Frame of a flight, metres and seconds: x downrange along the line of fire, y up, z to its right, origin at the muzzle.

enum class FlightModel {
  vacuum,                    ///< gravity only, thesis eqs. 3.4 to 3.6
  point_mass,                ///< gravity and zero-yaw drag
  simplified_modified_point_mass,  ///< thesis eq. 3.8: no wind, no Coriolis, closed-form spin 3.15
  modified_point_mass,       ///< yaw of repose with yaw drag, lift, Magnus force, integrated spin, wind, Coriolis
};

enum class Integrator {
  dormand_prince,       ///< adaptive order 5(4) with dense output; Dormand and Prince, J. Comput. Appl. Math. 6 (1980) 19
  predictor_corrector,  ///< the thesis's, after Lieske: order 2, fixed step, yaw of repose from the step before
  rk4,                  ///< classical Runge-Kutta, fixed step
};

enum class GravityModel {
  flat,            ///< constant, straight down
  inverse_square,  ///< straight down, g (Re / (Re + h))^2
  curved,          ///< towards the earth's centre; ground and heights follow the sphere
};

/// Names as on the command line ("modified-point-mass", ...), in enum order.
std::span<const std::string_view> flightModelNames();
std::span<const std::string_view> integratorNames();
std::span<const std::string_view> gravityModelNames();

/// ICAO standard atmosphere, or air that is the same at any height.
struct Atmosphere {
  bool icao = true;
  double density_kgm3 = 1.225;           ///< where not icao
  double sound_speed_mps = 340.294;      ///< where not icao
};

/// Density [kg/m^3] and speed of sound [m/s] at a geometric height [m]. Source: ICAO Doc 7488 / U.S. Standard Atmosphere 1976,
/// troposphere and isothermal layer; heights below -5000 m count as -5000 m.
struct AirState {
  double density_kgm3 = 0.0, sound_speed_mps = 0.0;
};
AirState airAt(const Atmosphere& atmosphere, double height_m);  ///< Of the air at a geometric height, m. Any finite height. Thread-safe.

/// What many shots share.
struct Conditions {
  Atmosphere atmosphere;
  GravityModel gravity = GravityModel::flat;
  double gravity_mps2 = 0.0;      ///< at height 0; 0 = standard: 9.80665, and by latitude where the latitude counts
  bool coriolis = false;
  bool has_latitude = false;
  double latitude_rad = 0.0;      ///< north positive
  double muzzle_altitude_m = 0.0; ///< of the muzzle above sea level, for the atmosphere
  double target_height_m = 0.0;   ///< of the impact surface above the muzzle; used where `ground` is null
  std::shared_ptr<const Ground> ground;  ///< world surface to fall on, else flat at target_height_m

  /// g at height 0 that these conditions mean, m/s^2.
  double gravityAtMuzzle() const;
};

/// How the equations are integrated.
struct Integration {
  Integrator integrator = Integrator::dormand_prince;
  double tolerance_m = 3e-4;   ///< Dormand-Prince: bound of one step's estimated error, as a distance at the impact, m. The
                               ///< impact of a howitzer shot is then within 0.05 m of the exact solution.
  double step_s = 0.1;         ///< fixed step of the others, s
  double time_limit_s = 1000;  ///< a flight that has not come down by then ends without impact, s
  int step_limit = 200000;     ///< and so does one that takes more steps
};

/// One shot. `wind_mps` is the velocity of the air along (downrange, up, right).
struct Shot {
  double speed_mps = 0.0;
  double elevation_rad = 0.0;
  double azimuth_rad = 0.0;  ///< clockwise from north; turns the flight into the world and enters the Coriolis force
  Vec3 wind_mps;
  Factors factors;
  Vec3 muzzle_m;             ///< place of the muzzle in the world
  friend bool operator==(const Shot&, const Shot&) = default;
};

/// How a flight ended.
enum class FlightEnd {
  impact,
  no_impact,  ///< never came down on the surface: below it, or longer in the air than the limits allow
  refused,    ///< the shot itself is impossible (see checkShot); all numbers are 0
};

/// Reasons for which a result is flagged as beyond the model's validity, as bits.
enum Doubt : std::uint32_t {
  doubt_none = 0,
  doubt_elevation = 1,  ///< steeper than the projectile's limit for the modified point-mass model
  doubt_yaw = 2,        ///< the yaw of repose reached its clamp of 0.35 rad
  doubt_mach = 4,       ///< faster than the coefficient tables reach
};
inline constexpr double kYawClamp_rad = 0.35;

struct Flight {
  FlightEnd end = FlightEnd::refused;
  double range_m = 0.0;            ///< downrange distance of the impact along the line of fire
  double drift_m = 0.0;            ///< to its right
  double height_m = 0.0;           ///< of the impact over the muzzle
  double time_of_flight_s = 0.0;
  double max_ordinate_m = 0.0;     ///< greatest height over the muzzle
  double apex_time_s = 0.0, apex_range_m = 0.0, apex_drift_m = 0.0;
  double impact_speed_mps = 0.0;
  double angle_of_fall_rad = 0.0;  ///< below the horizontal, positive downwards
  Vec3 impact_velocity_mps;        ///< downrange, up, right
  double spin_muzzle_radps = 0.0, spin_impact_radps = 0.0;
  double yaw_max_rad = 0.0;        ///< greatest yaw of repose met
  std::uint32_t doubts = doubt_none;
  std::int32_t evaluations = 0;    ///< of the equations of motion
  std::int32_t steps = 0;

  bool valid() const { return doubts == doubt_none && end == FlightEnd::impact; }  ///< Came down, and within the model's validity.
  friend bool operator==(const Flight&, const Flight&) = default;
};

/// A flight kept whole: evaluate it at any time.
class FlightPath {
 public:
  struct State {
    Vec3 position_m, velocity_mps;
    double spin_radps = 0.0;
  };
  /// Dense output of one step, y(theta) for theta in [0, 1]: Hairer, Norsett and Wanner, Solving ODEs I, section II.6.
  struct Node {
    double start_s = 0.0, step_s = 0.0;
    std::array<std::array<double, 7>, 5> c;
  };

  const Flight& flight() const { return flight_; }  ///< How the flight went as a whole.
  const Shot& shot() const { return shot_; }  ///< What was fired.
  /// State in the flight frame; times before the shot and after the impact are clamped.
  State at(double time_s) const;
  /// The same in the world (x east, y up, z south).
  State inWorld(double time_s) const;
  std::span<const Node> nodes() const { return nodes_; }

 private:
  friend class Ballistics;
  Flight flight_;
  Shot shot_;
  bool closed_form_spin_ = false;
  std::vector<Node> nodes_;
  std::vector<double> spins_;  ///< at the nodes' starts and the end, where the spin is in closed form
};

/// Compass and line of fire: turns a vector of the flight frame into the world and back.
Vec3 worldFromFlight(const Vec3& in_flight, double azimuth_rad);
Vec3 flightFromWorld(const Vec3& in_world, double azimuth_rad);

/// Flies one projectile under one set of conditions. Immutable and thread-safe; copies are cheap.
class Ballistics {
 public:
  /// Error kind input: faults of the projectile. Error kind usage: conditions or integration that make no sense.
  static Expected<Ballistics> make(const Projectile& projectile, const Conditions& conditions = {}, FlightModel model = FlightModel::modified_point_mass,
                                   const Integration& integration = {});
  ~Ballistics();
  Ballistics(const Ballistics&);
  Ballistics& operator=(const Ballistics&);

  /// The same, but falling on a flat surface at this height over the muzzle (m) instead of the conditions' own.
  Ballistics onto(double target_height_m) const;

  /// Error kind usage: why the shot is refused; every other one flies, whatever its numbers, without NaN and in bounded time.
  Expected<void> checkShot(const Shot& shot) const;

  Flight fly(const Shot& shot) const;  ///< Flies one shot; an impossible one ends as FlightEnd::refused.
  FlightPath path(const Shot& shot) const;  ///< The same, kept whole; `path(s).flight() == fly(s)`.
  /// Flies many shots, four at a time where the CPU can and on `threads` threads (0 = one per core). Each result has the bits
  /// that `fly` gives, for any number of threads. `flights` must be as long as `shots`.
  void flyMany(std::span<const Shot> shots, std::span<Flight> flights, int threads = 0) const;

  const Projectile& projectile() const;  ///< As given to `make`.
  const Conditions& conditions() const;  ///< As given to `make`, or changed by `onto`.
  FlightModel model() const;  ///< As given to `make`.
  const Integration& integration() const;  ///< As given to `make`.

 private:
  struct Data;
  explicit Ballistics(std::shared_ptr<const Data> data);
  std::shared_ptr<const Data> data_;
};

}  // namespace npsee
