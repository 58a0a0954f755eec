#pragma once

#include "editor/ui/context.h"
#include "editor/ui/icons.h"

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

/// Tooltip of plain words, wrapped.
void tooltip(const PanelContext& ui, const std::string& text);

/// Upper case for ASCII.
std::string capitals(std::string_view text);

}  // namespace npsee::editor
