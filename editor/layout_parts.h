#pragma once

#include "editor/ui/context.h"

#include <algorithm>

namespace npsee::editor {

inline constexpr float kBar = 5.0f;  ///< width of a draggable bar, unscaled

/// A bar to drag. Returns how far, in unscaled pixels.
float splitter(const PanelContext& ui, const std::string& name, ImVec2 at, ImVec2 size, bool upright);

/// A panel: a region with padding.
template <class Draw>
void panel(const PanelContext& ui, const char* id, ImVec2 at, ImVec2 size, const Draw& draw, float padding = 10.0f) {
  ImGui::SetCursorScreenPos(at);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(padding), ui.px(std::min(padding, 4.0f))));
  ImGui::BeginChild(id, size, false, ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  draw(ui);
  ImGui::EndChild();
}

/// The panels of the mission mode, below the menu bar.
void drawMissionRegions(const PanelContext& ui);

}  // namespace npsee::editor
