#pragma once

#include "sim/ballistics/aero.h"

#include <npsee/ballistics.h>

#include <cstddef>

namespace npsee::ballistics {

/// State of a shell: position x1 (downrange), x2 (up), x3 (right), velocity u1, u2, u3 over the ground, spin p.
inline constexpr int kStates = 7;

/// Radius of the earth of the ICAO atmosphere, m. Source: U.S. Standard Atmosphere 1976.
inline constexpr double kEarthRadius_m = 6356766.0;

/// What all shots of a run share, as the kernels want it.
struct Setup {
  std::shared_ptr<const CompiledAero> shared_aero;
  const CompiledAero* aero = nullptr;  ///< the same, for the kernels
  FlightModel model = FlightModel::modified_point_mass;
  GravityModel gravity = GravityModel::flat;
  Atmosphere atmosphere;
  Integration integration;
  bool yaw = false;              ///< the model has a yaw of repose for this projectile
  bool spin_damped = false;
  bool closed_form_spin = false;
  bool coriolis = false;
  double altitude_m = 0.0;
  double target_height_m = 0.0;
  const Ground* ground = nullptr;
  // Factors of the equations of docs/physics.md without density and fitting factors.
  double g_mps2 = 0.0;
  double drag = 0.0;    ///< pi d^2 / (8 m)
  double magnus = 0.0;  ///< pi d^3 / (8 m)
  double yaw_k = 0.0;   ///< 8 Ix / (pi d^3)
  double spin_k = 0.0;  ///< pi d^4 / (8 Ix)
  double spin_per_speed = 0.0;  ///< 2 pi / (b d), signed by the hand of the twist
  double valid_elevation_rad = 0.0;
  double omega_up = 0.0, omega_north = 0.0;  ///< earth's rotation in the local frame, rad/s
};

/// One shot's own numbers.
struct ShotConstants {
  double y0[kStates] = {};   ///< state at the muzzle
  double drag = 0.0, lift = 0.0, magnus = 0.0, yaw_drag2 = 0.0;  ///< with fitting factors
  double wind[3] = {};
  double omega2[3] = {};     ///< twice the earth's rotation along (downrange, up, right)
  double error_scale[kStates] = {};  ///< 1 / tolerance of each state
  double sine = 0.0, cosine = 1.0;   ///< of the azimuth
  Vec3 muzzle_m;
};

/// A step as the finder of events needs it.
struct Step {
  double t = 0.0, h = 0.0;
  double y0[kStates], y1[kStates];
  double k[7][kStates];  ///< stages; k[0] and k[6] are the derivatives at the ends
};

/// What is known of a flight while it lasts.
struct Progress {
  Flight flight;
  bool armed = false;         ///< over terrain: was above it or away from the muzzle already
  bool past_apex = false;
  double yaw2_max = 0.0;    ///< square of the greatest yaw
  double mach_max = 0.0;      ///< greatest Mach number met
  double impact_state[kStates] = {};
};

/// Called after each accepted step of a recorded flight; null where nothing is kept.
struct Recorder {
  virtual ~Recorder() = default;
  virtual void step(const Step& step) = 0;
};

/// The code that exists once per instruction set; all sets give equal bits.
struct Kernels {
  /// Dormand-Prince flights of `count` shots, four or eight at a time.
  void (*fly_many)(const Setup&, const ShotConstants*, Progress*, std::size_t count);
  /// One flight, kept by `recorder` where that is not null.
  void (*fly_one)(const Setup&, const ShotConstants&, Progress&, Recorder* recorder);
};
const Kernels& baselineKernels();
/// The best set this CPU has.
const Kernels& bestKernels();

/// One flight with RK4 or the predictor-corrector.
void flyFixed(const Setup& setup, const ShotConstants& shot, Progress& progress, Recorder* recorder);

/// Looks for apex and impact in an accepted step (events.cpp). True when the flight is over.
bool findEvents(const Setup& setup, const ShotConstants& shot, const Step& step, Progress& progress);

/// Coefficients of a step's dense output: y(theta) = c0 + theta (c1 + (1 - theta) (c2 + theta (c3 + (1 - theta) c4))).
void denseOutput(const Step& step, bool hermite, std::array<std::array<double, kStates>, 5>& c);

}  // namespace npsee::ballistics
