#pragma once

#include <npsee/projectile.h>
#include <npsee/scenario.h>

#include <vector>

namespace npsee::observer {

/// What a battery fires: a projectile of the ballistics library and its charges, weakest first.
struct Ammunition {
  Projectile projectile;
  std::vector<Charge> charges;
  bool by_weapon = false;       ///< the charge follows from the weapon's muzzle velocity, as its stated range does
  std::vector<Fault> warnings;  ///< how the choice was made where the files leave it open
};

/// A fault whose place in a file whoever reads the file fills in.
Fault placeless(std::string what, std::string remedy);

/// Reads it from the battery, and where that is silent from the weapon: calibre by its name, charge by its muzzle velocity.
/// Error kind input: unknown projectile or charge, a weapon that fires no shells.
Expected<Ammunition> ammunitionOf(const BatterySetup& battery, const Weapon& weapon);

}  // namespace npsee::observer
