#include "editor/mission/session.h"
#include "editor/panels/actions.h"
#include "editor/panels/panels.h"
#include "editor/ui/controls.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace npsee::editor {
namespace {

void drawMenu(const PanelContext& ui, std::string_view menu) {
  const std::string name(menu);
  const bool open = ImGui::BeginMenu(name.c_str());
  ui.item("menu:" + name);
  if (!open) return;
  for (const Action& action : actions()) {
    if (action.menu != menu || !action.here(ui)) continue;
    if (action.rule_before) ImGui::Separator();
    const std::string label(action.label);
    const bool checked = action.checked != nullptr && action.checked(ui);
    const bool enabled = action.enabled == nullptr || action.enabled(ui);
    std::string shown = label;
    if (label == "Undo" && enabled) shown += ' ' + std::string(ui.session.file().undoLabel());
    if (label == "Redo" && enabled) shown += ' ' + std::string(ui.session.file().redoLabel());
    if (ImGui::MenuItem((shown + "###" + label).c_str(), shortcutText(action).c_str(), checked, enabled)) action.run(ui);
    ui.item("item:" + label);
  }
  ImGui::EndMenu();
}

/// File name with the mark of unsaved work, at the bar's right end.
void drawTitle(const PanelContext& ui) {
  const std::string name = ui.session.file().name();
  const bool dirty = ui.session.file().dirty();
  const float mark = ui.px(16), right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - ui.px(12);
  const float top = ImGui::GetWindowPos().y, height = ImGui::GetFrameHeight();
  ImGui::PushFont(ui.fonts.bold);
  const float width = ImGui::CalcTextSize(name.c_str()).x;
  const float left = std::max(ImGui::GetCursorScreenPos().x + ui.px(16), right - width - mark);
  rowText({left, top}, right - mark - left, height, ui.theme.text, name);
  ImGui::PopFont();
  if (dirty) ImGui::GetWindowDrawList()->AddCircleFilled({right - ui.px(4), std::floor(top + 0.5f * height)}, ui.px(4), ui.theme.accent, 16);
  ui.item(dirty ? "title:unsaved" : "title:saved", {left, top}, {right, top + height});
}

/// [ Explosion | Mission ], in the bar's middle where there is room.
void drawModes(const PanelContext& ui) {
  const float top = ImGui::GetWindowPos().y, height = ImGui::GetFrameHeight();
  const char* const names[] = {"Explosion", "Mission"};
  const float widths[] = {ImGui::CalcTextSize(names[0]).x + ui.px(20), ImGui::CalcTextSize(names[1]).x + ui.px(20)};
  const float middle = ImGui::GetWindowPos().x + 0.5f * (ImGui::GetWindowWidth() - widths[0] - widths[1]);
  float x = std::floor(std::max(ImGui::GetCursorScreenPos().x + ui.px(12), middle));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = top + ui.px(4), tall = height - ui.px(8);
  list.AddRectFilled({x, y}, {x + widths[0] + widths[1], y + tall}, ui.theme.background, ui.px(4));
  for (int i = 0; i < 2; ++i) {
    const auto mode = static_cast<WorkMode>(i);
    ImGui::SetCursorScreenPos({x, y});
    if (ImGui::InvisibleButton(names[i], ImVec2(widths[i], tall))) ui.session.setMode(mode);
    ui.item(std::string("mode:") + names[i]);
    const bool on = ui.session.mode() == mode;
    if (on) list.AddRectFilled({x, y}, {x + widths[i], y + tall}, ui.theme.line, ui.px(4));
    const ImVec2 size = ImGui::CalcTextSize(names[i]);
    list.AddText({std::floor(x + 0.5f * (widths[i] - size.x)), std::floor(y + 0.5f * (tall - size.y))}, on ? ui.theme.accent : ImGui::IsItemHovered() ? ui.theme.text : ui.theme.dim, names[i]);
    x += widths[i];
  }
  ImGui::SetCursorScreenPos({x, top});
}

}  // namespace

void drawMenuBar(const PanelContext& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(8), std::floor(0.5f * (ui.px(30) - ImGui::GetFontSize()))));
  beginMenuStyle(ui);
  if (ImGui::BeginMenuBar()) {
    const std::array<std::string_view, 9> menus{"File", "Edit", "View", "Camera", ui.session.inMission() ? "Mission" : "Layer", "Design", "Time", "Export", "Help"};
    for (const std::string_view menu : menus)
      if ((menu != "Design" && menu != "Export") || !ui.session.inMission()) drawMenu(ui, menu);
    drawModes(ui);
    drawTitle(ui);
    ImGui::EndMenuBar();
  }
  endMenuStyle();
  ImGui::PopStyleVar();
}

}  // namespace npsee::editor
