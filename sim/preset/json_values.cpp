#include "sim/preset/json_values.h"

#include "sim/preset/values.h"

#include <nlohmann/json.hpp>

namespace npsee {
namespace {

using nlohmann::ordered_json;

std::string_view wanted(ParameterType type) {
  switch (type) {
    case ParameterType::boolean: return "true or false";
    case ParameterType::integer: return "a whole number";
    case ParameterType::number: return "a number";
    case ParameterType::choice:
    case ParameterType::text: return "a text";
    case ParameterType::vector: return "a list of three numbers";
    case ParameterType::colour: return "a text \"#rrggbb\" or a list of three numbers 0 to 1";
    case ParameterType::curve: return "a list of points [fraction of life, factor]";
    case ParameterType::gradient: return "a list of stops [fraction of life, colour]";
  }
  return "";
}

std::optional<Vec3> triple(const ordered_json& json) {
  if (!json.is_array() || json.size() != 3) return std::nullopt;
  for (const auto& part : json)
    if (!part.is_number()) return std::nullopt;
  return Vec3{json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

std::optional<Colour> colourOf(const ordered_json& json) {
  if (json.is_string()) return parseHexColour(json.get_ref<const std::string&>());
  if (const auto v = triple(json)) return Colour{v->x, v->y, v->z};
  return std::nullopt;
}

std::optional<Curve> curveOf(const ordered_json& json) {
  if (!json.is_array()) return std::nullopt;
  Curve out;
  for (const auto& point : json) {
    if (!point.is_array() || point.size() != 2 || !point[0].is_number() || !point[1].is_number()) return std::nullopt;
    out.push_back({point[0].get<double>(), point[1].get<double>()});
  }
  return out;
}

std::optional<Gradient> gradientOf(const ordered_json& json) {
  if (!json.is_array()) return std::nullopt;
  Gradient out;
  for (const auto& stop : json) {
    if (!stop.is_array() || stop.size() != 2 || !stop[0].is_number()) return std::nullopt;
    const auto colour = colourOf(stop[1]);
    if (!colour) return std::nullopt;
    out.push_back({stop[0].get<double>(), *colour});
  }
  return out;
}

std::optional<Value> convert(const Parameter& row, const ordered_json& json) {
  const auto lift = [](const auto& maybe) -> std::optional<Value> {
    if (!maybe) return std::nullopt;
    return Value(*maybe);
  };
  switch (row.type) {
    case ParameterType::boolean: return json.is_boolean() ? std::optional<Value>(json.get<bool>()) : std::nullopt;
    case ParameterType::integer: return lift(wholeNumber(json));
    case ParameterType::number: return json.is_number() ? std::optional<Value>(toSi(row.unit, json.get<double>())) : std::nullopt;
    case ParameterType::choice:
    case ParameterType::text: return json.is_string() ? std::optional<Value>(json.get<std::string>()) : std::nullopt;
    case ParameterType::vector: return lift(triple(json));
    case ParameterType::colour: return lift(colourOf(json));
    case ParameterType::curve: return lift(curveOf(json));
    case ParameterType::gradient: return lift(gradientOf(json));
  }
  return std::nullopt;
}

ordered_json colourJson(const Colour& colour) {
  if (const auto hex = hexColour(colour)) return *hex;
  return {colour.r, colour.g, colour.b};
}

}  // namespace

std::optional<Value> valueFromJson(const Parameter& row, const JsonText& json, const std::string& pointer, std::vector<Fault>& faults) {
  const ordered_json& found = json.root().at(ordered_json::json_pointer(pointer));
  const std::string remedy = "`npsee params " + std::string(row.key) + "` says what it does.";
  auto value = convert(row, found);
  if (!value) {
    faults.push_back(json.fault(pointer, std::string(row.key) + " is " + shownJson(found) + ", but must be " + std::string(wanted(row.type)) + ".", remedy));
    return std::nullopt;
  }
  if (std::string wrong = checkValue(row, *value); !wrong.empty()) {
    faults.push_back(json.fault(pointer, std::move(wrong), remedy));
    return std::nullopt;
  }
  return value;
}

ordered_json valueToJson(const Parameter& row, const Value& value) {
  switch (row.type) {
    case ParameterType::boolean: return std::get<bool>(value);
    case ParameterType::integer: return std::get<std::int64_t>(value);
    case ParameterType::number: return toUnit(row.unit, std::get<double>(value));
    case ParameterType::choice:
    case ParameterType::text: return std::get<std::string>(value);
    case ParameterType::vector: {
      const Vec3& v = std::get<Vec3>(value);
      return {v.x, v.y, v.z};
    }
    case ParameterType::colour: return colourJson(std::get<Colour>(value));
    case ParameterType::curve: {
      ordered_json out = ordered_json::array();
      for (const CurvePoint& point : std::get<Curve>(value)) out.push_back(ordered_json::array({point.at, point.value}));
      return out;
    }
    case ParameterType::gradient: {
      ordered_json out = ordered_json::array();
      for (const GradientStop& stop : std::get<Gradient>(value)) out.push_back(ordered_json::array({ordered_json(stop.at), colourJson(stop.colour)}));
      return out;
    }
  }
  return nullptr;
}

}  // namespace npsee
