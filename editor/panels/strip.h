#pragma once

#include "editor/ui/context.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace npsee::editor {

/// A strip over the whole width whose height follows its words. `draw` fills the right end, `room` pixels wide.
template <class Draw>
void strip(const PanelContext& ui, const char* id, ImU32 edge, const std::string& text, float room, const Draw& draw) {
  const float width = ImGui::GetContentRegionAvail().x, inset = ui.px(12), wrap = width - room - 2.0f * inset;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
  const float height = std::max(size.y + ui.px(14), ui.px(38));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ui.theme.raised);
  ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.line);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ui.theme.dim);
  ImGui::BeginChild(id, ImVec2(width, height), false, ImGuiWindowFlags_NoScrollbar);
  const ImVec2 at = ImGui::GetWindowPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + ui.px(4), at.y + height}, edge);
  ImGui::SetCursorPos({inset, std::floor(0.5f * (height - size.y))});
  ImGui::PushTextWrapPos(inset + wrap);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::SetCursorPos({width - room - inset + ui.px(8), std::floor(0.5f * (height - ui.px(26)))});
  draw();
  ImGui::EndChild();
  ImGui::PopStyleColor(3);
  ui.item(id);
}

}  // namespace npsee::editor
