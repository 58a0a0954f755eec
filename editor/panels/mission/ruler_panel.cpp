#include "editor/panels/mission/panels.h"
#include "editor/ui/controls.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace npsee::editor {
namespace {

std::string mils(double value) { return std::to_string(std::lround(value)) + " mil"; }

void figure(const PanelContext& ui, const ImVec2& at, float width, const char* label, const std::string& value, ImU32 colour) {
  rowText(at, width, ui.px(22), ui.theme.dim, label);
  ImGui::PushFont(ui.fonts.numbers);
  rowTextRight(at.x + width, at.y, ui.px(22), colour, value);
  ImGui::PopFont();
}

/// The ground between the two points with the line of sight over it.
void drawProfile(const PanelContext& ui, const Box& box, const Ruler& ruler, const RulerReading& reading) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(box.at, box.end(), ui.theme.background, ui.px(4));
  const auto& heights = reading.profile;
  const auto [least, most] = std::ranges::minmax(heights, {}, &ProfilePoint::surface_m);
  const double eye = heights.front().surface_m + ruler.eye_m, target = heights.back().surface_m + ruler.target_m;
  const double low = least.surface_m, high = std::max({most.surface_m, eye, target}), span = std::max(high - low, 5.0);
  const float top = box.at.y + ui.px(16), bottom = box.end().y - ui.px(18), left = box.at.x + ui.px(8), right = box.right() - ui.px(8);
  const auto pixel = [&](double share, double height) {
    return ImVec2(left + static_cast<float>(share) * (right - left), bottom - static_cast<float>((height - low) / span) * (bottom - top));
  };
  const auto count = static_cast<double>(heights.size() - 1);
  // Strips that share an edge would show it if each were smoothed by itself.
  const ImDrawListFlags flags = list.Flags;
  list.Flags &= ~ImDrawListFlags_AntiAliasedFill;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    const ImVec2 p = pixel(static_cast<double>(i) / count, heights[i].surface_m), q = pixel(static_cast<double>(i + 1) / count, heights[i + 1].surface_m);
    list.AddQuadFilled(p, q, {q.x, bottom}, {p.x, bottom}, ui.theme.raised);
    list.AddLine(p, q, ui.theme.dim, ui.px(1.2f));
  }
  list.Flags = flags;
  const ImU32 colour = reading.sight.clear ? ui.theme.good : ui.theme.error;
  const ImVec2 from = pixel(0.0, eye), to = pixel(1.0, target);
  list.AddLine(from, to, colour, ui.px(1.5f));
  list.AddCircleFilled(from, ui.px(3), colour, 12);
  list.AddCircleFilled(to, ui.px(3), colour, 12);
  if (reading.level_m > 0.0) {
    const double share = std::clamp(reading.sight.worst_m / reading.level_m, 0.0, 1.0);
    const ImVec2 worst = pixel(share, eye + share * (target - eye));
    list.AddCircle(worst, ui.px(5), colour, 16, ui.px(1.3f));
  }
  ImGui::PushFont(ui.fonts.small);
  char text[96];
  std::snprintf(text, sizeof text, "%.0f m", high);
  list.AddText({left, box.at.y + ui.px(1)}, ui.theme.dim, text);
  std::snprintf(text, sizeof text, "%.0f m", low);
  list.AddText({left, bottom + ui.px(2)}, ui.theme.dim, text);
  const std::string distance = distanceText(reading.level_m);
  list.AddText({right - ImGui::CalcTextSize(distance.c_str()).x, bottom + ui.px(2)}, ui.theme.dim, distance.c_str());
  ImGui::PopFont();
  ui.item("profile", box.at, box.end());
}

}  // namespace

void drawRulerPanel(const PanelContext& ui) {
  MissionSession& mission = ui.session.mission();
  Ruler& ruler = mission.ruler;
  if (!ruler.complete() || mission.recording() == nullptr) {
    ImGui::TextDisabled("%s", ruler.points == 1 ? "Click the second point." : ruler.active ? "Click two points of the ground, in the picture or in the plan." : "Switch the ruler on (M), then click two points of the ground.");
    return;
  }
  const Terrain& terrain = mission.recording()->terrain;
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const RulerReading r = readRuler(ruler, terrain, std::clamp(static_cast<int>(room.x / 2.0f), 64, 800));
  const float column = std::min(ui.px(210), 0.45f * room.x), row = ui.px(20);
  char text[64];
  std::snprintf(text, sizeof text, "%+.1f m", r.height_m);
  const ImU32 plain = ui.theme.text;
  figure(ui, at, column, "Distance", distanceText(r.level_m), plain);
  figure(ui, {at.x, at.y + row}, column, "Along the slope", distanceText(r.slope_m), plain);
  figure(ui, {at.x, at.y + 2 * row}, column, "Azimuth", mils(r.azimuth_mil) + ", back " + std::to_string(std::lround(r.back_azimuth_mil)), plain);
  figure(ui, {at.x, at.y + 3 * row}, column, "Elevation", mils(r.elevation_mil), plain);
  figure(ui, {at.x, at.y + 4 * row}, column, "Height", text, plain);
  const std::string sight = r.sight.clear ? "clear by " + distanceText(r.sight.clearance_m) : "blocked at " + distanceText(r.sight.worst_m) + ", " + distanceText(-r.sight.clearance_m) + " too low";
  ImGui::PushFont(ui.fonts.small);
  rowText({at.x, at.y + 5 * row}, column, row, r.sight.clear ? ui.theme.good : ui.theme.error, "Sight " + sight);
  ImGui::PopFont();
  drawProfile(ui, {{at.x + column + ui.px(14), at.y}, std::max(room.x - column - ui.px(14), 1.0f), std::max(room.y - ui.px(2), ui.px(40))}, ruler, r);
}

}  // namespace npsee::editor
