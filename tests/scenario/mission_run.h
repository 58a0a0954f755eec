#pragma once

#include "tests/support/process.h"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace npsee::test {

/// What `npsee mission FILE ...` left behind, its log taken apart.
struct MissionRun {
  int exit_code = 0;
  std::string out, err;
  std::vector<nlohmann::json> events;

  /// Events of a kind, in order.
  std::vector<nlohmann::json> of(const std::string& kind) const {
    std::vector<nlohmann::json> found;
    for (const auto& event : events)
      if (event.at("ev") == kind) found.push_back(event);
    return found;
  }
  std::string hash() const { return events.empty() ? std::string() : events.back().value("hash", ""); }
};

inline MissionRun missionRun(const std::string& file, std::vector<std::string> arguments = {}) {
  arguments.insert(arguments.begin(), {"mission", file});
  const ProcessResult done = npseeRun(arguments);
  MissionRun out{done.exit_code, done.out, done.err, {}};
  for (std::size_t begin = 0; begin < done.out.size();) {
    const std::size_t end = std::min(done.out.find('\n', begin), done.out.size());
    auto event = nlohmann::json::parse(done.out.substr(begin, end - begin), nullptr, false);
    if (event.is_object() && event.contains("ev")) out.events.push_back(std::move(event));
    begin = end + 1;
  }
  return out;
}

/// The acceptance mission of this name.
inline std::string acceptance(const std::string& name) { return std::string(NPSEE_SOURCE_DIR) + "/tests/scenario/acceptance/" + name + ".mission.json"; }

}  // namespace npsee::test
