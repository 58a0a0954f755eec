#pragma once

#include "editor/document/time_line.h"
#include "editor/mission/words.h"

#include <npsee/mission.h>

#include <array>
#include <optional>
#include <vector>

namespace npsee::editor {

/// The time line of a mission. One step is a tick of the simulation.
struct MissionClock : TimeLine {
  static constexpr std::array kSpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0};

  MissionClock() : TimeLine(kMissionTick_s, kSpeeds, false) {}

  std::vector<bool> pause_at = std::vector<bool>(static_cast<std::size_t>(kEventKinds), false);  ///< kinds at which playing stops

  /// Lets `elapsed_s` (at least 0) pass, to `limit_s` at most: how far there is something to show. Returns the index of the event at
  /// which it stopped, if it did.
  std::optional<std::size_t> advance(double elapsed_s, double limit_s, const std::vector<MissionEvent>& events);
  /// To the next (previous) event that stands on the time line, and pauses. False if there is none.
  bool seekEvent(int direction, const std::vector<MissionEvent>& events);
};

}  // namespace npsee::editor
