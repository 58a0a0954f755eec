#include "editor/panels/panels.h"
#include "editor/ui/time_track.h"
#include "sim/core/text.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {
namespace {

std::string seconds(double s) { return withDecimals(s, 2) + " s"; }

/// The ends of what is looped, to be dragged, "loop:from" and "loop:to"; drawn and pressed before the track that lies under them.
void dragRange(const PanelContext& ui, const TimeTrack& track) {
  Playback& playback = ui.session.playback;
  if (!playback.hasRange()) return;
  for (const bool first : {true, false}) {
    const float x = track.x(first ? playback.from_s : playback.to_s);
    const char* const name = first ? "loop:from" : "loop:to";
    ImGui::SetCursorScreenPos({first ? x - ui.px(9) : x, track.y - ui.px(9)});
    ImGui::InvisibleButton(name, ImVec2(ui.px(9), ui.px(18)));
    ui.item(name);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ui.resting(name, first ? "Where looping begins; drag it. Shift+L loops everything again." : "Where looping ends; drag it. Shift+L loops everything again.")) tooltip(ui, seconds(first ? playback.from_s : playback.to_s));
    if (!ImGui::IsItemActive() || !ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2.0f)) continue;
    const double at = track.time(ImGui::GetIO().MousePos.x);
    if (first) playback.from_s = std::clamp(at, 0.0, playback.to_s - Playback::kFrame_s);
    else playback.to_s = std::clamp(at, playback.from_s + Playback::kFrame_s, std::max(playback.duration_s, playback.from_s + Playback::kFrame_s));
  }
}

void drawRange(const PanelContext& ui, const TimeTrack& track) {
  const Playback& playback = ui.session.playback;
  if (!playback.hasRange()) return;
  const float from = track.x(playback.from_s), to = track.x(playback.to_s), half = ui.px(8);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({from, track.y - half}, {to, track.y + half}, faded(ui.theme.geometry, 0.16f));
  for (const float x : {from, to}) list.AddRectFilled({x - ui.px(1), track.y - half}, {x + ui.px(1), track.y + half}, ui.theme.geometry);
  const float arm = ui.px(4);
  for (const float y : {track.y - half, track.y + half - ui.px(2)}) {
    list.AddRectFilled({from, y}, {from + arm, y + ui.px(2)}, ui.theme.geometry);
    list.AddRectFilled({to - arm, y}, {to, y + ui.px(2)}, ui.theme.geometry);
  }
}

/// What happens when, as "mark:NAME" above the bar; a click goes there.
void drawMarks(const PanelContext& ui, const TimeTrack& track) {
  Playback& playback = ui.session.playback;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const Mark& mark : marksOf(ui.session.design.moments)) {
    const float x = std::floor(track.x(mark.time_s)) + 0.5f, y = track.box.at.y - ui.px(1), size = ui.px(4);
    const std::string name = "mark:" + std::string(mark.name);
    ImGui::SetCursorScreenPos({x - ui.px(6), y - ui.px(6)});
    if (ImGui::InvisibleButton(name.c_str(), ImVec2(ui.px(12), ui.px(11)))) {
      playback.playing = false;
      playback.seek(mark.time_s);
    }
    ui.item(name);
    const std::string words = std::string(mark.name) + ", " + seconds(mark.time_s);
    if (ui.resting(name, "Go to the " + words)) tooltip(ui, words);
    const ImU32 colour = ImGui::IsItemHovered() ? ui.theme.text : ui.theme.geometry;
    list.AddTriangleFilled({x - size, y - size}, {x + size, y - size}, {x, y + size}, colour);
  }
}

/// Shift and a drag over the track mark what is looped.
void sweepRange(const PanelContext& ui, const TimeTrack& track) {
  UiState& state = ui.state;
  Playback& playback = ui.session.playback;
  if (ImGui::IsItemActivated() && ImGui::GetIO().KeyShift) state.sweep_from_s = track.time(ImGui::GetIO().MousePos.x);
  if (!ImGui::IsItemActive()) state.sweep_from_s.reset();
  if (!state.sweep_from_s || !ImGui::IsMouseDragging(ImGuiMouseButton_Left, 3.0f)) return;
  const double to = track.time(ImGui::GetIO().MousePos.x);
  playback.from_s = std::min(*state.sweep_from_s, to);
  playback.to_s = std::max({*state.sweep_from_s, to, playback.from_s + Playback::kFrame_s});
}

void drawTrack(const PanelContext& ui, const Box& box) {
  Playback& playback = ui.session.playback;
  const TimeTrack place{box, std::max(playback.duration_s, 1e-6), box.at.y + ui.px(12)};
  drawMarks(ui, place);
  dragRange(ui, place);
  const TimeTrack track = dragTrack(ui, playback, box, 12);
  sweepRange(ui, track);
  drawRange(ui, track);
  drawBar(ui, track, track.duration_s, ui.theme.line);
  drawBar(ui, track, playback.time_s, ui.theme.accent);
  drawTicks(ui, track);
  drawThumb(ui, track, playback.time_s);
}

void drawEnds(const PanelContext& ui) {
  Playback& playback = ui.session.playback;
  if (iconButton(ui, Icon::to_end, "to end", "Go to the end", false, 28)) playback.seek(playback.duration_s);
  ImGui::SameLine();
  if (iconButton(ui, Icon::loop, "loop", "Start again at the end (L)", playback.loop, 28)) playback.loop = !playback.loop;
}

}  // namespace

void drawTimeLine(const PanelContext& ui) {
  Playback& playback = ui.session.playback;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x, speed_width = ui.px(84);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(2), 0));
  ImGui::SetCursorScreenPos({at.x, at.y + ui.px(6)});
  drawTransport(ui, playback, "frame", "burst", [] {}, [&] { drawEnds(ui); });
  ImGui::PopStyleVar();
  const float after = at.x + ui.px(6 * 30 + 8);
  ImGui::PushFont(ui.fonts.numbers);
  rowTextRight(after + ui.px(62), at.y, ui.px(40), ui.theme.text, seconds(playback.time_s));
  rowTextRight(right - speed_width - ui.px(12), at.y, ui.px(40), ui.theme.dim, seconds(playback.duration_s));
  ImGui::PopFont();
  const Box track{{after + ui.px(82), at.y + ui.px(7)}, right - speed_width - ui.px(92) - after - ui.px(82), ui.px(40)};
  if (track.width > ui.px(40)) drawTrack(ui, track);
  ImGui::SetCursorScreenPos({right - speed_width, at.y + ui.px(8)});
  drawSpeed(ui, playback, "the effect", speed_width);
}

void drawStatusLine(const PanelContext& ui) {
  const Explosion* const explosion = ui.session.explosion();
  drawStatus(ui, std::to_string(ui.session.alive()) + " alive of " + std::to_string(explosion != nullptr ? explosion->particleCount() : 0));
}

}  // namespace npsee::editor
