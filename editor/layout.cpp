#include "editor/layout.h"

#include "editor/layout_parts.h"
#include "editor/panels/desk/sheets.h"
#include "editor/panels/compare_view.h"
#include "editor/panels/panels.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {

float splitter(const PanelContext& ui, const std::string& name, ImVec2 at, ImVec2 size, bool upright) {
  ImGui::SetCursorScreenPos(at);
  ImGui::InvisibleButton(name.c_str(), size);
  ui.item(name);
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + size.x, at.y + size.y}, lit ? ui.theme.line : ui.theme.background);
  if (lit) ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  if (!ImGui::IsItemActive()) return 0.0f;
  return (upright ? ImGui::GetIO().MouseDelta.x : ImGui::GetIO().MouseDelta.y) / ui.scale;
}

namespace {

struct Columns {
  float left = 0.0f, middle = 0.0f, right = 0.0f;
};

/// Widths in pixels: the side panels as wished, but the viewport keeps the middle.
Columns columnsOf(const PanelContext& ui, float width) {
  Columns out;
  const bool left = ui.state.show_left || ui.session.files.mode != FilePanel::Mode::closed || ui.state.show_help || sheetOpen(ui);
  const float wish = ui.session.files.mode != FilePanel::Mode::closed || ui.state.show_help || sheetOpen(ui) ? std::max(ui.state.left_width, 300.0f) : ui.state.left_width;
  if (left) out.left = std::floor(std::clamp(ui.px(wish), ui.px(180), std::max(ui.px(180), 0.26f * width)));
  if (ui.state.show_right) out.right = std::floor(std::clamp(ui.px(ui.state.right_width), ui.px(290), std::max(ui.px(290), 0.36f * width)));
  out.middle = width - out.left - out.right - ui.px(kBar) * static_cast<float>((left ? 1 : 0) + (ui.state.show_right ? 1 : 0));
  return out;
}

void drawLeft(const PanelContext& ui, ImVec2 at, ImVec2 size) {
  if (ui.session.files.mode != FilePanel::Mode::closed) return panel(ui, "files", at, size, drawFilePanel);
  if (ui.state.show_help) return panel(ui, "help", at, size, drawHelpPanel);
  if (sheetOpen(ui)) return panel(ui, "sheet", at, size, drawSheet);
  const float bar = ui.px(kBar);
  // In a low window the library keeps room for two rows of pictures.
  const float below = std::floor(std::clamp(ui.px(ui.state.template_height), ui.px(120), std::max(ui.px(120), size.y - ui.px(284))));
  panel(ui, "library", at, {size.x, size.y - below - bar}, drawLibraryPanel);
  // Downward makes the template smaller.
  ui.state.template_height = std::max(120.0f, ui.state.template_height - splitter(ui, "splitter:template", {at.x, at.y + size.y - below - bar}, {size.x, bar}, false));
  panel(ui, "template", {at.x, at.y + size.y - below}, {size.x, below}, drawTemplatePanel);
}

void drawRight(const PanelContext& ui, ImVec2 at, ImVec2 size) {
  panel(ui, "right", at, size, [](const PanelContext& inner) {
    drawLayerPanel(inner);
    drawParameterPanel(inner);
  });
}

void drawMiddle(const PanelContext& ui, ImVec2 at, ImVec2 size) {
  panel(ui, "middle", at, size, [](const PanelContext& inner) {
    drawNotices(inner);
    if (inner.session.variations.open) drawVariations(inner);
    else drawViewport(inner);
  }, 0.0f);
}

void drawRegions(const PanelContext& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float time_height = ui.px(56), status_height = ui.px(26), bar = ui.px(kBar);
  const float height = std::max(room.y - time_height - status_height, ui.px(100));
  const Columns columns = columnsOf(ui, room.x);
  float x = at.x;
  if (columns.left > 0.0f) {
    drawLeft(ui, {x, at.y}, {columns.left, height});
    ui.state.left_width += splitter(ui, "splitter:left", {x + columns.left, at.y}, {bar, height}, true);
    ui.state.left_width = std::clamp(ui.state.left_width, 180.0f, std::max(180.0f, 0.26f * room.x / ui.scale));
    x += columns.left + bar;
  }
  drawMiddle(ui, {x, at.y}, {columns.middle, height});
  x += columns.middle;
  if (columns.right > 0.0f) {
    ui.state.right_width -= splitter(ui, "splitter:right", {x, at.y}, {bar, height}, true);
    ui.state.right_width = std::clamp(ui.state.right_width, 290.0f, std::max(290.0f, 0.36f * room.x / ui.scale));
    drawRight(ui, {x + bar, at.y}, {columns.right, height});
  }
  panel(ui, "time line", {at.x, at.y + height}, {room.x, time_height}, drawTimeLine);
  panel(ui, "status", {at.x, at.y + height + time_height}, {room.x, status_height}, drawStatusLine);
}

}  // namespace

void drawLayout(const PanelContext& ui) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(8), std::floor(0.5f * (ui.px(30) - ImGui::GetFontSize()))));
  ImGui::Begin("npsee", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar(2);
  drawMenuBar(ui);
  if (ui.session.inMission()) drawMissionRegions(ui);
  else drawRegions(ui);
  ImGui::End();
}

}  // namespace npsee::editor
