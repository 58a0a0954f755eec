#include "editor/document/camera_moves.h"
#include "editor/panels/actions.h"
#include "editor/panels/panels.h"
#include "editor/script/parser.h"
#include "editor/ui/controls.h"
#include "editor/ui/slider.h"

#include <algorithm>
#include <array>

namespace npsee::editor {
namespace {

/// A key and what it does; `place` for what has no key, and stands in a menu.
void line(const PanelContext& ui, const std::string& key, const std::string& text, bool place = false) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, column = ui.px(112), inset = ui.px(4);
  ImGui::PushFont(place ? ui.fonts.small : ui.fonts.numbers);
  rowText(at, column, ui.px(24), place ? ui.theme.dim : ui.theme.accent, key);
  ImGui::PopFont();
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width - column);
  ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x + column, at.y + inset}, ui.theme.text, text.c_str(), nullptr, width - column);
  ImGui::Dummy(ImVec2(width, std::max(ui.px(24), size.y + 2.0f * inset)));
}

struct MouseUse {
  const char *how, *what;
};
constexpr std::array kMouse{
    MouseUse{"Left drag", "turn the view"}, MouseUse{"Middle drag", "shift the view"}, MouseUse{"Wheel", "nearer, to the pointer"},
    MouseUse{"Double click", "type a value with a unit"}, MouseUse{"Shift+drag", "ten times finer"}, MouseUse{"Right button", "menus, template views"},
};

}  // namespace

void drawHelpPanel(const PanelContext& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  heading(ui, "Keys and mouse");
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({at.x + width - ui.px(24), at.y});
  if (iconButton(ui, Icon::cross, "close help", "Close (F1)", false, 24)) ui.state.show_help = false;
  ImGui::SetCursorScreenPos(below);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), 0));
  ImGui::BeginChild("help", ImVec2(0, 0));
  for (const MouseUse& use : kMouse) line(ui, use.how, use.what);
  if (!ui.session.inMission()) {
    const std::string step = shortNumber(keyStep_m(ui.session.radius_m()));
    heading(ui, ("Camera, " + step + " m a press").c_str());
    for (const CameraKeyInfo& info : cameraKeys()) line(ui, std::string(info.key), std::string(info.doc));
  } else {
    line(ui, "W A S D", "drive the vehicle you took over");
  }
  heading(ui, "Commands");
  for (const Action& action : actions()) {
    if (!action.here(ui)) continue;
    line(ui, action.shortcut.empty() ? std::string(action.menu) + " menu" : shortcutText(action), std::string(action.label), action.shortcut.empty());
    ui.item("key:" + std::string(action.label));
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace npsee::editor
