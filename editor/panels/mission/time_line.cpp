#include "editor/panels/mission/panels.h"
#include "editor/ui/controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace npsee::editor {
namespace {

std::string times(double speed) { return shortNumber(speed) + "\u00d7"; }

void drawTransport(const PanelContext& ui) {
  MissionSession& mission = ui.session.mission();
  MissionClock& clock = mission.clock;
  static const std::vector<MissionEvent> kNone;
  const auto& events = mission.recording() != nullptr ? mission.recording()->events : kNone;
  if (iconButton(ui, Icon::to_start, "to start", "Go to the start (0)", false, 28)) clock.seek(0.0);
  ImGui::SameLine();
  if (iconButton(ui, Icon::event_back, "event back", "To the event before (shift+comma)", false, 28)) clock.seekEvent(-1, events);
  ImGui::SameLine();
  if (iconButton(ui, Icon::step_back, "step back", "One tick back (comma)", false, 28)) clock.step(-1);
  ImGui::SameLine();
  if (iconButton(ui, clock.playing ? Icon::pause : Icon::play, "play", clock.playing ? "Pause (space)" : "Play (space)", clock.playing, 28)) clock.toggle();
  ImGui::SameLine();
  if (iconButton(ui, Icon::step_on, "step on", "One tick on (period)", false, 28)) clock.step(1);
  ImGui::SameLine();
  if (iconButton(ui, Icon::event_on, "event on", "To the next event (shift+period)", false, 28)) clock.seekEvent(1, events);
}

double tickStep(double duration, float width, float least_px) {
  constexpr std::array kSteps{0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0, 3600.0, 7200.0, 21600.0};
  for (const double step : kSteps)
    if (step / duration * static_cast<double>(width) >= static_cast<double>(least_px)) return step;
  return kSteps.back();
}

std::string tickText(double s) {
  char text[32];
  if (s < 60.0) return shortNumber(s);
  if (s < 3600.0) std::snprintf(text, sizeof text, "%d:%02d", static_cast<int>(s) / 60, static_cast<int>(s) % 60);
  else std::snprintf(text, sizeof text, "%d:%02d:%02d", static_cast<int>(s) / 3600, static_cast<int>(s) / 60 % 60, static_cast<int>(s) % 60);
  return text;
}

void drawTicks(const PanelContext& ui, const Box& box, double duration) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double step = tickStep(duration, box.width, ui.px(64));
  ImGui::PushFont(ui.fonts.small);
  for (int i = 0; i * step <= duration * 1.000001; ++i) {
    const float x = std::floor(box.at.x + static_cast<float>(i * step / duration) * box.width) + 0.5f;
    list.AddLine({x, box.at.y + ui.px(28)}, {x, box.at.y + ui.px(32)}, ui.theme.line);
    const std::string text = tickText(i * step);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    if (x + 0.5f * width <= box.right() + ui.px(8)) list.AddText({std::floor(x - 0.5f * width), std::floor(box.at.y + ui.px(32))}, ui.theme.dim, text.c_str());
  }
  ImGui::PopFont();
}

struct Mark {
  ImU32 colour = 0;
  float height = 0.0f;  ///< over the track, unscaled
};
Mark markOf(const PanelContext& ui, EventKind kind) {
  using enum EventKind;
  switch (kind) {
    case destroyed: return {ui.theme.error, 13};
    case error: return {ui.theme.error, 13};
    case danger_close:
    case warning:
    case refuse: return {ui.theme.accent, 10};
    case damage: return {ui.theme.accent, 8};
    case end_of_mission: return {ui.theme.good, 11};
    case call: return {ui.theme.geometry, 11};
    case detonation: return {ui.theme.text, 7};
    default: return {ui.theme.dim, 5};
  }
}

/// One mark per pixel and kind; the tallest stand over the others.
void drawMarks(const PanelContext& ui, const Box& box, double duration) {
  const Recording* recording = ui.session.mission().recording();
  if (recording == nullptr) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float base = box.at.y + ui.px(15);
  std::vector<Mark> columns(static_cast<std::size_t>(std::max(box.width, 1.0f)) + 1);
  for (const MissionEvent& event : recording->events) {
    if (!marked(event.kind)) continue;
    const auto at = static_cast<std::size_t>(std::clamp(event.t_s / duration, 0.0, 1.0) * static_cast<double>(box.width));
    const Mark mark = markOf(ui, event.kind);
    if (mark.height > columns[at].height) columns[at] = mark;
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].height <= 0.0f) continue;
    const float x = std::floor(box.at.x) + static_cast<float>(i);
    list.AddRectFilled({x, base - ui.px(columns[i].height)}, {x + std::max(1.0f, std::floor(ui.px(1.5f))), base}, columns[i].colour);
  }
}

/// What is near the pointer on the track.
std::string eventsNear(const PanelContext& ui, const Box& box, double duration) {
  const Recording* recording = ui.session.mission().recording();
  if (recording == nullptr) return {};
  const double t = static_cast<double>((ImGui::GetIO().MousePos.x - box.at.x) / box.width) * duration, reach = 4.0 * duration / static_cast<double>(box.width);
  std::string out = momentText(std::clamp(t, 0.0, duration));
  int lines = 0;
  for (const MissionEvent& event : recording->events) {
    if (!marked(event.kind) || std::abs(event.t_s - t) > reach) continue;
    if (++lines > 6) return out + "\n...";
    out += "\n" + momentText(event.t_s) + "  " + eventSentence(event);
  }
  return out;
}

void drawTrack(const PanelContext& ui, const Box& box) {
  MissionSession& mission = ui.session.mission();
  MissionClock& clock = mission.clock;
  const double duration = std::max(clock.duration_s, 1e-6);
  ImGui::SetCursorScreenPos(box.at);
  ImGui::InvisibleButton("time", ImVec2(box.width, box.height));
  ui.item("time");
  const bool held = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  if (held) {
    clock.playing = false;
    clock.seek(static_cast<double>((ImGui::GetIO().MousePos.x - box.at.x) / box.width) * duration);
  }
  if (ui.resting("time", "Drag to any moment; it costs the same as playing.")) tooltip(ui, eventsNear(ui, box, duration));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = box.at.y + ui.px(20), half = ui.px(2);
  const auto at = [&](double t) { return box.at.x + static_cast<float>(std::clamp(t / duration, 0.0, 1.0)) * box.width; };
  const float x = at(clock.time_s);
  list.AddRectFilled({box.at.x, y - half}, {box.right(), y + half}, faded(ui.theme.line, 0.5f), half);
  if (mission.recording() != nullptr) list.AddRectFilled({box.at.x, y - half}, {at(mission.recording()->duration_s), y + half}, ui.theme.line, half);
  list.AddRectFilled({box.at.x, y - half}, {x, y + half}, ui.theme.accent, half);
  drawMarks(ui, box, duration);
  drawTicks(ui, box, duration);
  list.AddCircleFilled({x, y}, ui.px(hovered || held ? 7.5f : 6.5f), ui.theme.text, 20);
  ui.item("thumb:time", {x - ui.px(6), y - ui.px(6)}, {x + ui.px(6), y + ui.px(6)});
}

void drawSpeed(const PanelContext& ui, float width) {
  MissionClock& clock = ui.session.mission().clock;
  ImGui::SetNextItemWidth(width);
  if (!beginChoice(ui, "speed", times(clock.speed))) {
    ui.item("speed");
    if (ui.resting("speed", "Speed of playing: seconds of the mission per second.")) tooltip(ui, "Speed ([ and ])");
    return;
  }
  for (const double speed : MissionClock::kSpeeds) {
    if (ImGui::Selectable(times(speed).c_str(), speed == clock.speed)) clock.speed = speed;
    ui.item("speed:" + shortNumber(speed));
  }
  ImGui::EndCombo();
}

void drawPauseAt(const PanelContext& ui, float width) {
  MissionClock& clock = ui.session.mission().clock;
  const auto chosen = std::ranges::count(clock.pause_at, true);
  ImGui::SetNextItemWidth(width);
  const std::string label = chosen == 0 ? "no pause" : "pause at " + std::to_string(chosen);
  if (!beginChoice(ui, "pause at", label, chosen > 0)) {
    ui.item("choice:pause at");
    if (ui.resting("pause at", "Kinds of events at which playing stops.")) tooltip(ui, "Playing stops at events of the chosen kinds.");
    return;
  }
  for (int i = 0; i < kEventKinds; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool on = clock.pause_at[at];
    if (ImGui::Selectable(eventTitle(static_cast<EventKind>(i)).c_str(), on, ImGuiSelectableFlags_DontClosePopups)) clock.pause_at[at] = !on;
    ui.item("pause:" + std::string(eventKindNames()[at]));
  }
  ImGui::EndCombo();
}

}  // namespace

void drawMissionTimeLine(const PanelContext& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x, speed = ui.px(72), pause = ui.px(104), gap = ui.px(8);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(2), 0));
  ImGui::SetCursorScreenPos({at.x, at.y + ui.px(8)});
  drawTransport(ui);
  ImGui::PopStyleVar();
  const float after = at.x + ui.px(6 * 30 + 8);
  ImGui::PushFont(ui.fonts.numbers);
  rowTextRight(after + ui.px(62), at.y + ui.px(2), ui.px(40), ui.theme.text, momentText(ui.session.mission().clock.time_s));
  ImGui::PopFont();
  const Box track{{after + ui.px(82), at.y + ui.px(2)}, right - speed - pause - 2 * gap - ui.px(10) - after - ui.px(82), ui.px(48)};
  if (track.width > ui.px(40)) drawTrack(ui, track);
  ImGui::SetCursorScreenPos({right - speed - gap - pause, at.y + ui.px(10)});
  drawPauseAt(ui, pause);
  ImGui::SetCursorScreenPos({right - speed, at.y + ui.px(10)});
  drawSpeed(ui, speed);
}

void drawMissionStatus(const PanelContext& ui) {
  const MissionSession& mission = ui.session.mission();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(22);
  std::string right;
  if (const Recording* recording = mission.recording()) {
    const double t = mission.clock.time_s;
    const auto destroyed = std::ranges::count_if(recording->vehicles, [t](const VehicleRecord& v) { return v.destroyedAt(t); });
    std::vector<int> air;
    recording->shellsInAir(t, air);
    right = std::to_string(air.size()) + " in the air   " + std::to_string(destroyed) + " of " + std::to_string(recording->vehicles.size()) + " destroyed";
  }
  if (mission.simulating() && !mission.live()) right = "simulating   " + right;
  if (ui.frame_ms) {
    char text[32];
    std::snprintf(text, sizeof text, "   %.1f ms", static_cast<double>(*ui.frame_ms));
    right += text;
  }
  ImGui::PushFont(ui.fonts.small);
  rowTextRight(at.x + width, at.y, height, ui.theme.dim, right);
  const Notices& notices = ui.session.notices;
  const float taken = ImGui::CalcTextSize(right.c_str()).x + ui.px(24);
  rowText(at, width - taken, height, !ui.state.hint.empty() ? ui.theme.dim : ui.theme.good, !ui.state.hint.empty() ? ui.state.hint : notices.note);
  ImGui::PopFont();
}

}  // namespace npsee::editor
