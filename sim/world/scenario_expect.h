#pragma once

#include "sim/core/json_text.h"

#include <npsee/scenario.h>

#include <nlohmann/json_fwd.hpp>

#include <optional>

namespace npsee::world {

/// Reads one clause of `expect`; adds its faults and returns nothing where it is wrong.
///
///   { "event": "detonation", "target": "t72-1", "miss_m": {"max": 60}, "within": {"of": "t72-1", "m": 60}, "before": 120, "at_least": 2 }
///   { "not": { "event": "fire", "trajectory": "low" } }
///
/// `event`, `within`, `before`, `after`, `at_least` and `at_most` are the clause's own keys; every other key is one of the event
/// in the log and must be equal, or lie between `min` and `max`.
std::optional<Expectation> readExpectation(const JsonText& json, const nlohmann::ordered_json& clause, const std::string& pointer, std::vector<Fault>& faults);

/// The clause as it stands in a file; from its parts where it has no text.
nlohmann::ordered_json expectationJson(const Expectation& clause);

}  // namespace npsee::world
