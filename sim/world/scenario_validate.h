#pragma once

#include <npsee/scenario.h>

#include <string>
#include <vector>

namespace npsee::world {

struct ScenarioFault {
  std::string pointer;  ///< JSON pointer as in a file of our own format
  std::string what, remedy;
};

/// Faults between values that are each within their range: names, references, places, counts. At most a hundred.
std::vector<ScenarioFault> relationFaults(const Scenario& scenario);

}  // namespace npsee::world
