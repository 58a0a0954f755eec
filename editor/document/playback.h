#pragma once

#include "editor/document/time_line.h"

#include <array>

namespace npsee::editor {

/// The time line of an explosion: time 0 is the burst. It plays from the start, again and again.
struct Playback : TimeLine {
  static constexpr double kFrame_s = 1.0 / 60.0;  ///< what one step moves
  static constexpr std::array kSpeeds{0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0};

  Playback() : TimeLine(kFrame_s, kSpeeds, true) {}

  bool loop = true;

  /// Lets `elapsed_s` (at least 0) pass. At the end it starts again (loop) or stops there.
  void advance(double elapsed_s);
};

}  // namespace npsee::editor
