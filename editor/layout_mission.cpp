#include "editor/layout_parts.h"

#include "editor/panels/desk/sheets.h"
#include "editor/panels/mission/panels.h"
#include "editor/panels/panels.h"
#include "editor/ui/controls.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {
namespace {

constexpr float kLeastLeft = 180.0f, kLeastRight = 264.0f;  ///< unscaled
constexpr float kLeftShare = 0.26f, kRightShare = 0.33f;    ///< of the window at most: the viewport keeps the middle

float clampedWidth(const PanelContext& ui, float wish, float least, float most) { return std::floor(std::clamp(ui.px(wish), ui.px(least), std::max(ui.px(least), most))); }

/// Two panels one above the other with a bar between them; `below` is the wished height of the lower one, unscaled, `share` of the whole at
/// most.
template <class Upper, class Lower>
void stacked(const PanelContext& ui, const std::string& name, ImVec2 at, ImVec2 size, float& below, float share, const Upper& upper, const Lower& lower) {
  const float bar = ui.px(kBar);
  const float most = std::min(size.y - ui.px(130), share * size.y);
  const float height = std::floor(std::clamp(ui.px(below), ui.px(96), std::max(ui.px(96), most)));
  upper(at, ImVec2(size.x, size.y - height - bar));
  // Downward makes the lower one smaller.
  below = std::clamp(below - splitter(ui, "splitter:" + name, {at.x, at.y + size.y - height - bar}, {size.x, bar}, false), 96.0f, std::max(96.0f, most / ui.scale));
  lower(ImVec2(at.x, at.y + size.y - height), ImVec2(size.x, height));
}

void drawMissionLeft(const PanelContext& ui, ImVec2 at, ImVec2 size) {
  if (ui.session.files.mode != FilePanel::Mode::closed) return panel(ui, "files", at, size, drawFilePanel);
  if (ui.state.show_help) return panel(ui, "help", at, size, drawHelpPanel);
  if (sheetOpen(ui)) return panel(ui, "sheet", at, size, drawSheet);
  stacked(ui, "plan", at, size, ui.state.mission.plan_height, 0.55f, [&](ImVec2 a, ImVec2 s) { panel(ui, "objects", a, s, drawObjectsPanel); }, [&](ImVec2 a, ImVec2 s) { panel(ui, "plan", a, s, drawPlanPanel); });
}

void drawMissionMiddle(const PanelContext& ui, ImVec2 at, ImVec2 size) {
  const auto upper = [&](ImVec2 a, ImVec2 s) {
    panel(ui, "middle", a, s, [](const PanelContext& inner) {
      drawNotices(inner);
      drawMissionToolbar(inner);
      drawMissionViewport(inner);
    }, 0.0f);
  };
  stacked(ui, "log", at, size, ui.state.mission.bottom_height, 0.42f, upper, [&](ImVec2 a, ImVec2 s) { panel(ui, "bottom", a, s, drawBottomPanel); });
}

}  // namespace

void drawMissionRegions(const PanelContext& ui) {
  MissionUi& my = ui.state.mission;
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float time_height = ui.px(60), status_height = ui.px(26), bar = ui.px(kBar);
  const float height = std::max(room.y - time_height - status_height, ui.px(100));
  const bool left_shown = ui.state.show_left || ui.session.files.mode != FilePanel::Mode::closed || ui.state.show_help || sheetOpen(ui);
  const float left = left_shown ? clampedWidth(ui, my.left_width, kLeastLeft, kLeftShare * room.x) : 0.0f;
  const float right = ui.state.show_right ? clampedWidth(ui, my.right_width, kLeastRight, kRightShare * room.x) : 0.0f;
  float x = at.x;
  if (left > 0.0f) {
    drawMissionLeft(ui, {x, at.y}, {left, height});
    my.left_width += splitter(ui, "splitter:left", {x + left, at.y}, {bar, height}, true);
    my.left_width = std::clamp(my.left_width, kLeastLeft, std::max(kLeastLeft, kLeftShare * room.x / ui.scale));
    x += left + bar;
  }
  const float middle = at.x + room.x - x - (right > 0.0f ? right + bar : 0.0f);
  drawMissionMiddle(ui, {x, at.y}, {middle, height});
  x += middle;
  if (right > 0.0f) {
    my.right_width -= splitter(ui, "splitter:right", {x, at.y}, {bar, height}, true);
    my.right_width = std::clamp(my.right_width, kLeastRight, std::max(kLeastRight, kRightShare * room.x / ui.scale));
    panel(ui, "selected", {x + bar, at.y}, {right, height}, drawSelectedPanel);
  }
  panel(ui, "time line", {at.x, at.y + height}, {room.x, time_height}, drawMissionTimeLine);
  panel(ui, "status", {at.x, at.y + height + time_height}, {room.x, status_height}, drawMissionStatus);
}

}  // namespace npsee::editor
