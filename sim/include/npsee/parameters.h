#pragma once

#include <npsee/preset.h>
#include <npsee/units.h>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace npsee {

/// Value of any parameter. Numbers with a unit are SI; a choice is its key.
using Value = std::variant<bool, std::int64_t, double, std::string, Vec3, Colour, Curve, Gradient>;

enum class ParameterType { boolean, integer, number, choice, text, vector, colour, curve, gradient };
enum class Scope { burst, layer };
enum class Section { about, burst, surroundings, layer, hierarchy, region, launch, time, flight, ground, look, pieces };
enum class Scale { linear, logarithmic };

struct Range {
  double min = 0.0, max = 0.0;
};

/// One row of the parameter table: everything that files, validation, sliders, the command line and the reference know
/// about a parameter.
struct Parameter {
  std::string_view key;     ///< key in files and in `--set`; a dot separates nested objects
  std::string_view label;   ///< name on the slider
  std::string_view thesis;  ///< what the 1993 thesis calls it; empty if it is not in the thesis
  std::string_view doc;     ///< one or two full sentences
  Scope scope = Scope::layer;
  Section section = Section::layer;
  ParameterType type = ParameterType::number;
  Unit unit = Unit::none;
  Range hard;    ///< limits of validity, in the file unit
  Range slider;  ///< what a slider spans, in the file unit
  Scale scale = Scale::linear;
  std::span<const std::string_view> choices;
  Value initial;  ///< default, SI

  Value get(const Layer& layer) const;  ///< The layer's value; only for rows of Scope::layer. Thread-safe.
  Value get(const Preset& preset) const;  ///< The burst's value; only for rows of Scope::burst. Thread-safe.
  /// Assigns without checking; see checkValue. The value must hold this row's alternative.
  void assign(Layer& layer, const Value& value) const;
  void assign(Preset& preset, const Value& value) const;

  /// Used by withoutEffect; null where the parameter always has an effect.
  std::string_view (*idle)(const Preset&, const Layer&) = nullptr;

  std::function<Value(const void*)> read;           ///< used by get
  std::function<void(void*, const Value&)> write;   ///< used by assign
};

/// The whole table in file order: the burst's own rows first, then a layer's.
std::span<const Parameter> parameters();
std::span<const Parameter> parameters(Scope scope);

/// Why the parameter has no effect on the explosion with the other parameters as they are, e.g. "a disc has no such size"; empty where it may
/// have one. It can be set all the same. `layer` may be null for parameters of the burst.
std::string_view withoutEffect(const Parameter& parameter, const Preset& preset, const Layer* layer);

/// Row by key and scope; null if there is none.
const Parameter* findParameter(Scope scope, std::string_view key);

/// Heading of a section, e.g. "Launch".
std::string_view title(Section section);
/// "number", "choice", ... as the reference prints it.
std::string_view typeName(ParameterType type);

/// Empty if `value` is allowed, else what is wrong, e.g. "speed_mean is 5000 m/s, above the limit of 3000 m/s."
std::string checkValue(const Parameter& parameter, const Value& value);

/// Reads a value from a command line or an input field ("52deg", "1,0,0", "#ff8800", "sphere"). Checks it too.
/// Error kind usage.
Expected<Value> parseValue(const Parameter& parameter, std::string_view text);

/// The value as `parseValue` reads it back, and with its unit for people if `with_unit`.
std::string valueText(const Parameter& parameter, const Value& value, bool with_unit = false);

enum class ReferenceFormat { text, json, markdown, json_schema };
/// The parameter reference, all rows or those whose key is or ends in `key` (also "LAYER.key"). Error kind usage names the
/// nearest key.
Expected<std::string> parameterReference(ReferenceFormat format, std::string_view key = {});

}  // namespace npsee
