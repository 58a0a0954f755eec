#pragma once

#include <span>
#include <string_view>

namespace npsee::render {

/// A data file embedded when the program is built.
struct ShippedAsset {
  std::string_view name;  ///< file name without folder; presets without .npsee.json
  std::string_view text;
};

std::span<const ShippedAsset> shippedPresets();  ///< presets/*.npsee.json

}  // namespace npsee::render
