#include "editor/panels/panels.h"
#include "editor/ui/controls.h"
#include "editor/ui/slider.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace npsee::editor {
namespace {

std::string seconds(double s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f s", s);
  return text;
}

std::string times(double speed) { return shortNumber(speed) + "\u00d7"; }

void drawTransport(const PanelContext& ui) {
  Playback& playback = ui.session.playback;
  if (iconButton(ui, Icon::to_start, "to start", "Go to the burst (0)", false, 28)) playback.seek(0.0);
  ImGui::SameLine();
  if (iconButton(ui, Icon::step_back, "step back", "One frame back (comma)", false, 28)) playback.step(-1);
  ImGui::SameLine();
  if (iconButton(ui, playback.playing ? Icon::pause : Icon::play, "play", playback.playing ? "Pause (space)" : "Play (space)", playback.playing, 28)) playback.toggle();
  ImGui::SameLine();
  if (iconButton(ui, Icon::step_on, "step on", "One frame on (period)", false, 28)) playback.step(1);
  ImGui::SameLine();
  if (iconButton(ui, Icon::to_end, "to end", "Go to the end", false, 28)) playback.seek(playback.duration_s);
  ImGui::SameLine();
  if (iconButton(ui, Icon::loop, "loop", "Start again at the end (L)", playback.loop, 28)) playback.loop = !playback.loop;
}

/// Distance of the marks below the track: 1, 2 or 5 times a power of ten, at least `least_px` apart.
double tickStep(double duration, float width, float least_px) {
  double step = 0.01;
  for (int i = 0; step / duration * static_cast<double>(width) < static_cast<double>(least_px) && i < 30; ++i) step *= i % 3 == 1 ? 2.5 : 2.0;
  return step;
}

void drawTicks(const PanelContext& ui, const Box& box, double duration) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double step = tickStep(duration, box.width, ui.px(60));
  ImGui::PushFont(ui.fonts.small);
  for (int i = 0; i * step <= duration * 1.000001; ++i) {
    const float x = std::floor(box.at.x + static_cast<float>(i * step / duration) * box.width) + 0.5f;
    list.AddLine({x, box.at.y + ui.px(20)}, {x, box.at.y + ui.px(25)}, ui.theme.line);
    const std::string text = shortNumber(i * step);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    if (x + 0.5f * width > box.right() + ui.px(8)) continue;
    list.AddText({std::floor(x - 0.5f * width), std::floor(box.at.y + ui.px(26))}, ui.theme.dim, text.c_str());
  }
  ImGui::PopFont();
}

void drawScrubber(const PanelContext& ui, const Box& box) {
  Playback& playback = ui.session.playback;
  const double duration = std::max(playback.duration_s, 1e-6);
  ImGui::SetCursorScreenPos(box.at);
  ImGui::InvisibleButton("time", ImVec2(box.width, box.height));
  ui.item("time");
  if (ImGui::IsItemActive()) {
    playback.playing = false;
    playback.seek(static_cast<double>((ImGui::GetIO().MousePos.x - box.at.x) / box.width) * duration);
  }
  ui.resting("time", "Drag to any moment; it costs the same as playing.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = box.at.y + ui.px(12), half = ui.px(2);
  const float x = box.at.x + static_cast<float>(std::clamp(playback.time_s / duration, 0.0, 1.0)) * box.width;
  list.AddRectFilled({box.at.x, y - half}, {box.right(), y + half}, ui.theme.line, half);
  list.AddRectFilled({box.at.x, y - half}, {x, y + half}, ui.theme.accent, half);
  drawTicks(ui, box, duration);
  list.AddCircleFilled({x, y}, ui.px(ImGui::IsItemHovered() || ImGui::IsItemActive() ? 7.5f : 6.5f), ui.theme.text, 20);
  ui.item("thumb:time", {x - ui.px(6), y - ui.px(6)}, {x + ui.px(6), y + ui.px(6)});
}

void drawSpeed(const PanelContext& ui, float width) {
  Playback& playback = ui.session.playback;
  ImGui::SetNextItemWidth(width);
  if (!beginChoice(ui, "speed", times(playback.speed))) {
    ui.item("speed");
    if (ui.resting("speed", "Speed of playing: seconds of the effect per second.")) tooltip(ui, "Speed ([ and ])");
    return;
  }
  for (const double speed : Playback::kSpeeds) {
    if (ImGui::Selectable(times(speed).c_str(), speed == playback.speed)) playback.speed = speed;
    ui.item("speed:" + shortNumber(speed));
  }
  ImGui::EndCombo();
}

}  // namespace

void drawTimeLine(const PanelContext& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x, speed_width = ui.px(84);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(2), 0));
  ImGui::SetCursorScreenPos({at.x, at.y + ui.px(6)});
  drawTransport(ui);
  ImGui::PopStyleVar();
  const float after = at.x + ui.px(6 * 30 + 8);
  ImGui::PushFont(ui.fonts.numbers);
  rowTextRight(after + ui.px(62), at.y, ui.px(40), ui.theme.text, seconds(ui.session.playback.time_s));
  rowTextRight(right - speed_width - ui.px(12), at.y, ui.px(40), ui.theme.dim, seconds(ui.session.playback.duration_s));
  ImGui::PopFont();
  const Box track{{after + ui.px(82), at.y + ui.px(7)}, right - speed_width - ui.px(92) - after - ui.px(82), ui.px(40)};
  if (track.width > ui.px(40)) drawScrubber(ui, track);
  ImGui::SetCursorScreenPos({right - speed_width, at.y + ui.px(8)});
  drawSpeed(ui, speed_width);
}

void drawStatusLine(const PanelContext& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(22);
  char right[96];
  const int used = std::snprintf(right, sizeof right, "%zu alive of %zu", ui.session.alive(), ui.session.explosion() != nullptr ? ui.session.explosion()->particleCount() : 0);
  if (ui.frame_ms) std::snprintf(right + used, sizeof right - static_cast<std::size_t>(used), "   %.1f ms", static_cast<double>(*ui.frame_ms));
  ImGui::PushFont(ui.fonts.small);
  const float taken = ImGui::CalcTextSize(right).x + ui.px(24);
  rowTextRight(at.x + width, at.y, height, ui.theme.dim, right);
  const Notices& notices = ui.session.notices;
  const std::string left = !ui.state.hint.empty() ? ui.state.hint : notices.note;
  rowText(at, width - taken, height, !ui.state.hint.empty() ? ui.theme.dim : ui.theme.good, left);
  ImGui::PopFont();
}

}  // namespace npsee::editor
