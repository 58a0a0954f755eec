#include "sim/ballistics/setup.h"

#include "sim/ballistics/angles.h"
#include "sim/core/elementary.h"

#include <cmath>

namespace npsee::ballistics {
namespace {

/// Rate of the earth's rotation, rad/s. Source: docs/physics.md, "Coriolis".
constexpr double kEarthRate_radps = 7.292115e-5;

double cube(double x) { return x * x * x; }

/// How much an error of a velocity or a spin in one step weighs at the impact, against one of position: seconds of flight
/// still to come, and metres of drift made by the spin. Both are round numbers of a medium howitzer shot.
constexpr double kVelocityLever_s = 20.0, kSpinLever_m = 400.0;

}  // namespace

Setup setupOf(const Projectile& projectile, const Conditions& conditions, FlightModel model, const Integration& integration) {
  Setup s;
  s.shared_aero = std::make_shared<const CompiledAero>(compileAero(projectile.aero));
  s.aero = s.shared_aero.get();
  s.model = model;
  s.gravity = conditions.gravity;
  s.atmosphere = conditions.atmosphere;
  s.integration = integration;
  s.altitude_m = conditions.muzzle_altitude_m;
  s.target_height_m = conditions.target_height_m;
  s.ground = conditions.ground.get();
  s.g_mps2 = conditions.gravityAtMuzzle();
  const bool thesis = model == FlightModel::simplified_modified_point_mass;
  const double d = projectile.diameter_m, m = projectile.mass_kg, inertia = projectile.inertia_kgm2;
  s.drag = kPi * d * d / (8.0 * m);
  s.magnus = kPi * cube(d) / (8.0 * m);
  s.yaw_k = 8.0 * inertia / (kPi * cube(d));
  s.spin_damped = inertia > 0.0 && !projectile.curve(Coefficient::cspin).empty() && model != FlightModel::vacuum;
  s.spin_k = s.spin_damped ? kPi * d * cube(d) / (8.0 * inertia) : 0.0;
  s.spin_per_speed = projectile.twist_cal > 0.0 ? kTwoPi / (projectile.twist_cal * d) * (projectile.left_hand ? -1.0 : 1.0) : 0.0;
  s.yaw = (model == FlightModel::modified_point_mass || thesis) && s.aero->has_yaw && inertia > 0.0 && s.spin_per_speed != 0.0;
  s.closed_form_spin = thesis && s.spin_damped;
  s.valid_elevation_rad = projectile.valid_elevation_rad;
  // The simplified model leaves Coriolis out by definition, and wind in constantsOf.
  s.coriolis = conditions.coriolis && !thesis;
  double sine = 0.0, cosine = 1.0;
  sineCosine(conditions.latitude_rad, sine, cosine);
  s.omega_north = kEarthRate_radps * cosine;
  s.omega_up = kEarthRate_radps * sine;
  return s;
}

ShotConstants constantsOf(const Setup& s, const Shot& shot) {
  ShotConstants q;
  double sine_e = 0.0, cosine_e = 1.0;
  sineCosine(shot.elevation_rad, sine_e, cosine_e);
  // A quarter turn is not exact in a double; a vertical shot should go straight up.
  if (std::fabs(cosine_e) < 1e-15) cosine_e = 0.0;
  sineCosine(shot.azimuth_rad, q.sine, q.cosine);
  q.muzzle_m = shot.muzzle_m;
  const double spin = s.spin_per_speed * shot.speed_mps;
  q.y0[3] = shot.speed_mps * cosine_e;
  q.y0[4] = shot.speed_mps * sine_e;
  q.y0[6] = spin;
  q.drag = s.drag * shot.factors.form;
  q.lift = s.drag * shot.factors.lift;
  q.magnus = s.magnus * shot.factors.magnus;
  q.yaw_drag2 = shot.factors.yaw_drag * shot.factors.yaw_drag;
  if (s.model != FlightModel::simplified_modified_point_mass) {
    q.wind[0] = shot.wind_mps.x;
    q.wind[1] = shot.wind_mps.y;
    q.wind[2] = shot.wind_mps.z;
  }
  q.omega2[0] = 2.0 * s.omega_north * q.cosine;
  q.omega2[1] = 2.0 * s.omega_up;
  q.omega2[2] = -2.0 * s.omega_north * q.sine;
  const double position = 1.0 / s.integration.tolerance_m;
  for (int i = 0; i < 3; ++i) {
    q.error_scale[i] = position;
    q.error_scale[3 + i] = position * kVelocityLever_s;
  }
  q.error_scale[6] = spin != 0.0 ? position * kSpinLever_m / std::fabs(spin) : 0.0;
  return q;
}

double closedFormSpin(const Setup& s, const double* y, double time_s) {
  const double speed = std::sqrt(y[3] * y[3] + y[4] * y[4] + y[5] * y[5]);
  const AirState air = airAt(s.atmosphere, y[1] + s.altitude_m);
  const double mach = speed / air.sound_speed_mps;
  std::size_t i = 0;
  while (mach >= s.aero->knots[i + 1]) ++i;
  const double* c = s.aero->rows.data() + (i * kCoefficients + static_cast<std::size_t>(Coefficient::cspin)) * 4;
  const double x = mach - s.aero->knots[i], cspin = c[0] + x * (c[1] + x * (c[2] + x * c[3]));
  return y[6] * exponential(std::fmin(s.spin_k * air.density_kgm3 * speed * cspin * time_s, 0.0));
}

Flight flightOf(const Setup& s, const Shot& shot, const Progress& progress) {
  Flight flight = progress.flight;
  flight.spin_muzzle_radps = s.spin_per_speed * shot.speed_mps;
  flight.yaw_max_rad = std::sqrt(progress.yaw2_max);
  if (s.yaw && s.valid_elevation_rad > 0.0 && std::fabs(shot.elevation_rad) > s.valid_elevation_rad) flight.doubts |= doubt_elevation;
  if (s.yaw && progress.yaw2_max >= kYawClamp_rad * kYawClamp_rad) flight.doubts |= doubt_yaw;
  if (progress.mach_max > s.aero->mach_top) flight.doubts |= doubt_mach;
  if (flight.end != FlightEnd::impact) {
    flight.end = FlightEnd::no_impact;
    return flight;
  }
  const double* y = progress.impact_state;
  flight.range_m = y[0];
  flight.drift_m = y[2];
  flight.impact_velocity_mps = {y[3], y[4], y[5]};
  flight.impact_speed_mps = std::sqrt(y[3] * y[3] + y[4] * y[4] + y[5] * y[5]);
  double rise = y[4], along = std::sqrt(y[3] * y[3] + y[5] * y[5]);
  if (s.gravity == GravityModel::curved) rise += (y[0] * y[3] + y[2] * y[5]) / kEarthRadius_m;
  flight.angle_of_fall_rad = angleOf(along, -rise);
  flight.spin_impact_radps = s.closed_form_spin ? closedFormSpin(s, y, flight.time_of_flight_s) : y[6];
  return flight;
}

}  // namespace npsee::ballistics
