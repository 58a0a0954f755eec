// The C interface to projectiles, flights and aiming.

#include "sim/c/guard.h"

#include <npsee/aiming.h>
#include <npsee/ballistics.h>

#include <cmath>
#include <optional>
#include <span>

using namespace npsee;

struct npsee_projectile {
  Projectile value;
  std::optional<Factors> factors = {};  ///< set by hand; they replace those of every charge, because they belong together
};
struct npsee_ballistics {
  Ballistics value;
  std::optional<Factors> factors;
};
struct npsee_path {
  FlightPath value;
};

namespace {

Vec3 vectorOf(const double (&numbers)[3]) { return {numbers[0], numbers[1], numbers[2]}; }

/// Index of a name in an enum's list of names; a null name leaves the default.
template <class Enum>
Expected<Enum> chosen(const char* what, const char* name, std::span<const std::string_view> names, Enum otherwise) {
  if (name == nullptr) return otherwise;
  std::string known;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<Enum>(i);
    known += (known.empty() ? "" : ", ") + std::string(names[i]);
  }
  return fail(ErrorKind::usage, std::string(what) + ": there is no \"" + printable(name) + "\".", "It is one of " + known + ".");
}

Shot shotOf(const npsee_shot& from) {
  Shot to;
  to.speed_mps = from.speed_mps;
  to.elevation_rad = from.elevation_rad;
  to.azimuth_rad = from.azimuth_rad;
  to.wind_mps = vectorOf(from.wind_mps);
  to.muzzle_m = vectorOf(from.muzzle_m);
  to.factors = {from.form, from.lift, from.magnus, from.yaw_drag};
  return to;
}

npsee_shot shotFor(const Shot& from) {
  npsee_shot to{};
  to.speed_mps = from.speed_mps;
  to.elevation_rad = from.elevation_rad;
  to.azimuth_rad = from.azimuth_rad;
  c::put(from.wind_mps, to.wind_mps);
  c::put(from.muzzle_m, to.muzzle_m);
  to.form = from.factors.form;
  to.lift = from.factors.lift;
  to.magnus = from.factors.magnus;
  to.yaw_drag = from.factors.yaw_drag;
  return to;
}

npsee_flight flightFor(const Flight& from) {
  npsee_flight to{};
  to.impact = from.end == FlightEnd::impact ? 1 : 0;
  to.range_m = from.range_m;
  to.drift_m = from.drift_m;
  to.height_m = from.height_m;
  to.time_of_flight_s = from.time_of_flight_s;
  to.max_ordinate_m = from.max_ordinate_m;
  to.apex_time_s = from.apex_time_s;
  to.apex_range_m = from.apex_range_m;
  to.apex_drift_m = from.apex_drift_m;
  to.impact_speed_mps = from.impact_speed_mps;
  to.angle_of_fall_rad = from.angle_of_fall_rad;
  c::put(from.impact_velocity_mps, to.impact_velocity_mps);
  to.spin_muzzle_radps = from.spin_muzzle_radps;
  to.spin_impact_radps = from.spin_impact_radps;
  to.yaw_max_rad = from.yaw_max_rad;
  to.doubts = from.doubts;
  to.evaluations = from.evaluations;
  to.steps = from.steps;
  return to;
}

Conditions airAndEarth(const npsee_conditions& from, GravityModel gravity) {
  Conditions to;
  to.atmosphere = {from.icao != 0, from.density_kgm3, from.sound_speed_mps};
  to.gravity = gravity;
  to.gravity_mps2 = from.gravity_mps2;
  to.coriolis = from.coriolis != 0;
  to.has_latitude = from.has_latitude != 0;
  to.latitude_rad = from.latitude_rad;
  to.muzzle_altitude_m = from.muzzle_altitude_m;
  to.target_height_m = from.target_height_m;
  return to;
}

Expected<Ballistics> make(const Projectile& projectile, const npsee_conditions& from) {
  const auto model = chosen("model", from.model, flightModelNames(), FlightModel::modified_point_mass);
  if (!model) return tl::unexpected(model.error());
  const auto integrator = chosen("integrator", from.integrator, integratorNames(), Integrator::dormand_prince);
  if (!integrator) return tl::unexpected(integrator.error());
  const auto gravity = chosen("gravity", from.gravity, gravityModelNames(), GravityModel::flat);
  if (!gravity) return tl::unexpected(gravity.error());
  Integration integration;
  integration.integrator = *integrator;
  integration.tolerance_m = from.tolerance_m;
  integration.step_s = from.step_s;
  integration.time_limit_s = from.time_limit_s;
  integration.step_limit = from.step_limit;
  return Ballistics::make(projectile, airAndEarth(from, *gravity), *model, integration);
}

Expected<AimRequest> requestOf(const npsee_ballistics& ballistics, const npsee_target& target) {
  AimRequest request;
  request.speed_mps = target.speed_mps;
  if (target.charge != nullptr) {
    const auto charge = findCharge(ballistics.value.projectile(), target.charge);
    if (!charge) return tl::unexpected(charge.error());
    request.speed_mps = charge->speed_mps;
    request.factors = charge->factors;
  }
  if (const auto& f = ballistics.factors) request.factors = {0.0, 0.0, {f->form}, {f->lift}, {f->magnus}, {f->yaw_drag}, {}};
  request.azimuth_rad = target.azimuth_rad;
  request.wind_mps = vectorOf(target.wind_mps);
  request.height_m = target.height_m;
  request.muzzle_m = vectorOf(target.muzzle_m);
  return request;
}

npsee_status aim(const npsee_ballistics& ballistics, const npsee_target& target, npsee_solution& solution) {
  const auto request = requestOf(ballistics, target);
  if (!request) return c::refuse(request.error());
  if (const auto sound = Aimer::check(ballistics.value, *request); !sound) return c::refuse(sound.error());
  if (!(target.range_m > 0.0)) return c::refuse(NPSEE_USAGE, "range_m is not above 0.");
  const auto aimer = Aimer::make(ballistics.value, *request);
  // What is left is a target higher than the shell flies.
  if (!aimer) return c::refuse(NPSEE_NEGATIVE, aimer.error().text());
  if (const auto reach = aimer->checkReach(target.range_m); !reach) return c::refuse(NPSEE_NEGATIVE, reach.error().text());
  const auto found = target.high != 0 ? aimer->high(target.range_m) : aimer->low(target.range_m);
  if (!found) return c::refuse(NPSEE_NEGATIVE, std::string("the ") + (target.high != 0 ? "higher" : "lower") + " of the two elevations does not reach that distance.");
  solution = {shotFor(found->shot), flightFor(found->flight), found->azimuth_correction_rad, found->miss_m};
  return NPSEE_OK;
}

}  // namespace

extern "C" {

npsee_status npsee_projectile_find(const char* choice, npsee_projectile** projectile) {
  NPSEE_MAKES(projectile);
  NPSEE_NEEDS(choice);
  return c::guarded(__func__, [&] { return c::handOver(findProjectile(choice), projectile); });
}

npsee_status npsee_projectile_parse(const char* text, size_t length, const char* name, npsee_projectile** projectile) {
  NPSEE_MAKES(projectile);
  NPSEE_NEEDS(text);
  return c::guarded(__func__, [&] { return c::handOver(parseProjectile({text, length}, c::orEmpty(name)), projectile); });
}

npsee_status npsee_projectile_set(npsee_projectile* projectile, const char* setting) {
  NPSEE_NEEDS(projectile);
  NPSEE_NEEDS(setting);
  return c::guarded(__func__, [&] { return c::settle(applyProjectileSetting(projectile->value, projectile->factors, setting)); });
}

size_t npsee_projectile_charges(const npsee_projectile* projectile) { return projectile != nullptr ? projectile->value.charges.size() : 0; }

npsee_status npsee_projectile_charge(const npsee_projectile* projectile, size_t index, const char** name, double* speed_mps) {
  NPSEE_NEEDS(projectile);
  return c::guarded(__func__, [&] {
    const auto& charges = projectile->value.charges;
    if (index >= charges.size()) return c::refuse(NPSEE_USAGE, "there are " + std::to_string(charges.size()) + " charges, counted from 0.");
    if (name != nullptr) *name = charges[index].name.c_str();
    if (speed_mps != nullptr) *speed_mps = charges[index].speed_mps;
    return NPSEE_OK;
  });
}

npsee_status npsee_projectile_shot(const npsee_projectile* projectile, const char* charge, double elevation_rad, npsee_shot* shot) {
  NPSEE_NEEDS(projectile);
  NPSEE_NEEDS(shot);
  return c::guarded(__func__, [&] {
    Shot made;
    made.elevation_rad = elevation_rad;
    if (charge != nullptr) {
      const auto found = findCharge(projectile->value, charge);
      if (!found) return c::refuse(found.error());
      made.speed_mps = found->speed_mps;
      made.factors = found->factors.at(elevation_rad);
    }
    if (projectile->factors) made.factors = *projectile->factors;
    *shot = shotFor(made);
    return NPSEE_OK;
  });
}

void npsee_projectile_free(npsee_projectile* projectile) { delete projectile; }

npsee_conditions npsee_conditions_default(void) {
  const Conditions conditions;
  const Integration integration;
  npsee_conditions out{};
  out.icao = 1;
  out.density_kgm3 = conditions.atmosphere.density_kgm3;
  out.sound_speed_mps = conditions.atmosphere.sound_speed_mps;
  out.tolerance_m = integration.tolerance_m;
  out.step_s = integration.step_s;
  out.time_limit_s = integration.time_limit_s;
  out.step_limit = integration.step_limit;
  return out;
}

npsee_status npsee_ballistics_make(const npsee_projectile* projectile, const npsee_conditions* conditions, npsee_ballistics** ballistics) {
  NPSEE_MAKES(ballistics);
  NPSEE_NEEDS(projectile);
  return c::guarded(__func__, [&] {
    auto made = make(projectile->value, conditions != nullptr ? *conditions : npsee_conditions_default());
    if (!made) return c::refuse(made.error());
    *ballistics = new npsee_ballistics{std::move(*made), projectile->factors};
    return NPSEE_OK;
  });
}

void npsee_ballistics_free(npsee_ballistics* ballistics) { delete ballistics; }

npsee_status npsee_ballistics_fly(const npsee_ballistics* ballistics, const npsee_shot* shot, npsee_flight* flight) {
  NPSEE_NEEDS(ballistics);
  NPSEE_NEEDS(shot);
  NPSEE_NEEDS(flight);
  return c::guarded(__func__, [&] {
    const Shot wanted = shotOf(*shot);
    if (const auto possible = ballistics->value.checkShot(wanted); !possible) return c::refuse(possible.error());
    *flight = flightFor(ballistics->value.fly(wanted));
    return NPSEE_OK;
  });
}

npsee_status npsee_ballistics_path(const npsee_ballistics* ballistics, const npsee_shot* shot, npsee_path** path) {
  NPSEE_MAKES(path);
  NPSEE_NEEDS(ballistics);
  NPSEE_NEEDS(shot);
  return c::guarded(__func__, [&] {
    const Shot wanted = shotOf(*shot);
    if (const auto possible = ballistics->value.checkShot(wanted); !possible) return c::refuse(possible.error());
    *path = new npsee_path{ballistics->value.path(wanted)};
    return NPSEE_OK;
  });
}

npsee_status npsee_path_at(const npsee_path* path, double t_s, int world, double* position_m, double* velocity_mps, double* spin_radps) {
  NPSEE_NEEDS(path);
  return c::guarded(__func__, [&] {
    if (!std::isfinite(t_s)) return c::refuse(NPSEE_USAGE, "the time is no finite number of seconds.");
    const FlightPath::State state = world != 0 ? path->value.inWorld(t_s) : path->value.at(t_s);
    c::put(state.position_m, position_m);
    c::put(state.velocity_mps, velocity_mps);
    if (spin_radps != nullptr) *spin_radps = state.spin_radps;
    return NPSEE_OK;
  });
}

void npsee_path_free(npsee_path* path) { delete path; }

npsee_status npsee_ballistics_aim(const npsee_ballistics* ballistics, const npsee_target* target, npsee_solution* solution) {
  NPSEE_NEEDS(ballistics);
  NPSEE_NEEDS(target);
  NPSEE_NEEDS(solution);
  return c::guarded(__func__, [&] { return aim(*ballistics, *target, *solution); });
}

}
