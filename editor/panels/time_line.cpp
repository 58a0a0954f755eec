#include "editor/panels/panels.h"
#include "editor/ui/time_track.h"

#include <cstdio>

namespace npsee::editor {
namespace {

std::string seconds(double s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f s", s);
  return text;
}

void drawTrack(const PanelContext& ui, const Box& box) {
  Playback& playback = ui.session.playback;
  const TimeTrack track = dragTrack(ui, playback, box, 12);
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
