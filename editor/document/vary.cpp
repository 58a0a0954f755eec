#include "editor/document/vary.h"

#include "sim/core/random.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {
namespace {

/// A number in -1..1 for a parameter of a layer.
double drawn(const Variation& variation, std::size_t layer, std::size_t row, std::uint32_t block) {
  const ParticleIdentity identity{variation.draw, static_cast<std::uint32_t>(layer), static_cast<std::uint32_t>(row), 0x76617279u, 0};
  return 2.0 * uniformBlock(identity, block)[0] - 1.0;
}

double scaled(const Parameter& row, double shown, double u, double amount) {
  const double low = std::max(row.hard.min, std::min(row.slider.min, shown)), high = std::min(row.hard.max, std::max(row.slider.max, shown));
  return std::clamp(shown * std::exp2(2.0 * amount * u), low, high);
}

double byteOf(double part) { return std::round(std::clamp(part, 0.0, 1.0) * 255.0) / 255.0; }

/// The same shift for all colours of a course, so that they stay a family.
Colour tinted(const Colour& c, const Variation& variation, std::size_t layer, std::size_t row) {
  const double light = 0.25 * variation.amount * drawn(variation, layer, row, 1), red = 0.25 * variation.amount * drawn(variation, layer, row, 2), blue = 0.25 * variation.amount * drawn(variation, layer, row, 3);
  return {byteOf(c.r + light + red), byteOf(c.g + light - 0.5 * (red + blue)), byteOf(c.b + light + blue)};
}

Value varied(const Parameter& row, const Value& value, const Variation& variation, std::size_t layer, std::size_t index) {
  const double u = drawn(variation, layer, index, 0);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<std::int64_t>(std::llround(scaled(row, static_cast<double>(*whole), u, variation.amount)));
  if (const auto* number = std::get_if<double>(&value)) return threeDigits(row, toSi(row.unit, scaled(row, toUnit(row.unit, *number), u, variation.amount)));
  if (const auto* colour = std::get_if<Colour>(&value)) return tinted(*colour, variation, layer, index);
  Gradient gradient = std::get<Gradient>(value);
  for (GradientStop& stop : gradient) stop.colour = tinted(stop.colour, variation, layer, index);
  return gradient;
}

bool off(const Value& value) {
  const auto* whole = std::get_if<std::int64_t>(&value);
  const auto* number = std::get_if<double>(&value);
  return (whole != nullptr && *whole == 0) || (number != nullptr && *number == 0.0);
}

}  // namespace

bool varies(const Parameter& parameter) {
  using enum ParameterType;
  if (parameter.scope != Scope::layer || parameter.section == Section::layer || parameter.section == Section::hierarchy) return false;
  return parameter.type == number || parameter.type == integer || parameter.type == colour || parameter.type == gradient;
}

Preset varied(const Preset& preset, const Variation& variation) {
  Preset out = preset;
  const auto rows = parameters(Scope::layer);
  for (std::size_t i = 0; i < out.layers.size(); ++i) {
    if (variation.layer >= 0 && static_cast<int>(i) != variation.layer) continue;
    const Layer before = out.layers[i];
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const Parameter& row = rows[r];
      const Value value = row.get(before);
      if (!varies(row) || off(value) || (variation.section && row.section != *variation.section) || !withoutEffect(row, preset, &before).empty()) continue;
      if (variation.locked != nullptr && variation.locked->contains(before.name + '.' + std::string(row.key))) continue;
      row.assign(out.layers[i], varied(row, value, variation, i, r));
    }
  }
  if (validate(out).empty()) return out;
  // More particles than there may be: the numbers of them stay as they were.
  for (std::size_t i = 0; i < out.layers.size(); ++i) {
    out.layers[i].count = preset.layers[i].count;
    out.layers[i].density = preset.layers[i].density;
  }
  return validate(out).empty() ? out : preset;
}

double threeDigits(const Parameter& parameter, double si) {
  const double shown = toUnit(parameter.unit, si);
  if (shown == 0.0) return si;
  const double places = std::pow(10.0, 2.0 - std::floor(std::log10(std::abs(shown))));
  return toSi(parameter.unit, std::round(shown * places) / places);
}

}  // namespace npsee::editor
