#include "editor/ui/context.h"

namespace npsee::editor {
namespace {

constexpr double kTooltipDelay_s = 0.4;

}  // namespace

void PanelContext::item(const std::string& name) const { item(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax()); }

void PanelContext::item(const std::string& name, ImVec2 min, ImVec2 max) const {
  const ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 clip_min = list.GetClipRectMin(), clip_max = list.GetClipRectMax();
  items.add(name, min, max, clip_min, clip_max);
  if (items.wanted() != name) return;
  const bool outside = min.y < clip_min.y || max.y > clip_max.y;
  if (outside && ImGui::GetScrollMaxY() > 0.0f) ImGui::SetScrollFromPosY(0.5f * (min.y + max.y) - ImGui::GetWindowPos().y, 0.5f);
  items.want({});
}

bool PanelContext::resting(const std::string& name, const std::string& hint) const {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return false;
  state.hint = hint;
  if (state.hover.name != name) state.hover = {name, 0.0, true};
  state.hover.seen = true;
  return state.hover.seconds >= kTooltipDelay_s && !ImGui::IsMouseDown(ImGuiMouseButton_Left);
}

std::string parameterName(const Document& document, const Parameter& parameter) {
  return parameter.scope == Scope::burst ? std::string(parameter.key) : document.layer().name + '.' + std::string(parameter.key);
}

}  // namespace npsee::editor
