#pragma once

#include "sim/core/json_text.h"
#include "sim/world/scenario_table.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>

namespace npsee::world {

/// Value of a scalar field from JSON; adds a fault and returns nothing where its type or range is wrong. A null means the default
/// and returns nothing without a fault.
std::optional<FieldValue> fieldFromJson(const Field& field, const JsonText& json, const nlohmann::ordered_json& value, const std::string& pointer, std::vector<Fault>& faults);

/// The JSON a scalar value has in a file; whole numbers without a decimal point.
nlohmann::ordered_json fieldToJson(const Field& field, const FieldValue& value);

/// Where to read more, for messages.
std::string fieldRemedy(const Field& field);

/// A number as JSON, without a decimal point where it is whole.
nlohmann::ordered_json tidyNumber(double value);

}  // namespace npsee::world
