#pragma once

#include "editor/ui/context.h"

#include <optional>
#include <string>

namespace npsee::editor {

/// A number as a slider shows it, in the unit people read.
struct NumberSpec {
  double value = 0.0;
  Range slider;  ///< what the track spans
  Range hard;    ///< what may be typed
  Scale scale = Scale::linear;
  bool integer = false;
  bool changed = false;  ///< differs from its default
};

struct Box {
  ImVec2 at;
  float width = 0.0f, height = 0.0f;
  float right() const { return at.x + width; }
  ImVec2 end() const { return {at.x + width, at.y + height}; }
};

/// Place of a value on the track, 0..1, and the other way, rounded to what a pixel of `width` can tell apart (a tenth of
/// that when `fine`).
double fractionOf(const NumberSpec& spec, double value);
double valueAt(const NumberSpec& spec, double fraction, double width_px, bool fine);

/// Slider "slider:NAME" with its thumb "thumb:NAME". Drag the thumb or the track; Shift drags ten times finer, Alt takes round values only; a click on the
/// track jumps there; Ctrl-click or double click begins typing. Returns the new value while it changes.
std::optional<double> slider(const PanelContext& ui, const std::string& name, const NumberSpec& spec, const Box& box);

/// A number without a track, "number:NAME": drag sideways (Shift ten times finer, Alt ten times coarser), double click to type.
std::optional<double> numberField(const PanelContext& ui, const std::string& name, const NumberSpec& spec, const Box& box, const std::string& prefix = {});

/// Number with at most six significant digits, without trailing zeros.
std::string shortNumber(double value);

/// The text field of the value being typed, named "field:NAME". Returns the text when it is complete (Enter, or the focus went elsewhere).
/// The caller ends the typing, or refuses the text with refuseTyping().
std::optional<std::string> typingField(const PanelContext& ui, const Box& box, bool several_lines = false);
void beginTyping(const PanelContext& ui, const std::string& name, const std::string& text);
void refuseTyping(const PanelContext& ui, const std::string& why);
inline bool typingIn(const PanelContext& ui, const std::string& name) { return ui.state.typing.name == name && !name.empty(); }

}  // namespace npsee::editor
