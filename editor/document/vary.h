#pragma once

#include <npsee/parameters.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace npsee::editor {

/// How a preset is varied at random.
struct Variation {
  double amount = 0.2;           ///< 0 to 1: at 0.2 most values stay within a third of what they were, at 1 within a factor of four
  std::uint64_t draw = 0;        ///< another number gives another variation
  int layer = -1;                ///< the layer that is varied; -1 = all
  std::optional<Section> section = {};  ///< only its parameters
  const std::set<std::string>* locked = nullptr;  ///< "LAYER.key" of what stays as it is
};

/// True for parameters that a variation may change: numbers, counts and colours of a layer that shape it. Names, parents, switches and choices
/// are the designer's.
bool varies(const Parameter& parameter);

/// The preset with values drawn anew around its own. A pure function: the same variation always gives the same. What is off (0), has no effect, or
/// is locked stays; values stay within their sliders' ranges, or where they were beyond; the number of particles stays within the limits.
Preset varied(const Preset& preset, const Variation& variation);

/// Three significant digits in the unit people read: what a hand can place.
double threeDigits(const Parameter& parameter, double si);

}  // namespace npsee::editor
