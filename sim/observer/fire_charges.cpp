#include "sim/observer/fire_charges.h"

#include <npsee/units.h>

#include "sim/core/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

namespace npsee::observer {
namespace {

/// A charge this close to the weapon's muzzle velocity is taken to be meant: half the step between the M107's neighbouring
/// charges (297, 316, 337 m/s), as a fraction.
constexpr double kSameCharge = 0.03;
/// Shells whose calibres differ by less than this fraction go through the same tube's name ("203mm" for 203.2 mm).
constexpr double kSameCalibre = 0.05;
constexpr std::string_view kUsualShell = "m107";

std::string named(const Weapon& weapon) { return "the weapon " + std::to_string(weapon.id) + " (" + weapon.name + ")"; }
std::string named(const BatterySetup& battery) { return "the battery \"" + battery.id + "\""; }

/// Calibre in metres from a name that begins with it ("155mmM109Howitzer", "50cal"); nothing where it does not.
std::optional<double> calibreOf(std::string_view name) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number, std::chars_format::fixed);
  if (error != std::errc()) return std::nullopt;
  const std::string_view unit = name.substr(static_cast<std::size_t>(end - name.data()));
  if (unit.starts_with("mm")) return 0.001 * number;
  // Hundredths of an inch, as in "50cal".
  if (unit.starts_with("cal")) return 0.000254 * number;
  return std::nullopt;
}

/// The shipped shell of the weapon's calibre; the M107 where the name says none or there is no such shell.
Expected<Projectile> shellFor(const Weapon& weapon, bool& fits) {
  fits = false;
  const auto calibre = calibreOf(weapon.name);
  if (calibre) {
    auto usual = findProjectile(kUsualShell);
    if (!usual) return usual;
    if (std::fabs(usual->diameter_m - *calibre) <= kSameCalibre * *calibre) {
      fits = true;
      return usual;
    }
    for (const std::string_view name : shippedProjectiles()) {
      auto shell = findProjectile(name);
      if (!shell) return shell;
      if (std::fabs(shell->diameter_m - *calibre) > kSameCalibre * *calibre) continue;
      fits = true;
      return shell;
    }
  }
  return findProjectile(kUsualShell);
}

const Charge* nearestCharge(const Projectile& shell, double speed_mps) {
  const auto best = std::ranges::min_element(shell.charges, {}, [&](const Charge& c) { return std::fabs(c.speed_mps - speed_mps); });
  return best != shell.charges.end() && std::fabs(best->speed_mps - speed_mps) <= kSameCharge * speed_mps ? &*best : nullptr;
}

std::vector<Fault> weaponFaults(const BatterySetup& battery, const Weapon& weapon) {
  std::vector<Fault> faults;
  const std::string who = named(battery) + " has " + named(weapon);
  if (weapon.path == PathType::linear || weapon.path == PathType::gravity_bomb)
    faults.push_back(placeless(who + ", which " + (weapon.path == PathType::linear ? "shoots straight lines (path type 2)." : "is a bomb (path type 3)."), "A battery needs a weapon of path type 0 or 1."));
  if (battery.charges.empty() && !(weapon.muzzle_velocity_mps >= 20.0 && weapon.muzzle_velocity_mps <= 3000.0))
    faults.push_back(placeless(who + " of " + shortest(weapon.muzzle_velocity_mps) + " m/s, with which no shell is lobbed.", "Its muzzle velocity must lie between 20 and 3000 m/s; or name the battery's charges."));
  return faults;
}

/// Charges the battery names.
Expected<void> takeNamedCharges(const BatterySetup& battery, Ammunition& out) {
  std::vector<Fault> faults;
  for (const std::string& name : battery.charges) {
    const auto charge = findCharge(out.projectile, name);
    if (charge) out.charges.push_back(*charge);
    else
      for (const Fault& fault : charge.error().faults) faults.push_back(placeless(named(battery) + ": " + fault.what, fault.remedy));
  }
  if (!faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(faults)});
  std::ranges::stable_sort(out.charges, {}, &Charge::speed_mps);
  return {};
}

/// The charge of the weapon's muzzle velocity, or a charge of that velocity without fitted factors.
void takeWeaponsCharge(const BatterySetup& battery, const Weapon& weapon, bool fits, Ammunition& out) {
  out.by_weapon = true;
  if (const Charge* charge = fits ? nearestCharge(out.projectile, weapon.muzzle_velocity_mps) : nullptr) {
    out.charges.push_back(*charge);
    return;
  }
  Charge own;
  own.name = shortest(weapon.muzzle_velocity_mps) + " m/s";
  own.speed_mps = weapon.muzzle_velocity_mps;
  out.charges.push_back(own);
  out.warnings.push_back(placeless(named(battery) + ": " + named(weapon) + " fires at " + own.name + (fits ? ", which is no charge of the " : ", and no shipped shell is known to be its own; it flies like the ") + out.projectile.name +
                                   (fits ? "; its trajectories are computed without fitted factors." : "."),
                               "Name the battery's \"projectile\" and \"charges\" to choose."));
}

}  // namespace

Fault placeless(std::string what, std::string remedy) {
  return {.what = std::move(what), .remedy = std::move(remedy), .file = {}, .line = 0, .pointer = {}};
}

Expected<Ammunition> ammunitionOf(const BatterySetup& battery, const Weapon& weapon) {
  if (auto faults = weaponFaults(battery, weapon); !faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(faults)});
  Ammunition out;
  bool fits = true;
  auto projectile = battery.projectile.empty() ? shellFor(weapon, fits) : findProjectile(battery.projectile);
  if (!projectile) {
    Error error = projectile.error();
    error.kind = ErrorKind::input;
    for (Fault& fault : error.faults)
      if (fault.file.empty()) fault.what = named(battery) + ": " + fault.what;
    return tl::unexpected<Error>(std::move(error));
  }
  out.projectile = std::move(*projectile);
  if (!battery.charges.empty()) {
    if (auto taken = takeNamedCharges(battery, out); !taken) return tl::unexpected<Error>(taken.error());
  } else {
    takeWeaponsCharge(battery, weapon, fits, out);
  }
  return out;
}

}  // namespace npsee::observer
