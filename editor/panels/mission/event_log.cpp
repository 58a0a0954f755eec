#include "editor/panels/mission/panels.h"
#include "editor/ui/controls.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace npsee::editor {
namespace {

ImU32 colourOf(const PanelContext& ui, EventKind kind) {
  using enum EventKind;
  switch (kind) {
    case destroyed:
    case error: return ui.theme.error;
    case danger_close:
    case warning:
    case refuse:
    case damage: return ui.theme.accent;
    case end_of_mission: return ui.theme.good;
    case call:
    case correction:
    case spot:
    case contact: return ui.theme.geometry;
    default: return ui.theme.dim;
  }
}

/// The events that pass the filter; found anew only when the recording or the filter changed.
const std::vector<int>& listed(const PanelContext& ui) {
  MissionUi::EventList& list = ui.state.mission.events;
  const MissionSession& mission = ui.session.mission();
  if (list.recording == mission.recordingNumber() && list.kinds == mission.filter.kinds && list.word == mission.filter.word) return list.shown;
  list.recording = mission.recordingNumber();
  list.kinds = mission.filter.kinds;
  list.word = mission.filter.word;
  list.shown.clear();
  list.followed = static_cast<std::size_t>(-1);  // the present moment is looked up in the new list
  const auto& events = mission.recording()->events;
  for (std::size_t i = 0; i < events.size(); ++i)
    if (mission.filter.lists(events[i])) list.shown.push_back(static_cast<int>(i));
  return list.shown;
}

void drawKindMenu(const PanelContext& ui) {
  auto& kinds = ui.session.mission().filter.kinds;
  const auto entry = [&](const char* label, const auto& shown) {
    if (checkEntry(label, false))
      for (int i = 0; i < kEventKinds; ++i) kinds[static_cast<std::size_t>(i)] = shown(static_cast<EventKind>(i));
    ui.item(std::string("item:") + label);
  };
  entry("All", [](EventKind) { return true; });
  entry("None", [](EventKind) { return false; });
  entry("What stands on the time line", [](EventKind kind) { return marked(kind); });
  ImGui::Separator();
  for (int i = 0; i < kEventKinds; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (checkEntry(eventTitle(static_cast<EventKind>(i)), kinds[at])) kinds[at] = !kinds[at];
    ui.item("toggle:kind " + std::string(eventKindNames()[at]));
  }
}

void drawFilter(const PanelContext& ui) {
  EventFilter& filter = ui.session.mission().filter;
  const auto chosen = std::ranges::count(filter.kinds, true);
  const std::string label = chosen == kEventKinds ? "All kinds" : chosen == 1 ? "1 kind" : std::to_string(chosen) + " kinds";
  if (textButton(ui, label, "event kinds")) ImGui::OpenPopup("event kinds");
  dropDown(ui, "event kinds", ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), [&] { drawKindMenu(ui); });
  ImGui::SameLine();
  ImGui::SetNextItemWidth(std::min(ImGui::GetContentRegionAvail().x, ui.px(240)));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(8), std::floor(0.5f * (ui.px(26) - ImGui::GetFontSize()))));
  ImGui::InputTextWithHint("##events", "find in the log", &filter.word);
  ImGui::PopStyleVar();
  ui.item("field:find event");
}

void drawEvent(const PanelContext& ui, int index, bool now, bool past) {
  MissionSession& mission = ui.session.mission();
  MissionUi& my = ui.state.mission;
  const MissionEvent& event = mission.recording()->events[static_cast<std::size_t>(index)];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(22);
  ImGui::PushID(index);
  if (ImGui::InvisibleButton("event", ImVec2(width, height))) {
    mission.seekEvent(static_cast<std::size_t>(index));
    my.events.selected = index;
    my.events.followed = static_cast<std::size_t>(index);  // it stands where it was clicked
    const std::string target = event.text("target");
    if (!target.empty() && exists(mission.document.scenario(), {ObjectRef::Kind::vehicle, target}) && mission.document.selected().kind == ObjectRef::Kind::mission) mission.document.select({ObjectRef::Kind::vehicle, target});
  }
  ImGui::PopID();
  const std::string name = "event:" + std::to_string(index + 1);
  ui.item(name);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool chosen = my.events.selected == index;
  if (chosen || ImGui::IsItemHovered()) list.AddRectFilled(at, {at.x + width, at.y + height}, ui.theme.raised, ui.px(3));
  if (now) list.AddRectFilled({at.x, at.y + ui.px(4)}, {at.x + ui.px(3), at.y + height - ui.px(4)}, ui.theme.accent, ui.px(1));
  const std::string sentence = eventSentence(event);
  const ObjectRef& selected = mission.document.selected();
  const bool about = selected.kind != ObjectRef::Kind::mission && names(event, selected.id);
  ImGui::PushFont(ui.fonts.numbers);
  rowTextRight(at.x + ui.px(70), at.y, height, ui.theme.dim, momentText(event.t_s));
  ImGui::PopFont();
  list.AddCircleFilled({at.x + ui.px(84), at.y + 0.5f * height}, ui.px(3.5f), past ? colourOf(ui, event.kind) : faded(colourOf(ui, event.kind), 0.45f), 12);
  rowText({at.x + ui.px(96), at.y}, width - ui.px(100), height, !past ? ui.theme.dim : about ? ui.theme.accent : ui.theme.text, sentence);
  const std::string reason = eventReason(event);
  if (ui.resting(name, reason.empty() ? sentence : "Click for why it was decided.")) tooltip(ui, reason.empty() ? sentence : sentence + "\n\n" + reason);
}

/// Keeps the newest event in sight while time passes.
void follow(const PanelContext& ui, const std::vector<int>& shown, float row) {
  MissionUi::EventList& list = ui.state.mission.events;
  const auto last = ui.session.mission().lastEvent();
  const std::size_t now = last ? *last : 0;
  if (list.followed == now) return;
  list.followed = now;
  const auto line = std::ranges::upper_bound(shown, static_cast<int>(now)) - shown.begin();
  const float y = static_cast<float>(line) * row, room = ImGui::GetWindowHeight();
  // Scrolled only when it has left the view, so that the list does not swim.
  if (y - row < ImGui::GetScrollY() || y > ImGui::GetScrollY() + room) ImGui::SetScrollY(std::max(0.0f, std::floor((y - 0.6f * room) / row) * row));
}

}  // namespace

void drawEventLog(const PanelContext& ui) {
  MissionSession& mission = ui.session.mission();
  drawFilter(ui);
  ImGui::Dummy(ImVec2(1, ui.px(1)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  // A whole number of rows, so that none is cut.
  const float row = ui.px(22);
  ImGui::BeginChild("events", ImVec2(0, std::max(row, std::floor(ImGui::GetContentRegionAvail().y / row) * row)));
  if (mission.recording() == nullptr || mission.recording()->events.empty()) {
    ImGui::TextDisabled("Nothing has happened.");
  } else {
    const auto& shown = listed(ui);
    if (shown.empty()) ImGui::TextDisabled("No event passes the filter.");
    follow(ui, shown, row);
    const auto last = mission.lastEvent();
    // A script that asks for an event by name finds it although it is not drawn yet.
    if (const std::string& wanted = ui.items.wanted(); wanted.starts_with("event:")) {
      int number = 0;
      std::from_chars(wanted.data() + 6, wanted.data() + wanted.size(), number);
      const auto line = std::ranges::find(shown, number - 1);
      if (line != shown.end()) ImGui::SetScrollY(std::max(0.0f, static_cast<float>(line - shown.begin()) * row - 0.4f * ImGui::GetWindowHeight()));
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(shown.size()), row);
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        const int index = shown[static_cast<std::size_t>(i)];
        const bool past = last && static_cast<std::size_t>(index) <= *last;
        const bool now = past && (i + 1 == static_cast<int>(shown.size()) || static_cast<std::size_t>(shown[static_cast<std::size_t>(i) + 1]) > *last);
        drawEvent(ui, index, now, past);
      }
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace npsee::editor
