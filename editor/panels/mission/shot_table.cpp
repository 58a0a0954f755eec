#include "editor/panels/mission/panels.h"
#include "editor/ui/controls.h"
#include "sim/core/text.h"

#include <algorithm>
#include <array>

namespace npsee::editor {
namespace {

struct Column {
  ShotColumn column;
  const char *title, *tip;
  float width;       ///< unscaled
  bool right;        ///< numbers stand right
  int keep;          ///< columns of the highest number go first where there is no room
};
constexpr std::array kColumns{
    Column{ShotColumn::number, "shell", "Number of the shell", 48, true, 0},
    Column{ShotColumn::fired, "fired", "When it was fired", 66, true, 2},
    Column{ShotColumn::gun, "gun", "Gun or vehicle that fired it", 74, false, 0},
    Column{ShotColumn::mission, "mission", "Fire mission", 62, true, 5},
    Column{ShotColumn::target, "target", "Vehicle aimed at", 78, false, 1},
    Column{ShotColumn::elevation, "elev mil", "Quadrant elevation", 68, true, 0},
    Column{ShotColumn::azimuth, "az mil", "Azimuth of the tube, clockwise from north", 64, true, 0},
    Column{ShotColumn::tof, "flight", "Time of flight", 62, true, 3},
    Column{ShotColumn::apex, "apex m", "Greatest height over the muzzle", 62, true, 4},
    Column{ShotColumn::miss, "miss m", "Distance from the burst to where the target was", 62, true, 0},
};

std::string cell(const Shot& shot, ShotColumn column) {
  switch (column) {
    case ShotColumn::number: return std::to_string(shot.shell + 1);
    case ShotColumn::fired: return momentText(shot.fired_s);
    case ShotColumn::gun: return shot.gun;
    case ShotColumn::mission: return shot.mission > 0 ? std::to_string(shot.mission) : "direct";
    case ShotColumn::target: return shot.target.empty() ? "-" : shot.target;
    case ShotColumn::elevation: return withDecimals(shot.elevation_mil, 1);
    case ShotColumn::azimuth: return withDecimals(shot.azimuth_mil, 1);
    case ShotColumn::tof: return withDecimals(shot.tof_s(), 1) + " s";
    case ShotColumn::apex: return withDecimals(shot.apex_m, 0);
    case ShotColumn::miss: return shot.miss_m ? withDecimals(*shot.miss_m, 1) : "-";
  }
  return {};
}

/// The columns for which there is room.
std::vector<Column> columnsFor(const PanelContext& ui, float width) {
  std::vector<Column> out(kColumns.begin(), kColumns.end());
  const auto total = [&] {
    float sum = 0.0f;
    for (const Column& column : out) sum += ui.px(column.width + 10);
    return sum;
  };
  while (total() > width && out.size() > 4) out.erase(std::ranges::max_element(out, {}, &Column::keep));
  return out;
}

void drawHeader(const PanelContext& ui, const std::vector<Column>& columns, const ImVec2& at, float stretch) {
  MissionUi::ShotList& my = ui.state.mission.shots;
  float x = at.x;
  ImGui::PushFont(ui.fonts.small);
  for (const Column& column : columns) {
    const float width = ui.px(column.width + 10) * stretch;
    ImGui::SetCursorScreenPos({x, at.y});
    const std::string name = std::string("column:") + column.title;
    if (ImGui::InvisibleButton(name.c_str(), ImVec2(width, ui.px(22)))) {
      my.descending = my.column == static_cast<int>(column.column) && !my.descending;
      my.column = static_cast<int>(column.column);
    }
    ui.item(name);
    const bool sorted = my.column == static_cast<int>(column.column);
    const std::string title = std::string(column.title) + (sorted ? (my.descending ? " \u2193" : " \u2191") : "");
    const ImU32 colour = sorted || ImGui::IsItemHovered() ? ui.theme.text : ui.theme.dim;
    if (column.right) rowTextRight(x + width - ui.px(10), at.y, ui.px(22), colour, title);
    else rowText({x + ui.px(4), at.y}, width - ui.px(6), ui.px(22), colour, title);
    if (ui.resting(name, column.tip)) tooltip(ui, column.tip);
    x += width;
  }
  ImGui::PopFont();
}

void drawShot(const PanelContext& ui, const std::vector<Column>& columns, const Shot& shot, float stretch) {
  MissionSession& mission = ui.session.mission();
  MissionUi::ShotList& my = ui.state.mission.shots;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float full = ImGui::GetContentRegionAvail().x, height = ui.px(22);
  const std::string name = "shot:" + std::to_string(shot.shell + 1);
  if (ImGui::InvisibleButton(name.c_str(), ImVec2(full, height))) {
    my.selected = shot.shell;
    mission.clock.playing = false;
    mission.clock.seek(shot.burst_s);
  }
  ui.item(name);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    mission.clock.seek(shot.fired_s);
    mission.look(render::MissionCamera::Kind::follow, shot.shell);
  }
  ui.resting(name, "Click goes to the burst, double click follows the shell from the muzzle.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const double t = mission.clock.time_s;
  const bool flying = t >= shot.fired_s && t < shot.burst_s, past = t >= shot.fired_s;
  if (hovered || my.selected == shot.shell) list.AddRectFilled(at, {at.x + full, at.y + height}, ui.theme.raised, ui.px(3));
  if (flying) list.AddRectFilled({at.x, at.y + ui.px(4)}, {at.x + ui.px(3), at.y + height - ui.px(4)}, ui.theme.accent, ui.px(1));
  float x = at.x;
  for (const Column& column : columns) {
    const float width = ui.px(column.width + 10) * stretch;
    const ImU32 colour = !past ? ui.theme.dim : column.column == ShotColumn::miss && shot.miss_m && *shot.miss_m <= 50.0 ? ui.theme.good : ui.theme.text;
    if (column.right) {
      ImGui::PushFont(ui.fonts.numbers);
      rowTextRight(x + width - ui.px(10), at.y, height, colour, cell(shot, column.column));
      ImGui::PopFont();
    } else {
      rowText({x + ui.px(4), at.y}, width - ui.px(8), height, colour, cell(shot, column.column));
    }
    x += width;
  }
}

}  // namespace

void drawShotTable(const PanelContext& ui) {
  const MissionSession& mission = ui.session.mission();
  MissionUi::ShotList& my = ui.state.mission.shots;
  if (mission.shots().empty()) return ImGui::TextDisabled("No shot has been fired.");
  std::vector<Shot> shots = mission.shots();
  sortShots(shots, static_cast<ShotColumn>(my.column), my.descending);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x - ui.px(12);
  const auto columns = columnsFor(ui, width);
  float needed = 0.0f;
  for (const Column& column : columns) needed += ui.px(column.width + 10);
  const float stretch = std::clamp(width / needed, 1.0f, 1.4f);
  drawHeader(ui, columns, at, stretch);
  ImGui::SetCursorScreenPos({at.x, at.y + ui.px(22)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  ImGui::BeginChild("shots", ImVec2(0, 0));
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(shots.size()), ui.px(22));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) drawShot(ui, columns, shots[static_cast<std::size_t>(i)], stretch);
  ImGui::EndChild();
  ImGui::PopStyleVar();
  if (ImGui::IsWindowHovered() && ImGui::GetIO().KeyCtrl && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_C), false)) ImGui::SetClipboardText(shotsText(shots).c_str());
}

}  // namespace npsee::editor
