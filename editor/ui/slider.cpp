#include "editor/ui/slider.h"

#include "editor/ui/controls.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace npsee::editor {
namespace {

constexpr float kDragThreshold_px = 3.0f;

bool logarithmic(const NumberSpec& spec) { return spec.scale == Scale::logarithmic && spec.slider.min > 0.0; }

/// Largest 1, 2 or 5 times a power of ten not above `size`.
double roundStep(double size) {
  const double decade = std::pow(10.0, std::floor(std::log10(size)));
  const double lead = size / decade;
  return decade * (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0);
}

double rounded(double value, double step) {
  // Dividing by a whole number keeps 0.3 from becoming 0.30000000000000004.
  return step >= 1.0 ? std::round(value / step) * step : std::round(value * std::round(1.0 / step)) / std::round(1.0 / step);
}

bool wantsTyping() {
  return ImGui::IsItemHovered() && (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) || (ImGui::GetIO().KeyCtrl && ImGui::IsMouseClicked(ImGuiMouseButton_Left)));
}

void drawTrack(const PanelContext& ui, const NumberSpec& spec, const Box& box, float thumb_x, bool lit) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = std::floor(box.at.y + 0.5f * box.height) + 0.5f, half = ui.px(2);
  list.AddRectFilled({box.at.x, y - half}, {box.right(), y + half}, ui.theme.line, half);
  // Where zero lies inside the range, the bar grows from it.
  const auto zero = static_cast<float>(std::clamp(fractionOf(spec, 0.0), 0.0, 1.0));
  const float origin = spec.slider.min < 0.0 && !logarithmic(spec) ? box.at.x + zero * box.width : box.at.x;
  const ImU32 colour = spec.changed ? ui.theme.accent : ui.theme.dim;
  list.AddRectFilled({std::min(origin, thumb_x), y - half}, {std::max(origin, thumb_x), y + half}, colour, half);
  list.AddCircleFilled({thumb_x, y}, ui.px(lit ? 7.0f : 6.0f), lit ? ui.theme.text : colour, 20);
}

/// A track was pressed: drag from the thumb, or from where the pointer is.
void press(const PanelContext& ui, const std::string& name, const NumberSpec& spec, const Box& box, float thumb_x) {
  const float x = ImGui::GetIO().MousePos.x;
  const bool on_thumb = std::abs(x - thumb_x) <= ui.px(9);
  const double start = on_thumb ? std::clamp(fractionOf(spec, spec.value), 0.0, 1.0) : static_cast<double>((x - box.at.x) / box.width);
  ui.state.drag = {name, start, x, false};
  if (!on_thumb) ui.state.click = {name, start, 0.0};
}

std::optional<double> dragged(const PanelContext& ui, const NumberSpec& spec, const Box& box) {
  UiState::Drag& drag = ui.state.drag;
  const ImGuiIO& io = ImGui::GetIO();
  if (!drag.moving && std::abs(io.MousePos.x - drag.pressed_x) < kDragThreshold_px) return std::nullopt;
  const float moved = drag.moving ? io.MouseDelta.x : io.MousePos.x - drag.pressed_x;
  drag.moving = true;
  ui.state.click = {};
  drag.fraction += static_cast<double>(moved / box.width) * (io.KeyShift ? 0.1 : 1.0);
  // Alt takes round values only, as if the track were a twelfth as long.
  return valueAt(spec, std::clamp(drag.fraction, 0.0, 1.0), io.KeyAlt && !io.KeyShift ? box.width / 12.0f : box.width, io.KeyShift);
}

/// A click on the track that did not become a double click.
std::optional<double> clicked(const PanelContext& ui, const std::string& name, const NumberSpec& spec, const Box& box) {
  UiState::Click& click = ui.state.click;
  if (click.name != name || ImGui::IsMouseDown(ImGuiMouseButton_Left)) return std::nullopt;
  click.age_s += ui.elapsed_s;
  if (click.age_s <= static_cast<double>(ImGui::GetIO().MouseDoubleClickTime)) return std::nullopt;
  const double value = valueAt(spec, click.fraction, box.width, false);
  click = {};
  return value;
}

}  // namespace

double fractionOf(const NumberSpec& spec, double value) {
  const Range& range = spec.slider;
  if (range.max <= range.min) return 0.0;
  if (logarithmic(spec)) return value <= range.min ? 0.0 : std::log(value / range.min) / std::log(range.max / range.min);
  return (value - range.min) / (range.max - range.min);
}

double valueAt(const NumberSpec& spec, double fraction, double width_px, bool fine) {
  const Range& range = spec.slider;
  const double share = std::clamp(fraction, 0.0, 1.0);
  if (share <= 0.0) return range.min;
  if (share >= 1.0) return range.max;
  const double pixels = std::max(width_px, 1.0) * (fine ? 10.0 : 1.0);
  double value = 0.0, step = 0.0;
  if (logarithmic(spec)) {
    value = range.min * std::pow(range.max / range.min, share);
    step = roundStep(value * std::log(range.max / range.min) / pixels);
  } else {
    value = range.min + share * (range.max - range.min);
    step = roundStep((range.max - range.min) / pixels);
  }
  if (spec.integer) step = std::max(step, 1.0);
  return std::clamp(rounded(value, step), range.min, range.max);
}

std::optional<double> slider(const PanelContext& ui, const std::string& name, const NumberSpec& spec, const Box& box) {
  ImGui::SetCursorScreenPos(box.at);
  ImGui::InvisibleButton(("slider:" + name).c_str(), ImVec2(box.width, box.height));
  ui.item("slider:" + name);
  const bool held = ImGui::IsItemActive();
  const double shown = held && ui.state.drag.name == name && ui.state.drag.moving ? ui.state.drag.fraction : fractionOf(spec, spec.value);
  const float thumb_x = box.at.x + static_cast<float>(std::clamp(shown, 0.0, 1.0)) * box.width;
  const float middle = box.at.y + 0.5f * box.height;
  ui.item("thumb:" + name, {thumb_x - ui.px(6), middle - ui.px(6)}, {thumb_x + ui.px(6), middle + ui.px(6)});
  drawTrack(ui, spec, box, thumb_x, held || ImGui::IsItemHovered());
  if (wantsTyping()) {
    ui.state.click = {};
    ui.state.drag = {};
    beginTyping(ui, name, {});
    return std::nullopt;
  }
  if (ImGui::IsItemActivated()) press(ui, name, spec, box, thumb_x);
  if (held && ui.state.drag.name == name) return dragged(ui, spec, box);
  return clicked(ui, name, spec, box);
}

std::optional<double> numberField(const PanelContext& ui, const std::string& name, const NumberSpec& spec, const Box& box, const std::string& prefix) {
  ImGui::SetCursorScreenPos(box.at);
  ImGui::InvisibleButton(("number:" + name).c_str(), ImVec2(box.width, box.height));
  ui.item("number:" + name);
  const bool held = ImGui::IsItemActive();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({box.at.x, box.at.y + ui.px(2)}, {box.right(), box.end().y - ui.px(2)}, held || ImGui::IsItemHovered() ? ui.theme.raised : ui.theme.background, ui.px(4));
  ImGui::PushFont(ui.fonts.numbers);
  rowText({box.at.x + ui.px(5), box.at.y}, box.width, box.height, ui.theme.dim, prefix);
  rowTextRight(box.right() - ui.px(5), box.at.y, box.height, spec.changed ? ui.theme.accent : ui.theme.text, shortNumber(spec.value));
  ImGui::PopFont();
  if (ImGui::IsItemHovered() || held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (wantsTyping()) {
    ui.state.drag = {};
    beginTyping(ui, name, shortest(spec.value));
    return std::nullopt;
  }
  if (ImGui::IsItemActivated()) ui.state.drag = {name, spec.value, ImGui::GetIO().MousePos.x, false};
  if (!held || ui.state.drag.name != name) return std::nullopt;
  UiState::Drag& drag = ui.state.drag;
  const ImGuiIO& io = ImGui::GetIO();
  if (!drag.moving && std::abs(io.MousePos.x - drag.pressed_x) < kDragThreshold_px) return std::nullopt;
  const float moved = drag.moving ? io.MouseDelta.x : io.MousePos.x - drag.pressed_x;
  drag.moving = true;
  const double per_pixel = roundStep((spec.slider.max - spec.slider.min) / 300.0) * (io.KeyShift ? 0.1 : io.KeyAlt ? 10.0 : 1.0);
  drag.fraction += static_cast<double>(moved) * per_pixel;
  return std::clamp(rounded(drag.fraction, per_pixel), spec.hard.min, spec.hard.max);
}

std::string shortNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", value);
  return text;
}

void beginTyping(const PanelContext& ui, const std::string& name, const std::string& text) { ui.state.typing = {name, text, {}, true, 0, true}; }

void refuseTyping(const PanelContext& ui, const std::string& why) {
  // A field that lost the focus cannot stay open: the message goes where it can be read.
  ui.session.notices.error = why;
  ui.state.typing.wrong = why;
  ui.state.typing.tab = 0;
  ui.state.typing.fresh = true;
}

}  // namespace npsee::editor
