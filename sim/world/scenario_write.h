#pragma once

#include "sim/world/scenario_table.h"

#include <nlohmann/json_fwd.hpp>

namespace npsee::world {

/// A structure as JSON in table order; what equals the default is left out, identities and required keys never.
nlohmann::ordered_json structJson(const Struct& table, const void* object);

}  // namespace npsee::world
