#pragma once

#include "editor/document/time_line.h"

#include <array>

namespace npsee::editor {

/// The time line of an explosion: time 0 is the burst. It plays from the start, again and again.
struct Playback : TimeLine {
  static constexpr double kFrame_s = 1.0 / 60.0;  ///< what one step moves
  static constexpr std::array kSpeeds{0.01, 0.02, 0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0};

  Playback() : TimeLine(kFrame_s, kSpeeds, true) {}

  bool loop = true;
  double from_s = 0.0, to_s = 0.0;  ///< what is looped; all where it is empty

  bool hasRange() const { return to_s > from_s; }
  /// Begins or ends the range at a moment; the other end is the time line's where there is none, or where it would lie on the wrong side.
  void beginRange(double at_s);
  void endRange(double at_s);
  void clearRange() { from_s = to_s = 0.0; }

  /// Lets `elapsed_s` (at least 0) pass. At the end, of the range where it is inside or before it, it starts again (loop) or stops.
  void advance(double elapsed_s);
};

}  // namespace npsee::editor
