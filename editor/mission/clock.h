#pragma once

#include "editor/mission/words.h"

#include <array>
#include <optional>
#include <vector>

namespace npsee::editor {

/// The time line of a mission. It holds no clock: whoever runs the editor says how much time has passed.
struct MissionClock {
  double time_s = 0.0;      ///< moment shown
  double duration_s = 0.0;  ///< end of the time line
  double speed = 1.0;       ///< mission seconds per second
  bool playing = false;
  std::vector<bool> pause_at = std::vector<bool>(static_cast<std::size_t>(kEventKinds), false);  ///< kinds at which playing stops

  static constexpr std::array kSpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0};

  /// Lets `elapsed_s` (at least 0) pass, to `limit_s` at most: how far there is something to show. Returns the index of the event at
  /// which it stopped, if it did.
  std::optional<std::size_t> advance(double elapsed_s, double limit_s, const std::vector<MissionEvent>& events);
  /// Starts or pauses; started at the very end it begins anew.
  void toggle();
  /// Moves by whole ticks on their grid and pauses.
  void step(int ticks);
  /// Clamped to the time line; keeps playing or pausing.
  void seek(double to_s);
  /// To the next (previous) event that stands on the time line, and pauses. False if there is none.
  bool seekEvent(int direction, const std::vector<MissionEvent>& events);
  void changeSpeed(int by);
  /// A new mission keeps the moment shown as far as it reaches.
  void setDuration(double duration_s);
};

}  // namespace npsee::editor
