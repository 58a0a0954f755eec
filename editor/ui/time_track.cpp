#include "editor/ui/time_track.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace npsee::editor {
namespace {

std::string times(double speed) { return shortNumber(speed) + "\u00d7"; }

/// Distance of the marks, at least `least_px` apart.
double tickStep(double duration, float width, float least_px) {
  constexpr std::array kSteps{0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0, 3600.0, 7200.0, 21600.0};
  for (const double step : kSteps)
    if (step / duration * static_cast<double>(width) >= static_cast<double>(least_px)) return step;
  return kSteps.back();
}

std::string tickText(double s) {
  char text[32];
  if (s < 60.0) return shortNumber(s);
  const int whole = static_cast<int>(s);
  if (s < 3600.0) std::snprintf(text, sizeof text, "%d:%02d", whole / 60, whole % 60);
  else std::snprintf(text, sizeof text, "%d:%02d:%02d", whole / 3600, whole / 60 % 60, whole % 60);
  return text;
}

}  // namespace

void drawTransport(const PanelContext& ui, TimeLine& line, const std::string& step, const std::string& start, const std::function<void()>& before, const std::function<void()>& after) {
  const auto button = [&](Icon icon, const char* name, const std::string& tip, bool active = false) {
    const bool clicked = iconButton(ui, icon, name, tip, active, 28);
    ImGui::SameLine();
    return clicked;
  };
  if (button(Icon::to_start, "to start", "Go to the " + start + " (0)")) line.seek(0.0);
  before();
  if (button(Icon::step_back, "step back", "One " + step + " back (comma)")) line.step(-1);
  if (button(line.playing ? Icon::pause : Icon::play, "play", line.playing ? "Pause (space)" : "Play (space)", line.playing)) line.toggle();
  if (button(Icon::step_on, "step on", "One " + step + " on (period)")) line.step(1);
  after();
}

void drawSpeed(const PanelContext& ui, TimeLine& line, const std::string& of, float width) {
  ImGui::SetNextItemWidth(width);
  if (!beginChoice(ui, "speed", times(line.speed))) {
    ui.item("speed");
    if (ui.resting("speed", "Speed of playing: seconds of " + of + " per second.")) tooltip(ui, "Speed ([ and ])");
    return;
  }
  for (const double speed : line.speeds()) {
    if (ImGui::Selectable(times(speed).c_str(), speed == line.speed)) line.speed = speed;
    ui.item("speed:" + shortNumber(speed));
  }
  ImGui::EndCombo();
}

float TimeTrack::x(double time_s) const { return box.at.x + static_cast<float>(std::clamp(time_s / duration_s, 0.0, 1.0)) * box.width; }

double TimeTrack::time(float x) const { return std::clamp(static_cast<double>((x - box.at.x) / box.width), 0.0, 1.0) * duration_s; }

TimeTrack dragTrack(const PanelContext& ui, TimeLine& line, const Box& box, float bar) {
  TimeTrack track{box, std::max(line.duration_s, 1e-6), box.at.y + ui.px(bar)};
  ImGui::SetCursorScreenPos(box.at);
  ImGui::InvisibleButton("time", ImVec2(box.width, box.height));
  ui.item("time");
  track.lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (ImGui::IsItemActive()) {
    line.playing = false;
    line.seek(track.time(ImGui::GetIO().MousePos.x));
  }
  track.resting = ui.resting("time", "Drag to any moment; it costs the same as playing.");
  return track;
}

void drawBar(const PanelContext& ui, const TimeTrack& track, double to_s, ImU32 colour) {
  const float half = ui.px(2);
  ImGui::GetWindowDrawList()->AddRectFilled({track.box.at.x, track.y - half}, {track.x(to_s), track.y + half}, colour, half);
}

void drawTicks(const PanelContext& ui, const TimeTrack& track) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double step = tickStep(track.duration_s, track.box.width, ui.px(62));
  ImGui::PushFont(ui.fonts.small);
  for (int i = 0; i * step <= track.duration_s * 1.000001; ++i) {
    const float x = std::floor(track.x(i * step)) + 0.5f;
    list.AddLine({x, track.y + ui.px(8)}, {x, track.y + ui.px(12)}, ui.theme.line);
    const std::string text = tickText(i * step);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    if (x + 0.5f * width <= track.box.right() + ui.px(8)) list.AddText({std::floor(x - 0.5f * width), std::floor(track.y + ui.px(13))}, ui.theme.dim, text.c_str());
  }
  ImGui::PopFont();
}

void drawThumb(const PanelContext& ui, const TimeTrack& track, double time_s) {
  const float x = track.x(time_s);
  ImGui::GetWindowDrawList()->AddCircleFilled({x, track.y}, ui.px(track.lit ? 7.5f : 6.5f), ui.theme.text, 20);
  ui.item("thumb:time", {x - ui.px(6), track.y - ui.px(6)}, {x + ui.px(6), track.y + ui.px(6)});
}

void drawStatus(const PanelContext& ui, std::string figures) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(22);
  if (ui.frame_ms) {
    char text[32];
    std::snprintf(text, sizeof text, "   %.1f ms", static_cast<double>(*ui.frame_ms));
    figures += text;
  }
  ImGui::PushFont(ui.fonts.small);
  rowTextRight(at.x + width, at.y, height, ui.theme.dim, figures);
  const float taken = ImGui::CalcTextSize(figures.c_str()).x + ui.px(24);
  const bool hint = !ui.state.hint.empty();
  rowText(at, width - taken, height, hint ? ui.theme.dim : ui.theme.good, hint ? ui.state.hint : ui.session.notices.note);
  ImGui::PopFont();
}

}  // namespace npsee::editor
