#pragma once

#include <npsee/parameters.h>

#include <cmath>
#include <random>

namespace npsee::test {

/// Uniform in a..b from a fixed engine; std::uniform_real_distribution differs between libraries.
inline double between(std::mt19937_64& random, double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; }

/// A number or choice anywhere in a row's hard range, numbers mostly in the lower part where sliders are; its default for other types.
inline Value randomValue(const Parameter& row, std::mt19937_64& random) {
  if (row.type == ParameterType::choice) return std::string(row.choices[random() % row.choices.size()]);
  if (row.type == ParameterType::vector) return Vec3{between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
  if (row.type != ParameterType::number) return row.initial;
  const Range& range = random() % 4 == 0 ? row.hard : row.slider;
  return toSi(row.unit, between(random, range.min, range.max));
}

/// A preset of one layer whose numbers and choices are anywhere in their hard ranges, numbers mostly in the lower part where
/// sliders are. Not necessarily within the particle budget.
inline Preset randomPreset(std::mt19937_64& random) {
  Preset preset;
  preset.layers.emplace_back();
  for (const Parameter& row : parameters(Scope::burst)) row.assign(preset, randomValue(row, random));
  for (const Parameter& row : parameters(Scope::layer)) row.assign(preset.layers[0], randomValue(row, random));
  preset.layers[0].parent.clear();
  preset.layers[0].trigger = Trigger::none;
  return preset;
}

}  // namespace npsee::test
