#pragma once

#include <array>

namespace npsee::editor {

/// The time line. It holds no clock: whoever runs the editor says how much time has passed, real time in a window and 1/60 s
/// a frame in scripts, so that a script always shows the same pictures.
struct Playback {
  double time_s = 0.0;      ///< moment shown, 0 = the burst
  double duration_s = 0.0;  ///< end of the time line
  double speed = 1.0;       ///< effect seconds per second
  bool playing = true;
  bool loop = true;

  static constexpr double kFrame_s = 1.0 / 60.0;  ///< what one step moves
  static constexpr std::array kSpeeds{0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0};

  /// Lets `elapsed_s` (at least 0) pass. At the end it starts again (loop) or stops there.
  void advance(double elapsed_s);
  /// Starts or pauses; started at the very end it begins anew.
  void toggle();
  /// Moves by whole frames on the grid of 1/60 s and pauses.
  void step(int frames);
  /// Clamped to the time line; keeps playing or pausing.
  void seek(double to_s);
  /// A new effect keeps the moment shown as far as it reaches.
  void setDuration(double duration_s);
};

}  // namespace npsee::editor
