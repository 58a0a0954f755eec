#pragma once

#include <span>
#include <string_view>

namespace npsee::fragments {

/// A file of assets/models, embedded when the program is built: *.obj and palette.mtl.
struct ShippedModel {
  std::string_view name;  ///< file name without folder
  std::string_view text;
};
std::span<const ShippedModel> shippedModelFiles();

}  // namespace npsee::fragments
