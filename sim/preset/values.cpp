#include "sim/preset/values.h"

#include "sim/core/text.h"
#include "sim/preset/json_values.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>

namespace npsee {
namespace {

std::string withUnit(double in_unit, Unit unit) {
  std::string out = shortest(in_unit);
  if (!symbol(unit).empty()) out += ' ' + std::string(symbol(unit));
  return out;
}

/// What is wrong with a number against the row's hard range; `what` names the number.
std::string checkNumber(const Parameter& row, std::string_view what, double in_unit) {
  if (!std::isfinite(in_unit)) return std::string(what) + " is not a finite number.";
  const auto message = [&](std::string_view side, double limit) {
    return std::string(what) + " is " + withUnit(in_unit, row.unit) + ", " + std::string(side) + " the limit of " + withUnit(limit, row.unit) + ".";
  };
  if (in_unit > row.hard.max) return message("above", row.hard.max);
  if (in_unit < row.hard.min) return message("below", row.hard.min);
  return {};
}

std::string checkColour(const Parameter& row, const Colour& colour) {
  for (const double part : {colour.r, colour.g, colour.b})
    if (std::string wrong = checkNumber(row, std::string(row.key) + "'s component", part); !wrong.empty()) return wrong;
  return {};
}

template <class Points>
std::string checkOrder(const Parameter& row, const Points& points) {
  const std::string key(row.key);
  if (points.size() > kMaxCurvePoints)
    return key + " has " + std::to_string(points.size()) + " points, above the limit of " + std::to_string(kMaxCurvePoints) + ".";
  double last = 0.0;
  for (const auto& point : points) {
    if (!(point.at >= 0.0 && point.at <= 1.0)) return key + " has a point at " + shortest(point.at) + ", outside the life's 0 to 1.";
    if (point.at < last) return key + " has a point at " + shortest(point.at) + " after one at " + shortest(last) + "; points go in order.";
    last = point.at;
  }
  return {};
}

std::string checkText(const Parameter& row, const std::string& text) {
  if (row.type == ParameterType::choice) {
    if (std::ranges::find(row.choices, text) != row.choices.end()) return {};
    const std::vector<std::string_view> keys(row.choices.begin(), row.choices.end());
    std::string out = std::string(row.key) + " cannot be \"" + text + "\"; it is one of " + listed(keys) + ".";
    if (const auto near = nearest(text, keys)) out += " Did you mean " + std::string(*near) + "?";
    return out;
  }
  // A file could not keep it: JSON is UTF-8.
  if (!validUtf8(text)) return std::string(row.key) + " is not UTF-8 text.";
  if (static_cast<double>(text.size()) > row.hard.max)
    return std::string(row.key) + " has " + std::to_string(text.size()) + " characters, above the limit of " + shortest(row.hard.max) + ".";
  if (static_cast<double>(text.size()) < row.hard.min) return std::string(row.key) + " is empty.";
  return {};
}

Expected<Value> parsed(const Parameter& row, Value value) {
  if (std::string wrong = checkValue(row, value); !wrong.empty()) return fail(ErrorKind::usage, std::move(wrong));
  return value;
}

Expected<Value> parseNumber(const Parameter& row, std::string_view text) {
  const auto number = parseQuantity(text, row.unit);
  if (!number) return fail(ErrorKind::usage, std::string(row.key) + ": " + number.error().faults.front().what);
  return parsed(row, *number);
}

Expected<Value> parseInteger(const Parameter& row, std::string_view text) {
  const std::string_view body = trimmed(text);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(body.data(), body.data() + body.size(), number);
  if (error == std::errc::result_out_of_range) return fail(ErrorKind::usage, std::string(row.key) + " cannot be as large as " + std::string(body) + ".");
  if (error != std::errc() || end != body.data() + body.size())
    return fail(ErrorKind::usage, std::string(row.key) + ": \"" + std::string(body) + "\" is not a whole number.");
  return parsed(row, number);
}

Expected<Value> parseVector(const Parameter& row, std::string_view text) {
  const auto parts = splitAt(text, ',');
  if (parts.size() != 3) return fail(ErrorKind::usage, std::string(row.key) + ": \"" + std::string(text) + "\" is not three numbers X,Y,Z.");
  Vec3 out;
  double* const members[] = {&out.x, &out.y, &out.z};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = parseQuantity(parts[i], row.unit);
    if (!number) return fail(ErrorKind::usage, std::string(row.key) + ": " + number.error().faults.front().what);
    *members[i] = *number;
  }
  return parsed(row, out);
}

Expected<Value> parseColour(const Parameter& row, std::string_view text) {
  if (const auto hex = parseHexColour(trimmed(text))) return parsed(row, *hex);
  const auto parts = splitAt(text, ',');
  if (parts.size() == 3) {
    const auto r = parseQuantity(parts[0], Unit::none), g = parseQuantity(parts[1], Unit::none), b = parseQuantity(parts[2], Unit::none);
    if (r && g && b) return parsed(row, Colour{*r, *g, *b});
  }
  return fail(ErrorKind::usage, std::string(row.key) + ": \"" + std::string(text) + "\" is not a colour; write #rrggbb or R,G,B with each 0 to 1.");
}

/// Curves are typed as the JSON they have in a file.
Expected<Value> parsePoints(const Parameter& row, std::string_view text) {
  const auto json = JsonText::parse(text, "");
  if (!json) return fail(ErrorKind::usage, std::string(row.key) + ": \"" + std::string(text) + "\" is not a list of points such as [[0,1],[1,0]].");
  std::vector<Fault> faults;
  const auto value = valueFromJson(row, *json, "", faults);
  if (!value) return fail(ErrorKind::usage, faults.empty() ? std::string(row.key) + " is not readable." : faults.front().what);
  return *value;
}

}  // namespace

std::string checkValue(const Parameter& row, const Value& value) {
  switch (row.type) {
    case ParameterType::boolean: return {};
    case ParameterType::integer: return checkNumber(row, row.key, static_cast<double>(std::get<std::int64_t>(value)));
    case ParameterType::number: return checkNumber(row, row.key, toUnit(row.unit, std::get<double>(value)));
    case ParameterType::choice:
    case ParameterType::text: return checkText(row, std::get<std::string>(value));
    case ParameterType::vector: {
      const Vec3& v = std::get<Vec3>(value);
      for (const double part : {v.x, v.y, v.z})
        if (std::string wrong = checkNumber(row, std::string(row.key) + "'s component", part); !wrong.empty()) return wrong;
      return {};
    }
    case ParameterType::colour: return checkColour(row, std::get<Colour>(value));
    case ParameterType::curve: {
      const Curve& curve = std::get<Curve>(value);
      for (const CurvePoint& point : curve)
        if (std::string wrong = checkNumber(row, std::string(row.key) + "'s factor", point.value); !wrong.empty()) return wrong;
      return checkOrder(row, curve);
    }
    case ParameterType::gradient: {
      const Gradient& gradient = std::get<Gradient>(value);
      for (const GradientStop& stop : gradient)
        if (std::string wrong = checkColour(row, stop.colour); !wrong.empty()) return wrong;
      return checkOrder(row, gradient);
    }
  }
  return {};
}

Expected<Value> parseValue(const Parameter& row, std::string_view text) {
  switch (row.type) {
    case ParameterType::boolean: {
      const std::string_view word = trimmed(text);
      if (word == "true" || word == "yes" || word == "on" || word == "1") return Value(true);
      if (word == "false" || word == "no" || word == "off" || word == "0") return Value(false);
      return fail(ErrorKind::usage, std::string(row.key) + ": \"" + std::string(word) + "\" is neither true nor false.");
    }
    case ParameterType::integer: return parseInteger(row, text);
    case ParameterType::number: return parseNumber(row, text);
    case ParameterType::choice: return parsed(row, std::string(trimmed(text)));
    case ParameterType::text: return parsed(row, std::string(text));
    case ParameterType::vector: return parseVector(row, text);
    case ParameterType::colour: return parseColour(row, text);
    case ParameterType::curve:
    case ParameterType::gradient: return parsePoints(row, text);
  }
  return fail(ErrorKind::usage, "unknown type.");
}

std::string valueText(const Parameter& row, const Value& value, bool with_unit) {
  const std::string unit = with_unit && !symbol(row.unit).empty() ? ' ' + std::string(symbol(row.unit)) : std::string();
  switch (row.type) {
    case ParameterType::boolean: return std::get<bool>(value) ? "true" : "false";
    case ParameterType::integer: return std::to_string(std::get<std::int64_t>(value)) + unit;
    case ParameterType::number: return shortest(toUnit(row.unit, std::get<double>(value))) + unit;
    case ParameterType::choice:
    case ParameterType::text: return std::get<std::string>(value);
    case ParameterType::vector: {
      const Vec3& v = std::get<Vec3>(value);
      return shortest(v.x) + ',' + shortest(v.y) + ',' + shortest(v.z) + unit;
    }
    case ParameterType::colour: {
      const Colour& c = std::get<Colour>(value);
      if (const auto hex = hexColour(c)) return *hex;
      return shortest(c.r) + ',' + shortest(c.g) + ',' + shortest(c.b);
    }
    case ParameterType::curve:
    case ParameterType::gradient: return valueToJson(row, value).dump();
  }
  return {};
}

std::optional<std::string> hexColour(const Colour& colour) {
  static constexpr char kHex[] = "0123456789abcdef";
  std::string out = "#";
  for (const double part : {colour.r, colour.g, colour.b}) {
    const double scaled = std::round(part * 255.0);
    if (!(scaled >= 0.0 && scaled <= 255.0) || scaled / 255.0 != part) return std::nullopt;
    const auto byte = static_cast<unsigned>(scaled);
    out += kHex[byte >> 4];
    out += kHex[byte & 15];
  }
  return out;
}

std::optional<Colour> parseHexColour(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  unsigned bits = 0;
  const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, bits, 16);
  if (error != std::errc() || end != text.data() + 7) return std::nullopt;
  return Colour{((bits >> 16) & 255) / 255.0, ((bits >> 8) & 255) / 255.0, (bits & 255) / 255.0};
}

}  // namespace npsee
