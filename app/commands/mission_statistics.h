#pragma once

#include <npsee/recording.h>

#include <optional>
#include <string>
#include <vector>

namespace npsee::commands {

/// What one run of a mission came to, read from its event log.
struct MissionOutcome {
  std::int64_t seed = 0;
  int missions = 0, shells = 0, hostiles = 0, destroyed = 0, friendly_losses = 0, refusals = 0;
  bool expectations_met = true;
  std::optional<double> effect_rounds;     ///< adjusting rounds before the first fire for effect that was adjusted
  std::optional<double> effect_error_m;    ///< distance of the aim from the target then
  std::optional<double> first_destroyed_s;
};
MissionOutcome outcomeOf(const Recording& recording);

/// The summary of many runs, as a table for people or as JSON.
std::string statisticsText(const std::vector<MissionOutcome>& outcomes);
std::string statisticsJson(const std::vector<MissionOutcome>& outcomes);

}  // namespace npsee::commands
