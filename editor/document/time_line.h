#pragma once

#include <span>

namespace npsee::editor {

/// What every time line does. It holds no clock: whoever runs the editor says how much time has passed, real time in a window and 1/60 s
/// a frame in scripts, so that a script always shows the same pictures.
struct TimeLine {
  /// One step moves by `grid_s`; `speeds` are chosen from, in rising order, and must outlive the time line.
  TimeLine(double grid_s, std::span<const double> speeds, bool plays) : playing(plays), grid_s_(grid_s), speeds_(speeds) {}

  double time_s = 0.0;      ///< moment shown
  double duration_s = 0.0;  ///< end of the time line
  double speed = 1.0;       ///< its seconds per second
  bool playing = false;

  std::span<const double> speeds() const { return speeds_; }
  /// Starts or pauses; started at the very end it begins anew.
  void toggle();
  /// Moves by whole steps on their grid and pauses.
  void step(int steps);
  /// Clamped to the time line; keeps playing or pausing.
  void seek(double to_s);
  /// To the next slower or faster speed.
  void changeSpeed(int by);
  /// What is shown keeps its moment as far as the new duration reaches.
  void setDuration(double duration_s);

 private:
  double grid_s_;
  std::span<const double> speeds_;
};

}  // namespace npsee::editor
