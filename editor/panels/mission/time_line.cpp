#include "editor/panels/mission/panels.h"
#include "editor/ui/time_track.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {
namespace {

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
void drawMarks(const PanelContext& ui, const TimeTrack& track) {
  const Recording* recording = ui.session.mission().recording();
  if (recording == nullptr) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float base = track.y - ui.px(5);
  std::vector<Mark> columns(static_cast<std::size_t>(std::max(track.box.width, 1.0f)) + 1);
  for (const MissionEvent& event : recording->events) {
    if (!marked(event.kind)) continue;
    const auto at = static_cast<std::size_t>(track.x(event.t_s) - track.box.at.x);
    const Mark mark = markOf(ui, event.kind);
    if (mark.height > columns[at].height) columns[at] = mark;
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].height <= 0.0f) continue;
    const float x = std::floor(track.box.at.x) + static_cast<float>(i);
    list.AddRectFilled({x, base - ui.px(columns[i].height)}, {x + std::max(1.0f, std::floor(ui.px(1.5f))), base}, columns[i].colour);
  }
}

/// What is near the pointer on the track.
std::string eventsNear(const PanelContext& ui, const TimeTrack& track) {
  const Recording* recording = ui.session.mission().recording();
  if (recording == nullptr) return {};
  const double t = track.time(ImGui::GetIO().MousePos.x), reach = 4.0 * track.duration_s / static_cast<double>(track.box.width);
  std::string out = momentText(t);
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
  const TimeTrack track = dragTrack(ui, mission.clock, box, 20);
  if (track.resting) tooltip(ui, eventsNear(ui, track));
  drawBar(ui, track, track.duration_s, faded(ui.theme.line, 0.5f));
  if (mission.recording() != nullptr) drawBar(ui, track, mission.recording()->duration_s, ui.theme.line);
  drawBar(ui, track, mission.clock.time_s, ui.theme.accent);
  drawMarks(ui, track);
  drawTicks(ui, track);
  drawThumb(ui, track, mission.clock.time_s);
}

void drawEventButton(const PanelContext& ui, int direction) {
  MissionSession& mission = ui.session.mission();
  const bool back = direction < 0;
  if (iconButton(ui, back ? Icon::event_back : Icon::event_on, back ? "event back" : "event on", back ? "To the event before (shift+comma)" : "To the next event (shift+period)", false, 28) && mission.recording() != nullptr)
    mission.clock.seekEvent(direction, mission.recording()->events);
  ImGui::SameLine();
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
    if (checkEntry(eventTitle(static_cast<EventKind>(i)), on)) clock.pause_at[at] = !on;
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
  drawTransport(ui, ui.session.mission().clock, "tick", "start", [&] { drawEventButton(ui, -1); }, [&] { drawEventButton(ui, 1); });
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
  drawSpeed(ui, ui.session.mission().clock, "the mission", speed);
}

void drawMissionStatus(const PanelContext& ui) {
  const MissionSession& mission = ui.session.mission();
  std::string figures;
  if (const Recording* recording = mission.recording()) {
    const double t = mission.clock.time_s;
    const auto destroyed = std::ranges::count_if(recording->vehicles, [t](const VehicleRecord& v) { return v.destroyedAt(t); });
    std::vector<int> air;
    recording->shellsInAir(t, air);
    figures = std::to_string(air.size()) + " in the air   " + std::to_string(destroyed) + " of " + std::to_string(recording->vehicles.size()) + " destroyed";
  }
  drawStatus(ui, mission.simulating() && !mission.live() ? "simulating   " + figures : figures);
}

}  // namespace npsee::editor
