#pragma once

#include <span>
#include <string_view>

namespace npsee::ballistics {

/// A file of assets/ that is part of the library, so that programs need no path to it.
struct ShippedFile {
  std::string_view name;  ///< file name without folder and ".json"
  std::string_view text;
};

/// assets/projectiles/*.json and assets/firing_tables/*.json, in order of their names; generated when the build is configured.
std::span<const ShippedFile> shippedProjectileFiles();
std::span<const ShippedFile> shippedFiringTables();

}  // namespace npsee::ballistics
