#pragma once

#include "editor/ui/context.h"
#include "editor/ui/icons.h"

#include <algorithm>
#include <string>
#include <vector>

namespace npsee::editor {

/// Square button with an icon; `active` shows it in the accent colour. Names itself "button:NAME".
bool iconButton(const PanelContext& ui, Icon icon, const std::string& name, const std::string& tooltip, bool active = false, float size = 26.0f, bool enabled = true);

/// Button with words, named "button:NAME". `primary` stands out.
bool textButton(const PanelContext& ui, const std::string& label, const std::string& name, bool primary = false);

/// A closed list that shows `label` and opens on a click; as ImGui::BeginCombo, without naming itself.
bool beginChoice(const PanelContext& ui, const std::string& id, const std::string& label, bool changed = false);

/// Heading in small capitals over a thin line, the full width, without room for controls.
void heading(const PanelContext& ui, const char* title);

/// Headings side by side of which one is chosen, each named "tab:TITLE", over a thin line. Returns the chosen one.
int tabStrip(const PanelContext& ui, const std::string& id, const std::vector<std::string>& titles, int chosen);

/// A small button that stays pressed, named "toggle:NAME". Returns true when it was clicked.
bool chip(const PanelContext& ui, const std::string& label, const std::string& name, bool on, const std::string& tooltip = {});
/// Its width.
float chipWidth(const PanelContext& ui, const std::string& label);

/// A heading that folds; named "section:TITLE". Returns true when it was clicked.
bool foldingHeading(const PanelContext& ui, const std::string& title, bool folded);

/// Text in `colour`, cut with an ellipsis at `width` pixels, middle of a row `height` high; advances nothing.
void rowText(const ImVec2& at, float width, float height, ImU32 colour, const std::string& text);

/// Text right-aligned to end at `right`.
void rowTextRight(float right, float y, float height, ImU32 colour, const std::string& text);

/// Room around and between the entries of menus. Popped with endMenuStyle().
void beginMenuStyle(const PanelContext& ui);
void endMenuStyle();
/// A menu under the button `min`..`max` that opens it, or above it where there is more room, filled by `draw` while it is open.
template <class Draw>
void dropDown(const PanelContext& ui, const char* id, ImVec2 min, ImVec2 max, const Draw& draw) {
  const float over = min.y, under = ImGui::GetIO().DisplaySize.y - max.y;
  const bool below = under > over;
  ImGui::SetNextWindowPos({min.x, below ? max.y + ui.px(2) : min.y - ui.px(2)}, ImGuiCond_Always, {0.0f, below ? 0.0f : 1.0f});
  ImGui::SetNextWindowSizeConstraints({0, 0}, {ImGui::GetIO().DisplaySize.x, std::max(over, under) - ui.px(8)});
  beginMenuStyle(ui);
  if (ImGui::BeginPopup(id)) {
    draw();
    ImGui::EndPopup();
  }
  endMenuStyle();
}
/// The menu of the right mouse button over the last item.
template <class Draw>
void contextMenu(const PanelContext& ui, const char* id, const Draw& draw) {
  beginMenuStyle(ui);
  if (ImGui::BeginPopupContextItem(id)) {
    draw();
    ImGui::EndPopup();
  }
  endMenuStyle();
}
/// An entry with a check mark; the menu stays open, since several are often changed together. True if it was clicked.
bool checkEntry(const std::string& label, bool on);

/// Tooltip of plain words, wrapped. Stands below the last item, or above it where there is no room, so that it hides neither the item nor
/// its neighbours.
void tooltip(const PanelContext& ui, const std::string& text);

/// Upper case for ASCII.
std::string capitals(std::string_view text);

}  // namespace npsee::editor
