#pragma once

#include "sim/core/json_text.h"

#include <npsee/parameters.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <vector>

namespace npsee {

/// Reads and checks the value at `pointer` of `json` for a row; adds a fault and returns nothing where it is wrong.
std::optional<Value> valueFromJson(const Parameter& row, const JsonText& json, const std::string& pointer, std::vector<Fault>& faults);

/// The JSON a value has in a file.
nlohmann::ordered_json valueToJson(const Parameter& row, const Value& value);

}  // namespace npsee
