#pragma once

#include "editor/document/time_line.h"
#include "editor/ui/controls.h"
#include "editor/ui/slider.h"

#include <functional>
#include <string>

namespace npsee::editor {

/// Buttons "to start", "step back", "play" and "step on", with a mode's own before and after the steps. `step` and `start` are said in
/// their tooltips: "frame", "burst".
void drawTransport(const PanelContext& ui, TimeLine& line, const std::string& step, const std::string& start, const std::function<void()>& before, const std::function<void()>& after);

/// The list "speed" with the speeds of playing; `of` is said in its hint: "the effect".
void drawSpeed(const PanelContext& ui, TimeLine& line, const std::string& of, float width);

/// The track of a time line, "time", as it stands on the screen.
struct TimeTrack {
  Box box;
  double duration_s = 1.0;
  float y = 0.0f;        ///< middle of its bar
  bool lit = false;      ///< under the pointer or held
  bool resting = false;  ///< the pointer has rested there long enough for a tooltip
  /// Where a moment stands, and which moment stands at a pixel; clamped.
  float x(double time_s) const;
  double time(float x) const;
};

/// Lets the track be pressed and dragged, which pauses; `bar` is how far below the box's top its bar runs, unscaled.
TimeTrack dragTrack(const PanelContext& ui, TimeLine& line, const Box& box, float bar);
/// The bar from the start to a moment.
void drawBar(const PanelContext& ui, const TimeTrack& track, double to_s, ImU32 colour);
/// Labelled marks below the bar, at whole seconds, minutes or hours, and the thumb on it.
void drawTicks(const PanelContext& ui, const TimeTrack& track);
void drawThumb(const PanelContext& ui, const TimeTrack& track, double time_s);

/// The line at the window's foot: the hint about what is under the pointer, or the last note; right the figures, and in a window the
/// time a frame takes.
void drawStatus(const PanelContext& ui, std::string figures);

}  // namespace npsee::editor
