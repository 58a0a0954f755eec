#include "editor/panels/actions.h"
#include "editor/panels/panels.h"
#include "editor/script/parser.h"
#include "editor/ui/controls.h"

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
    if (action.menu != menu) continue;
    if (action.rule_before) ImGui::Separator();
    const std::string label(action.label);
    const auto stroke = action.shortcut.empty() ? Expected<KeyStroke>(KeyStroke{}) : parseKeyStroke(action.shortcut);
    const std::string shortcut = action.shortcut.empty() ? std::string() : keyText(*stroke);
    const bool checked = action.checked != nullptr && action.checked(ui);
    const bool enabled = action.enabled == nullptr || action.enabled(ui);
    std::string shown = label;
    const History& history = ui.session.document.history();
    if (label == "Undo" && enabled) shown += ' ' + std::string(history.undoLabel());
    if (label == "Redo" && enabled) shown += ' ' + std::string(history.redoLabel());
    if (ImGui::MenuItem((shown + "###" + label).c_str(), shortcut.c_str(), checked, enabled)) action.run(ui);
    ui.item("item:" + label);
  }
  ImGui::EndMenu();
}

/// File name with the mark of unsaved work, at the bar's right end.
void drawTitle(const PanelContext& ui) {
  const Document& document = ui.session.document;
  const std::string name = document.name();
  const float mark = ui.px(16), right = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - ui.px(12);
  const float top = ImGui::GetWindowPos().y, height = ImGui::GetFrameHeight();
  ImGui::PushFont(ui.fonts.bold);
  const float width = ImGui::CalcTextSize(name.c_str()).x;
  const float left = std::max(ImGui::GetCursorScreenPos().x + ui.px(16), right - width - mark);
  rowText({left, top}, right - mark - left, height, ui.theme.text, name);
  ImGui::PopFont();
  if (document.dirty()) ImGui::GetWindowDrawList()->AddCircleFilled({right - ui.px(4), std::floor(top + 0.5f * height)}, ui.px(4), ui.theme.accent, 16);
  ui.item(document.dirty() ? "title:unsaved" : "title:saved", {left, top}, {right, top + height});
}

}  // namespace

void drawMenuBar(const PanelContext& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(8), std::floor(0.5f * (ui.px(30) - ImGui::GetFontSize()))));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(16), ui.px(6)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(8)));
  if (ImGui::BeginMenuBar()) {
    constexpr std::array<std::string_view, 6> kMenus{"File", "Edit", "View", "Layer", "Time", "Help"};
    for (const std::string_view menu : kMenus) drawMenu(ui, menu);
    drawTitle(ui);
    ImGui::EndMenuBar();
  }
  ImGui::PopStyleVar(3);
}

}  // namespace npsee::editor
