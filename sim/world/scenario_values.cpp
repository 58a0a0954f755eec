#include "sim/world/scenario_values.h"

#include "sim/core/text.h"
#include "sim/world/scenario_files.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace npsee::world {
namespace {

using nlohmann::ordered_json;

double inUnit(const Field& field, double held) { return field.si ? toUnit(field.unit, held) : held; }
double held(const Field& field, double in_unit) { return field.si ? toSi(field.unit, in_unit) : in_unit; }

std::string withUnit(const Field& field, double in_unit) {
  std::string out = shortest(in_unit);
  if (!symbol(field.unit).empty()) out += ' ' + std::string(symbol(field.unit));
  return out;
}

/// What is wrong with a number against the hard range; `what` names it.
std::string checkNumber(const Field& field, const std::string& what, double in_unit) {
  if (!std::isfinite(in_unit)) return what + " is not a finite number.";
  if (in_unit > field.hard.max) return what + " is " + withUnit(field, in_unit) + ", above the limit of " + withUnit(field, field.hard.max) + ".";
  if (in_unit < field.hard.min) return what + " is " + withUnit(field, in_unit) + ", below the limit of " + withUnit(field, field.hard.min) + ".";
  return {};
}

std::string checkPlace(const Field& field, const std::string& what, const Place& place) {
  std::string wrong = checkNumber(field, what + "'s x", place.x_m);
  return wrong.empty() ? checkNumber(field, what + "'s z", place.z_m) : wrong;
}

std::string checkCount(const Field& field, std::size_t count) {
  const std::string key(field.key);
  if (static_cast<double>(count) > field.hard.max) return key + " has " + std::to_string(count) + " entries, above the limit of " + shortest(field.hard.max) + ".";
  if (static_cast<double>(count) < field.hard.min) return key + " is empty.";
  return {};
}

bool fitId(const std::string& id) {
  return !id.empty() && std::ranges::all_of(id, [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_'; });
}

std::string checkText(const Field& field, const std::string& text) {
  const std::string key(field.key);
  if (field.type == FieldType::choice) {
    if (std::ranges::find(field.choices, text) != field.choices.end()) return {};
    const std::vector<std::string_view> keys(field.choices.begin(), field.choices.end());
    const auto near = nearest(text, keys);
    return key + " cannot be \"" + text + "\"; it is one of " + listed(keys) + "." + (near ? " Did you mean " + std::string(*near) + "?" : "");
  }
  if (!validUtf8(text)) return key + " is not UTF-8 text.";
  if (static_cast<double>(text.size()) > field.hard.max) return key + " has " + std::to_string(text.size()) + " characters, above the limit of " + shortest(field.hard.max) + ".";
  if (static_cast<double>(text.size()) < field.hard.min) return key + " is empty.";
  if (field.type == FieldType::id && !fitId(text)) return key + " \"" + text + "\" does not fit; use letters, digits, - and _.";
  if (field.type == FieldType::file) return wrongPath(key, text);
  return {};
}

std::string checkParams(const Field& field, const Params& params) {
  if (std::string wrong = checkCount(field, params.size()); !wrong.empty()) return wrong;
  for (const auto& [name, value] : params) {
    if (name.empty() || name.size() > 40 || !fitId(name)) return "params has the name \"" + name + "\", which does not fit; use letters, digits and _.";
    if (const double* number = std::get_if<double>(&value)) {
      if (name == "axis") return "params' axis is " + shortest(*number) + ", but must be x or z.";
      if (!(std::fabs(*number) <= 1e9)) return "params' " + name + " is " + shortest(*number) + ", beyond the limit of 1e9.";
    } else if (const std::string& text = std::get<std::string>(value); name != "axis") {
      return "params' " + name + " is the text \"" + text + "\", but must be a number.";
    } else if (text != "x" && text != "z") {
      return "params' axis is \"" + text + "\", but must be x or z.";
    }
  }
  return {};
}

std::string_view wanted(FieldType type) {
  switch (type) {
    case FieldType::boolean: return "true or false";
    case FieldType::integer: return "a whole number";
    case FieldType::number: return "a number";
    case FieldType::choice:
    case FieldType::text:
    case FieldType::id:
    case FieldType::file: return "a text";
    case FieldType::place: return "a list of two numbers [x, z]";
    case FieldType::vector: return "a list of three numbers [x, y, z]";
    case FieldType::texts: return "a list of texts";
    case FieldType::places: return "a list of places [[x, z], ...]";
    case FieldType::parameters: return "an object of numbers";
    case FieldType::object: return "an object";
    case FieldType::list:
    case FieldType::expectations: return "a list of objects";
  }
  return "";
}

bool numbers(const ordered_json& json, std::size_t count) {
  return json.is_array() && json.size() == count && std::ranges::all_of(json, [](const ordered_json& part) { return part.is_number(); });
}

std::optional<FieldValue> textsOf(const ordered_json& json) {
  if (!json.is_array()) return std::nullopt;
  std::vector<std::string> out;
  for (const auto& part : json) {
    if (!part.is_string()) return std::nullopt;
    out.push_back(part.get<std::string>());
  }
  return out;
}

std::optional<FieldValue> placesOf(const ordered_json& json) {
  if (!json.is_array()) return std::nullopt;
  std::vector<Place> out;
  for (const auto& part : json) {
    if (!numbers(part, 2)) return std::nullopt;
    out.push_back({part[0].get<double>(), part[1].get<double>()});
  }
  return out;
}

std::optional<FieldValue> paramsOf(const ordered_json& json) {
  if (!json.is_object()) return std::nullopt;
  Params out;
  for (const auto& [name, value] : json.items()) {
    if (value.is_number()) out.emplace(name, value.get<double>());
    else if (value.is_string()) out.emplace(name, value.get<std::string>());
    else return std::nullopt;
  }
  return out;
}

std::optional<FieldValue> convert(const Field& field, const ordered_json& json) {
  switch (field.type) {
    case FieldType::boolean:
      if (json.is_boolean()) return json.get<bool>();
      return std::nullopt;
    case FieldType::integer:
      if (const auto whole = wholeNumber(json)) return *whole;
      return std::nullopt;
    case FieldType::number:
      if (json.is_number()) return held(field, json.get<double>());
      return std::nullopt;
    case FieldType::choice:
    case FieldType::text:
    case FieldType::id:
    case FieldType::file:
      if (json.is_string()) return json.get<std::string>();
      return std::nullopt;
    case FieldType::place:
      if (numbers(json, 2)) return Place{json[0].get<double>(), json[1].get<double>()};
      return std::nullopt;
    case FieldType::vector:
      if (numbers(json, 3)) return Vec3{json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
      return std::nullopt;
    case FieldType::texts: return textsOf(json);
    case FieldType::places: return placesOf(json);
    case FieldType::parameters: return paramsOf(json);
    case FieldType::object:
    case FieldType::list:
    case FieldType::expectations: break;
  }
  return std::nullopt;
}

Expected<FieldValue> parsed(const Field& field, FieldValue value) {
  if (std::string wrong = checkField(field, value); !wrong.empty()) return fail(ErrorKind::usage, std::move(wrong));
  return value;
}

tl::unexpected<Error> unparsed(const Field& field, std::string_view text, std::string_view form) {
  return fail(ErrorKind::usage, std::string(field.key) + ": \"" + std::string(text) + "\" is not " + std::string(form) + ".");
}

Expected<std::vector<double>> parseNumbers(const Field& field, std::string_view text, std::size_t count, std::string_view form) {
  const auto parts = splitAt(text, ',');
  if (parts.size() != count) return unparsed(field, text, form);
  std::vector<double> out;
  for (const std::string_view part : parts) {
    const auto number = parseQuantity(part, field.unit);
    if (!number) return fail(ErrorKind::usage, std::string(field.key) + ": " + number.error().faults.front().what);
    out.push_back(*number);
  }
  return out;
}

Expected<FieldValue> parseNumber(const Field& field, std::string_view text) {
  const auto number = parseQuantity(text, field.unit);
  if (!number) return fail(ErrorKind::usage, std::string(field.key) + ": " + number.error().faults.front().what);
  return parsed(field, field.si ? *number : toUnit(field.unit, *number));
}

Expected<FieldValue> parseInteger(const Field& field, std::string_view text) {
  const std::string_view body = trimmed(text);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(body.data(), body.data() + body.size(), number);
  if (error != std::errc() || end != body.data() + body.size()) return unparsed(field, body, "a whole number");
  return parsed(field, number);
}

Expected<FieldValue> parseBoolean(const Field& field, std::string_view text) {
  const std::string_view word = trimmed(text);
  if (word == "true" || word == "yes" || word == "on" || word == "1") return FieldValue(true);
  if (word == "false" || word == "no" || word == "off" || word == "0") return FieldValue(false);
  return fail(ErrorKind::usage, std::string(field.key) + ": \"" + std::string(word) + "\" is neither true nor false.");
}

Expected<FieldValue> parseTexts(const Field& field, std::string_view text) {
  std::vector<std::string> out;
  if (!trimmed(text).empty())
    for (const std::string_view part : splitAt(text, ',')) out.emplace_back(trimmed(part));
  return parsed(field, std::move(out));
}

Expected<FieldValue> parsePlaces(const Field& field, std::string_view text) {
  std::vector<Place> out;
  if (!trimmed(text).empty())
    for (const std::string_view part : splitAt(text, ';')) {
      const auto xz = parseNumbers(field, part, 2, "two numbers X,Z");
      if (!xz) return tl::unexpected<Error>(xz.error());
      out.push_back({(*xz)[0], (*xz)[1]});
    }
  return parsed(field, std::move(out));
}

std::string rangeText(const Field& field) {
  std::string out = shortest(field.hard.min) + " to " + shortest(field.hard.max);
  if (!symbol(field.unit).empty()) out += ' ' + std::string(symbol(field.unit));
  return out;
}

}  // namespace

std::string checkField(const Field& field, const FieldValue& value) {
  const std::string key(field.key);
  switch (field.type) {
    case FieldType::boolean: return {};
    case FieldType::integer: return checkNumber(field, key, static_cast<double>(std::get<std::int64_t>(value)));
    case FieldType::number: return checkNumber(field, key, inUnit(field, std::get<double>(value)));
    case FieldType::choice:
    case FieldType::text:
    case FieldType::id:
    case FieldType::file: return checkText(field, std::get<std::string>(value));
    case FieldType::place: return checkPlace(field, key, std::get<Place>(value));
    case FieldType::vector: {
      const Vec3& v = std::get<Vec3>(value);
      for (const double part : {v.x, v.y, v.z})
        if (std::string wrong = checkNumber(field, key + "'s component", part); !wrong.empty()) return wrong;
      return {};
    }
    case FieldType::texts:
      for (const std::string& text : std::get<std::vector<std::string>>(value))
        if (text.empty() || text.size() > 40 || !validUtf8(text)) return key + " has the entry \"" + text.substr(0, 60) + "\", but entries have 1 to 40 characters.";
      return checkCount(field, std::get<std::vector<std::string>>(value).size());
    case FieldType::places: {
      const auto& places = std::get<std::vector<Place>>(value);
      // Of a list of places the range counts the entries; each is checked against the world by the relations.
      for (std::size_t i = 0; i < places.size(); ++i)
        if (!std::isfinite(places[i].x_m) || !std::isfinite(places[i].z_m)) return key + "'s entry " + std::to_string(i) + " is not a finite place.";
      return checkCount(field, places.size());
    }
    case FieldType::parameters: return checkParams(field, std::get<Params>(value));
    case FieldType::object:
    case FieldType::list:
    case FieldType::expectations: break;
  }
  return {};
}

Expected<FieldValue> parseField(const Field& field, std::string_view text) {
  switch (field.type) {
    case FieldType::boolean: return parseBoolean(field, text);
    case FieldType::integer: return parseInteger(field, text);
    case FieldType::number: return parseNumber(field, text);
    case FieldType::choice:
    case FieldType::id: return parsed(field, std::string(trimmed(text)));
    case FieldType::text:
    case FieldType::file: return parsed(field, std::string(text));
    case FieldType::place: {
      const auto xz = parseNumbers(field, text, 2, "two numbers X,Z");
      if (!xz) return tl::unexpected<Error>(xz.error());
      return parsed(field, Place{(*xz)[0], (*xz)[1]});
    }
    case FieldType::vector: {
      const auto xyz = parseNumbers(field, text, 3, "three numbers X,Y,Z");
      if (!xyz) return tl::unexpected<Error>(xyz.error());
      return parsed(field, Vec3{(*xyz)[0], (*xyz)[1], (*xyz)[2]});
    }
    case FieldType::texts: return parseTexts(field, text);
    case FieldType::places: return parsePlaces(field, text);
    case FieldType::parameters:
    case FieldType::object:
    case FieldType::list:
    case FieldType::expectations: break;
  }
  return fail(ErrorKind::usage, std::string(field.key) + " holds other values; name one of them, or write JSON.");
}

std::string fieldText(const Field& field, const FieldValue& value, bool with_unit) {
  const std::string unit = with_unit && !symbol(field.unit).empty() ? ' ' + std::string(symbol(field.unit)) : std::string();
  const auto place = [](const Place& p) { return shortest(p.x_m) + ',' + shortest(p.z_m); };
  switch (field.type) {
    case FieldType::boolean: return std::get<bool>(value) ? "true" : "false";
    case FieldType::integer: return std::to_string(std::get<std::int64_t>(value)) + unit;
    case FieldType::number: return shortest(inUnit(field, std::get<double>(value))) + unit;
    case FieldType::choice:
    case FieldType::text:
    case FieldType::id:
    case FieldType::file: return std::get<std::string>(value);
    case FieldType::place: return place(std::get<Place>(value)) + unit;
    case FieldType::vector: {
      const Vec3& v = std::get<Vec3>(value);
      return shortest(v.x) + ',' + shortest(v.y) + ',' + shortest(v.z) + unit;
    }
    case FieldType::texts: {
      std::string out;
      for (const std::string& text : std::get<std::vector<std::string>>(value)) out += (out.empty() ? "" : ",") + text;
      return out;
    }
    case FieldType::places: {
      std::string out;
      for (const Place& p : std::get<std::vector<Place>>(value)) out += (out.empty() ? "" : ";") + place(p);
      return out;
    }
    case FieldType::parameters:
      if (std::get<Params>(value).empty()) return {};
      return fieldToJson(field, value).dump();
    case FieldType::object:
    case FieldType::list:
    case FieldType::expectations: break;
  }
  return {};
}

std::string allowed(const Field& field) {
  switch (field.type) {
    case FieldType::boolean: return "true or false";
    case FieldType::integer:
    case FieldType::number: return rangeText(field);
    case FieldType::choice: {
      const std::vector<std::string_view> keys(field.choices.begin(), field.choices.end());
      return "one of " + listed(keys);
    }
    case FieldType::text: return "text of " + rangeText(field) + " characters";
    case FieldType::id: return shortest(field.hard.min) + " to " + shortest(field.hard.max) + " letters, digits, - and _";
    case FieldType::file: return "a path below the mission's folder";
    case FieldType::place: return "[x, z], each " + rangeText(field);
    case FieldType::vector: return "[x, y, z], each " + rangeText(field);
    case FieldType::texts: return "up to " + shortest(field.hard.max) + " texts";
    case FieldType::places: return "up to " + shortest(field.hard.max) + " places [x, z] in m";
    case FieldType::parameters: return "an object of numbers";
    case FieldType::object: return "an object: " + std::string(field.child->name) + (field.word.empty() ? std::string() : ", or \"" + std::string(field.word) + '"');
    case FieldType::list: return shortest(field.hard.min) + " to " + shortest(field.hard.max) + " objects: " + std::string(field.child->name);
    case FieldType::expectations: return "up to " + shortest(field.hard.max) + " clauses";
  }
  return {};
}

std::optional<FieldValue> fieldFromJson(const Field& field, const JsonText& json, const ordered_json& value, const std::string& pointer, std::vector<Fault>& faults) {
  if (value.is_null()) return std::nullopt;
  auto read = convert(field, value);
  if (!read) {
    faults.push_back(json.fault(pointer, std::string(field.key) + " is " + shownJson(value) + ", but must be " + std::string(wanted(field.type)) + ".", fieldRemedy(field)));
    return std::nullopt;
  }
  if (std::string wrong = checkField(field, *read); !wrong.empty()) {
    faults.push_back(json.fault(pointer, std::move(wrong), fieldRemedy(field)));
    return std::nullopt;
  }
  return read;
}

ordered_json fieldToJson(const Field& field, const FieldValue& value) {
  const auto place = [](const Place& p) { return ordered_json::array({tidyNumber(p.x_m), tidyNumber(p.z_m)}); };
  if (const bool* flag = std::get_if<bool>(&value)) return *flag;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return *whole;
  if (const double* number = std::get_if<double>(&value)) return tidyNumber(inUnit(field, *number));
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* at = std::get_if<Place>(&value)) return place(*at);
  if (const auto* v = std::get_if<Vec3>(&value)) return ordered_json::array({tidyNumber(v->x), tidyNumber(v->y), tidyNumber(v->z)});
  ordered_json out = ordered_json::array();
  if (const auto* texts = std::get_if<std::vector<std::string>>(&value)) {
    for (const std::string& text : *texts) out.push_back(text);
  } else if (const auto* places = std::get_if<std::vector<Place>>(&value)) {
    for (const Place& p : *places) out.push_back(place(p));
  } else {
    out = ordered_json::object();
    for (const auto& [name, content] : std::get<Params>(value)) {
      if (const double* number = std::get_if<double>(&content)) out[name] = tidyNumber(*number);
      else out[name] = std::get<std::string>(content);
    }
  }
  return out;
}

std::string fieldRemedy(const Field& field) { return "`npsee params --missions " + std::string(field.key) + "` says what it does."; }

ordered_json tidyNumber(double value) {
  if (value == std::floor(value) && std::fabs(value) < 1e15) return static_cast<std::int64_t>(value);
  return value;
}

}  // namespace npsee::world
