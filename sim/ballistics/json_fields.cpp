#include "sim/ballistics/json_fields.h"

#include "sim/core/text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace npsee::ballistics {

using nlohmann::ordered_json;

const ordered_json& Fields::at(const std::string& pointer) const { return json_.root().at(ordered_json::json_pointer(pointer)); }

bool Fields::has(const std::string& pointer) const { return json_.root().contains(ordered_json::json_pointer(pointer)); }

void Fields::fault(const std::string& pointer, std::string what, std::string remedy) {
  // The nearest place that exists, so that the line is known where a value is missing.
  std::string place = pointer;
  while (!place.empty() && json_.line(place) == 0) place.erase(place.rfind('/'));
  Fault fault = json_.fault(place, std::move(what), std::move(remedy));
  fault.pointer = pointer;
  faults.push_back(std::move(fault));
}

void Fields::wrongType(const std::string& pointer, std::string_view wanted) {
  fault(pointer, "this is " + shownJson(at(pointer)) + ", but must be " + std::string(wanted) + '.');
}

bool Fields::missing(const std::string& pointer, bool required) {
  if (has(pointer)) return false;
  if (required) fault(pointer, "this is missing.", "Add it; docs/physics.md describes projectile files.");
  return true;
}

bool Fields::object(const std::string& pointer, const std::vector<std::string_view>& known, bool required) {
  if (!pointer.empty() && missing(pointer, required)) return false;
  if (!at(pointer).is_object()) {
    wrongType(pointer, "an object");
    return false;
  }
  for (const auto& [key, value] : at(pointer).items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    const auto near = nearest(key, known);
    fault(pointer + '/' + pointerToken(key), "there is no such key.", near ? "Did you mean " + std::string(*near) + "?" : "Known here are " + listed(known) + '.');
  }
  return true;
}

std::size_t Fields::list(const std::string& pointer) {
  if (missing(pointer, true)) return 0;
  if (at(pointer).is_array()) return at(pointer).size();
  wrongType(pointer, "a list");
  return 0;
}

std::string Fields::text(const std::string& pointer, bool required) {
  if (missing(pointer, required)) return {};
  if (at(pointer).is_string()) return at(pointer).get<std::string>();
  wrongType(pointer, "a text");
  return {};
}

std::optional<double> Fields::number(const std::string& pointer, bool required) {
  if (missing(pointer, required)) return std::nullopt;
  if (at(pointer).is_number()) return at(pointer).get<double>();
  wrongType(pointer, "a number");
  return std::nullopt;
}

std::vector<double> Fields::numbers(const std::string& pointer, bool required) {
  std::vector<double> out;
  if (missing(pointer, required)) return out;
  const ordered_json& list = at(pointer);
  if (!list.is_array()) {
    wrongType(pointer, "a list of numbers");
    return out;
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i].is_number()) out.push_back(list[i].get<double>());
    else wrongType(pointer + '/' + std::to_string(i), "a number");
  }
  return out;
}

}  // namespace npsee::ballistics
