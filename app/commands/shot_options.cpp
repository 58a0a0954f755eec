#include "app/commands/shot_options.h"

#include "sim/core/files.h"
#include "sim/core/text.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <span>

namespace npsee::commands {
namespace {

struct Alias {
  std::string_view name;
  int value;
};
constexpr Alias kModelAliases[] = {{"mpm", 3}, {"thesis", 2}, {"simplified", 2}, {"simplified-mpm", 2}};
constexpr Alias kIntegratorAliases[] = {{"dp45", 0}, {"dopri5", 0}, {"adaptive", 0}, {"pece", 1}, {"lieske", 1}, {"thesis", 1}, {"runge-kutta", 2}};

std::string choices(std::span<const std::string_view> names) {
  std::string out;
  for (const std::string_view name : names) out += (out.empty() ? "" : ", ") + std::string(name);
  return out;
}

Expected<int> chosen(const char* option, std::string_view text, std::span<const std::string_view> names, std::span<const Alias> aliases = {}) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (text == names[i]) return static_cast<int>(i);
  for (const Alias& alias : aliases)
    if (text == alias.name) return alias.value;
  const std::vector<std::string_view> known(names.begin(), names.end());
  const auto near = nearest(text, known);
  return fail(ErrorKind::usage, std::string(option) + ": there is no \"" + std::string(text) + "\".", (near ? "Did you mean " + std::string(*near) + "? " : std::string()) + "It is one of " + choices(names) + ".");
}

/// Reads the options one after the other into a Firing and keeps the first error.
class Resolver {
 public:
  explicit Resolver(const ShotOptions& options) : o_(options) {}

  Expected<Firing> run(bool needs_charge) {
    modelAndIntegrator();
    projectile();
    conditions();
    if (needs_charge || !o_.charge.empty() || !o_.speed.empty()) charge();
    settings();
    if (failed_) return tl::unexpected<Error>(std::move(error_));
    return std::move(f_);
  }

 private:
  template <class T>
  bool take(Expected<T>&& result, T& into) {
    if (failed_) return false;
    if (result) {
      into = std::move(*result);
      return true;
    }
    refuse(std::move(result.error()));
    return false;
  }
  void refuse(Error error) {
    if (failed_) return;
    failed_ = true;
    error_ = std::move(error);
  }
  void refuse(std::string what, std::string remedy = {}) { refuse(fail(ErrorKind::usage, std::move(what), std::move(remedy)).value()); }

  bool number(const char* option, const std::string& text, double& into, Unit unit = Unit::none) {
    return !text.empty() && !failed_ && take(parseOption(option, text, unit), into);
  }

  void modelAndIntegrator() {
    int index = 0;
    if (!o_.model.empty() && take(chosen("--model", o_.model, flightModelNames(), kModelAliases), index)) f_.model = static_cast<FlightModel>(index);
    if (!o_.integrator.empty() && take(chosen("--integrator", o_.integrator, integratorNames(), kIntegratorAliases), index)) f_.integration.integrator = static_cast<Integrator>(index);
    number("--tolerance", o_.tolerance, f_.integration.tolerance_m, Unit::metre);
    number("--dt", o_.dt, f_.integration.step_s, Unit::second);
  }

  void projectile() {
    // Given by options alone: mass, calibre and a drag.
    const bool whole = o_.projectile.empty() && !o_.mass.empty() && !o_.diameter.empty() && !(o_.cd.empty() && o_.aero.empty());
    if (whole) {
      f_.projectile.name = "given by options";
      f_.projectile.status = "given by options";
    } else if (!take(findProjectile(o_.projectile.empty() ? "m107" : o_.projectile), f_.projectile)) {
      return;
    }
    if (!o_.aero.empty()) aero();
    constantCurve("--cd", o_.cd, Coefficient::cd0);
    constantCurve("--cspin", o_.cspin, Coefficient::cspin);
    std::optional<Factors> unused;
    const std::pair<const char*, const std::string&> constants[] = {{"mass", o_.mass}, {"diameter", o_.diameter}, {"inertia", o_.inertia}, {"twist", o_.twist}};
    for (const auto& [key, text] : constants) {
      if (text.empty() || failed_) continue;
      auto set = applyProjectileSetting(f_.projectile, unused, std::string(key) + "=" + text);
      if (set) continue;
      Error error = set.error();
      // The option's own name instead of that of --set.
      std::string& what = error.faults.front().what;
      if (const std::size_t colon = what.find(": "); what.starts_with("--set ")) what = "--" + std::string(key) + " " + text + what.substr(colon);
      refuse(std::move(error));
    }
    if (o_.left_hand) f_.projectile.left_hand = true;
  }

  void aero() {
    int index = 0;
    static constexpr std::string_view kinds[] = {"linear", "monotone"};
    static constexpr Alias aliases[] = {{"pchip", 1}};
    Interpolation interpolation = Interpolation::monotone;
    if (!o_.interpolation.empty() && take(chosen("--interpolation", o_.interpolation, kinds, aliases), index)) interpolation = static_cast<Interpolation>(index);
    std::string text;
    if (!take(readTextFile(o_.aero), text)) return;
    const bool drag_only = f_.model == FlightModel::vacuum || f_.model == FlightModel::point_mass;
    take(parseAeroTable(text, o_.aero, interpolation, drag_only), f_.projectile.aero);
  }

  void constantCurve(const char* option, const std::string& text, Coefficient coefficient) {
    double value = 0.0;
    if (!number(option, text, value)) return;
    if (coefficient == Coefficient::cd0 && !(value >= 0.0 && value <= 100.0)) return refuse(std::string(option) + ' ' + text + ": a drag coefficient lies between 0 and 100.");
    if (coefficient == Coefficient::cspin && !(value <= 0.0 && value >= -100.0)) return refuse(std::string(option) + ' ' + text + ": the spin damping coefficient lies between -100 and 0.", "It is negative: the air slows the spin.");
    f_.projectile.curve(coefficient) = CoefficientCurve::constant(value);
  }

  void atmosphere() {
    const std::string& text = o_.atmosphere;
    if (text.empty() || text == "icao") return;
    constexpr std::string_view kConstant = "constant:";
    if (!text.starts_with(kConstant)) return refuse("--atmosphere: there is no \"" + text + "\".", "It is icao, or constant:RHO with a density in kg/m3, e.g. constant:1.225.");
    f_.conditions.atmosphere.icao = false;
    number("--atmosphere constant:", text.substr(kConstant.size()), f_.conditions.atmosphere.density_kgm3);
    if (text.size() == kConstant.size()) refuse("--atmosphere constant: lacks the density.", "For example --atmosphere constant:1.225.");
    if (!failed_ && !(f_.conditions.atmosphere.density_kgm3 >= 0.0)) refuse("--atmosphere " + text + ": a density is not negative.");
  }

  void conditions() {
    Conditions& c = f_.conditions;
    int index = 0;
    atmosphere();
    if (!o_.gravity.empty() && take(chosen("--gravity", o_.gravity, gravityModelNames()), index)) c.gravity = static_cast<GravityModel>(index);
    if (number("--g", o_.g, c.gravity_mps2, Unit::metre_per_second2) && !(c.gravity_mps2 >= 0.01 && c.gravity_mps2 <= 100.0)) refuse("--g " + o_.g + ": gravity lies between 0.01 and 100 m/s2.");
    if (number("--latitude", o_.latitude, c.latitude_rad, Unit::degree)) c.has_latitude = c.coriolis = true;
    if (!o_.coriolis.empty()) {
      static constexpr std::string_view switches[] = {"off", "on"};
      if (take(chosen("--coriolis", o_.coriolis, switches), index)) c.coriolis = index == 1;
    }
    number("--altitude", o_.altitude, c.muzzle_altitude_m, Unit::metre);
    number("--height-of-target", o_.target_height, c.target_height_m, Unit::metre);
    number("--azimuth", o_.azimuth, f_.azimuth_rad, Unit::mil);
    wind();
  }

  void wind() {
    if (o_.wind.empty() || failed_) return;
    const auto parts = splitAt(o_.wind, ',');
    if (parts.size() != 3) return refuse("--wind " + o_.wind + ": there are " + std::to_string(parts.size()) + " numbers instead of three.", "Give the velocity of the air as range,up,right in m/s: a tail wind of 10 m/s is --wind 10,0,0.");
    double* into[] = {&f_.wind_mps.x, &f_.wind_mps.y, &f_.wind_mps.z};
    for (std::size_t i = 0; i < 3; ++i) take(parseOption("--wind", parts[i], Unit::metre_per_second), *into[i]);
  }

  void charge() {
    if (failed_) return;
    if (!o_.charge.empty() && !o_.speed.empty()) return refuse("--charge and --v0 both give the muzzle velocity.", "Keep one of them.");
    if (!o_.charge.empty()) {
      take(findCharge(f_.projectile, o_.charge), f_.charge);
      if (o_.unfitted) f_.charge.factors = {};
      return;
    }
    if (number("--v0", o_.speed, f_.charge.speed_mps, Unit::metre_per_second) || failed_) return;
    const auto names = namesOf(f_.projectile.charges, &Charge::name);
    refuse("no muzzle velocity is given.", names.empty() ? "Give it with --v0, e.g. --v0 300." : "Give --charge (" + listed(names) + ") or --v0.");
  }

  void settings() {
    std::optional<Factors> by_hand;
    for (const std::string& setting : o_.settings) {
      if (failed_) return;
      if (auto set = applyProjectileSetting(f_.projectile, by_hand, setting); !set) refuse(set.error());
    }
    f_.fixed_factors = by_hand.has_value();
    f_.factors = by_hand.value_or(Factors{});
  }

  const ShotOptions& o_;
  Firing f_;
  bool failed_ = false;
  Error error_;
};

}  // namespace

Expected<double> parseOption(const char* option, std::string_view text, Unit unit) {
  auto value = parseQuantity(text, unit);
  if (value) return value;
  Error error = value.error();
  error.faults.front().what = std::string(option) + ": " + error.faults.front().what;
  return tl::unexpected<Error>(std::move(error));
}

Expected<std::vector<double>> parseSteps(const char* option, std::string_view text, Unit unit) {
  const auto parts = splitAt(text, ':');
  const std::string form = std::string(option) + " " + std::string(text) + ": ";
  if (parts.size() != 3) return fail(ErrorKind::usage, form + "not of the form FROM:TO:STEP.", "For example --qe 100:1100:100 or --range 2000:7000:500.");
  double numbers[3];
  for (std::size_t i = 0; i < 3; ++i) {
    auto value = parseOption(option, parts[i], unit);
    if (!value) return tl::unexpected<Error>(value.error());
    numbers[i] = *value;
  }
  const double count = std::floor((numbers[1] - numbers[0]) / numbers[2] * (1.0 + 1e-12) + 1e-9);
  if (!(numbers[2] > 0.0) || !(count >= 0.0)) return fail(ErrorKind::usage, form + "the step must be above 0 and TO not below FROM.");
  if (count > 9999.0) return fail(ErrorKind::usage, form + "that makes more than 10000 rows.", "Choose a longer step.");
  std::vector<double> out;
  for (int i = 0; i <= static_cast<int>(count); ++i) out.push_back(numbers[0] + i * numbers[2]);
  return out;
}

Expected<Firing> resolve(const ShotOptions& options, bool needs_charge) { return Resolver(options).run(needs_charge); }

Shot Firing::shot(double elevation_rad) const {
  Shot shot;
  shot.speed_mps = charge.speed_mps;
  shot.elevation_rad = elevation_rad;
  shot.azimuth_rad = azimuth_rad;
  shot.wind_mps = wind_mps;
  shot.factors = fixed_factors ? factors : charge.factors.at(elevation_rad);
  return shot;
}

AimRequest Firing::aimRequest() const {
  AimRequest request;
  request.speed_mps = charge.speed_mps;
  request.factors = fixed_factors ? FactorCurves{0.0, 0.0, {factors.form}, {factors.lift}, {factors.magnus}, {factors.yaw_drag}, {}} : charge.factors;
  request.azimuth_rad = azimuth_rad;
  request.wind_mps = wind_mps;
  request.height_m = conditions.target_height_m;
  return request;
}

void addShotOptions(CLI::App& command, ShotOptions& o) {
  const auto option = [&](const char* name, std::string& into, const std::string& help, const char* type) { return command.add_option(name, into, help)->type_name(type); };
  const std::string projectile = "Projectile";
  option("--projectile", o.projectile, "A shipped projectile or a file (default m107); shipped are " + choices(shippedProjectiles()), "NAME|FILE")->group(projectile);
  option("--charge", o.charge, "Charge of the projectile, with its fitting factors", "NAME")->group(projectile);
  option("--v0", o.speed, "Muzzle velocity instead of a charge, m/s", "SPEED")->group(projectile);
  option("--twist", o.twist, "Calibres per turn of the rifling; 0 = none", "CAL")->group(projectile);
  command.add_flag("--left-hand", o.left_hand, "Rifling to the left")->group(projectile);
  option("--mass", o.mass, "Mass, kg. With --diameter and --cd or --aero the projectile is wholly given by options", "KG")->group(projectile);
  option("--diameter", o.diameter, "Calibre, m", "M")->group(projectile);
  option("--inertia", o.inertia, "Axial moment of inertia, kg m2", "KGM2")->group(projectile);
  option("--cd", o.cd, "One drag coefficient for all Mach numbers", "CD")->group(projectile);
  option("--cspin", o.cspin, "One spin damping coefficient, p d / V, negative", "C")->group(projectile);
  option("--aero", o.aero, "Coefficient table {\"M\": [...], \"CD0\": [...], ...}", "FILE")->group(projectile);
  option("--interpolation", o.interpolation, "Of --aero: monotone (default) or linear", "KIND")->group(projectile);
  std::string keys;
  for (const ProjectileSetting& setting : projectileSettings()) keys += (keys.empty() ? "" : ", ") + std::string(setting.key);
  command.add_option("--set", o.settings, "Change a constant or a fitting factor: " + keys + "; repeatable")->allow_extra_args(false)->type_name("KEY=VALUE")->group(projectile);
  command.add_flag("--unfitted", o.unfitted, "Leave the charge's fitting factors out")->group(projectile);

  const std::string surroundings = "Surroundings";
  option("--azimuth", o.azimuth, "Line of fire, clockwise from north, mil (default 0)", "ANGLE")->group(surroundings);
  option("--wind", o.wind, "Velocity of the air along range, up and right, m/s", "X,Y,Z")->group(surroundings);
  option("--atmosphere", o.atmosphere, "icao (default) or constant:RHO: that density at any height, speed of sound 340.294 m/s", "AIR")->group(surroundings);
  option("--gravity", o.gravity, choices(gravityModelNames()) + " (default flat)", "KIND")->group(surroundings);
  option("--g", o.g, "Gravity at the muzzle, m/s2 (default 9.80665)", "G")->group(surroundings);
  option("--latitude", o.latitude, "Latitude, deg; turns the Coriolis force on", "ANGLE")->group(surroundings);
  option("--coriolis", o.coriolis, "on or off", "on|off")->group(surroundings);
  option("--altitude", o.altitude, "Muzzle above sea level, m (default 0)", "M")->group(surroundings);
  option("--height-of-target", o.target_height, "Surface of impact above the muzzle, m (default 0)", "M")->group(surroundings);

  const std::string computing = "Computing";
  option("--model", o.model, choices(flightModelNames()) + " (default the last)", "MODEL")->group(computing);
  option("--integrator", o.integrator, choices(integratorNames()) + " (default the first)", "NAME")->group(computing);
  option("--tolerance", o.tolerance, "Of dormand-prince, m at the impact (default 0.0003)", "M")->group(computing);
  option("--dt", o.dt, "Step of the other integrators, s (default 0.1)", "S")->group(computing);
}

std::string describe(const Firing& f) {
  std::string out = printable(f.projectile.title.empty() ? f.projectile.name : f.projectile.title);
  if (f.projectile.status == "ESTIMATE") out += " [ESTIMATE, not data]";
  out += "\n" + (f.charge.name.empty() ? std::string("muzzle velocity ") : "charge " + f.charge.name + ", ") + shortest(f.charge.speed_mps) + " m/s";
  if (f.model == FlightModel::modified_point_mass || f.model == FlightModel::simplified_modified_point_mass)
    out += f.fixed_factors ? ", factors set by hand" : f.charge.factors == FactorCurves{} ? ", unfitted" : ", fitted";
  out += "; " + std::string(flightModelNames()[static_cast<std::size_t>(f.model)]) + ", " + std::string(integratorNames()[static_cast<std::size_t>(f.integration.integrator)]);
  out += f.conditions.atmosphere.icao ? ", icao" : ", constant air";
  out += ", " + std::string(gravityModelNames()[static_cast<std::size_t>(f.conditions.gravity)]) + " gravity";
  if (f.conditions.coriolis) out += ", Coriolis";
  return out + "\n";
}

std::vector<std::string> doubtTexts(const Flight& flight, const Projectile& projectile) {
  std::vector<std::string> out;
  if (flight.doubts & doubt_elevation) out.push_back("steeper than " + withDecimals(projectile.valid_elevation_rad * 3200.0 / kPi, 0) + " mil, where the yaw of repose grows beyond the model");
  if (flight.doubts & doubt_yaw) out.push_back("the yaw of repose reached its limit of " + shortest(kYawClamp_rad) + " rad");
  if (flight.doubts & doubt_mach) out.push_back("faster than the coefficient tables reach; their last value was held");
  return out;
}

}  // namespace npsee::commands
