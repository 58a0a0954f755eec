#pragma once

#include <npsee/aiming.h>
#include <npsee/ballistics.h>

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace npsee::commands {

/// What `fly`, `table` and `aim` share: a projectile, how it is fired and how it is computed. Kept as typed; `resolve` reads it.
struct ShotOptions {
  std::string projectile, charge, speed;
  std::string mass, diameter, inertia, twist, cd, cspin, aero, interpolation;
  std::vector<std::string> settings;
  bool unfitted = false, left_hand = false;
  std::string azimuth, wind, latitude, coriolis, gravity, g, atmosphere, altitude, target_height;
  std::string model, integrator, tolerance, dt;
};
void addShotOptions(CLI::App& command, ShotOptions& options);

/// The options' meaning.
struct Firing {
  Projectile projectile;
  Charge charge;         ///< name empty where --v0 was given
  bool fixed_factors = false;
  Factors factors;       ///< where fixed by --set
  Conditions conditions;
  Integration integration;
  FlightModel model = FlightModel::modified_point_mass;
  double azimuth_rad = 0.0;
  Vec3 wind_mps;

  /// The shot at an elevation, with the charge's factors for it.
  Shot shot(double elevation_rad) const;
  /// What an Aimer is to hit: the azimuth is the target's bearing, the wind lies along the line to it.
  AimRequest aimRequest() const;
  Expected<Ballistics> ballistics() const { return Ballistics::make(projectile, conditions, model, integration); }
};
/// Error kind usage names the option; kind input is about a file. `needs_charge`: refuse when no muzzle velocity is known.
Expected<Firing> resolve(const ShotOptions& options, bool needs_charge = true);

/// Reads a number with a unit; `option` begins the message.
Expected<double> parseOption(const char* option, std::string_view text, Unit unit);

/// FROM:TO:STEP of a table. Error kind usage: not of that form, a step of the wrong sign, more than 10,000 rows.
Expected<std::vector<double>> parseSteps(const char* option, std::string_view text, Unit unit);

/// One line that says what is flown: projectile, charge, model, integrator, air, gravity.
std::string describe(const Firing& firing);
/// Why a flight is flagged, e.g. "steeper than 1150 mil"; empty where it is not.
std::vector<std::string> doubtTexts(const Flight& flight, const Projectile& projectile);

}  // namespace npsee::commands
