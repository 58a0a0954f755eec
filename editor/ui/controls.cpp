#include "editor/ui/controls.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace npsee::editor {

bool iconButton(const PanelContext& ui, Icon icon, const std::string& name, const std::string& tip, bool active, float size, bool enabled) {
  const std::string full = "button:" + name;
  ImGui::BeginDisabled(!enabled);
  const bool clicked = ImGui::InvisibleButton(full.c_str(), ImVec2(ui.px(size), ui.px(size)));
  ImGui::EndDisabled();
  ui.item(full);
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool hovered = ImGui::IsItemHovered() && enabled;
  if (hovered) list.AddRectFilled(min, max, ImGui::IsItemActive() ? ui.theme.line : ui.theme.raised, ui.px(4));
  const ImU32 colour = !enabled ? faded(ui.theme.dim, 0.4f) : active ? ui.theme.accent : hovered ? ui.theme.text : ui.theme.dim;
  drawIcon(list, icon, {0.5f * (min.x + max.x), 0.5f * (min.y + max.y)}, ui.px(size * 0.5f), colour);
  if (ui.resting(full, tip)) tooltip(ui, tip);
  return clicked && enabled;
}

bool textButton(const PanelContext& ui, const std::string& label, const std::string& name, bool primary) {
  const std::string full = "button:" + name;
  if (primary) {
    ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, faded(ui.theme.accent, 0.85f));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, faded(ui.theme.accent, 0.7f));
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.dark ? ui.theme.background : ui.theme.panel);
  }
  const bool clicked = ImGui::Button((label + "##" + full).c_str(), ImVec2(0, ui.px(26)));
  if (primary) ImGui::PopStyleColor(4);
  ui.item(full);
  return clicked;
}

namespace {

/// The text, or its beginning with an ellipsis, no wider than `width`.
std::string shortened(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  std::string out = text;
  do {
    // A sign of several bytes goes as a whole.
    while (!out.empty() && (static_cast<unsigned char>(out.back()) & 0xC0) == 0x80) out.pop_back();
    if (!out.empty()) out.pop_back();
  } while (!out.empty() && ImGui::CalcTextSize((out + "\u2026").c_str()).x > width);
  return out + "\u2026";
}

}  // namespace

bool beginChoice(const PanelContext& ui, const std::string& id, const std::string& label, bool changed) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(8), std::floor(0.5f * (ui.px(24) - ImGui::GetFontSize()))));
  ImGui::PushStyleColor(ImGuiCol_Text, changed ? ui.theme.accent : ui.theme.text);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::CalcItemWidth();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool open = ImGui::BeginCombo(("##" + id).c_str(), shortened(label, width - ui.px(30)).c_str(), ImGuiComboFlags_HeightLarge | ImGuiComboFlags_NoArrowButton);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  drawIcon(list, Icon::chevron_down, {at.x + width - ui.px(13), at.y + ui.px(12)}, ui.px(9), ui.theme.dim);
  return open;
}

void heading(const PanelContext& ui, const char* title) {
  ImGui::PushFont(ui.fonts.small);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(26);
  rowText(at, width, height, ui.theme.dim, capitals(title));
  ImGui::GetWindowDrawList()->AddLine({at.x, at.y + height - 1}, {at.x + width, at.y + height - 1}, ui.theme.line);
  ImGui::PopFont();
  ImGui::Dummy(ImVec2(width, height));
}

int tabStrip(const PanelContext& ui, const std::string& id, const std::vector<std::string>& titles, int chosen) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(26);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushID(id.c_str());
  ImGui::PushFont(ui.fonts.small);
  list.AddLine({at.x, at.y + height - 1}, {at.x + width, at.y + height - 1}, ui.theme.line);
  float x = at.x;
  for (int i = 0; i < static_cast<int>(titles.size()); ++i) {
    const std::string text = capitals(titles[static_cast<std::size_t>(i)]), full = "tab:" + titles[static_cast<std::size_t>(i)];
    const float taken = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorScreenPos({x, at.y});
    if (ImGui::InvisibleButton(full.c_str(), ImVec2(taken + ui.px(6), height))) chosen = i;
    ui.item(full);
    const bool on = i == chosen;
    rowText({x, at.y}, taken + ui.px(4), height, on || ImGui::IsItemHovered() ? ui.theme.text : ui.theme.dim, text);
    if (on) list.AddRectFilled({x, at.y + height - ui.px(2)}, {x + taken, at.y + height}, ui.theme.accent);
    x += taken + ui.px(18);
  }
  ImGui::PopFont();
  ImGui::PopID();
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy(ImVec2(width, height));
  return chosen;
}

float chipWidth(const PanelContext& ui, const std::string& label) {
  ImGui::PushFont(ui.fonts.small);
  const float width = ImGui::CalcTextSize(label.c_str()).x + ui.px(14);
  ImGui::PopFont();
  return std::floor(width);
}

bool chip(const PanelContext& ui, const std::string& label, const std::string& name, bool on, const std::string& tip) {
  const std::string full = "toggle:" + name;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = chipWidth(ui, label), height = ui.px(22);
  const bool clicked = ImGui::InvisibleButton(full.c_str(), ImVec2(width, height));
  ui.item(full);
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (on || hovered) list.AddRectFilled(at, {at.x + width, at.y + height}, on ? ui.theme.line : ui.theme.raised, ui.px(4));
  ImGui::PushFont(ui.fonts.small);
  rowText({at.x + ui.px(7), at.y}, width, height, on ? ui.theme.accent : hovered ? ui.theme.text : ui.theme.dim, label);
  ImGui::PopFont();
  if (ui.resting(full, tip) && !tip.empty()) tooltip(ui, tip);
  return clicked;
}

bool foldingHeading(const PanelContext& ui, const std::string& title, bool folded) {
  const std::string full = "section:" + title;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(26);
  const bool clicked = ImGui::InvisibleButton(full.c_str(), ImVec2(width, height));
  ui.item(full);
  const ImU32 colour = ImGui::IsItemHovered() ? ui.theme.text : ui.theme.dim;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  drawIcon(list, folded ? Icon::chevron_right : Icon::chevron_down, {at.x + ui.px(6), at.y + 0.5f * height}, ui.px(10), colour);
  ImGui::PushFont(ui.fonts.small);
  const std::string text = capitals(title);
  rowText({at.x + ui.px(18), at.y}, width, height, colour, text);
  const float end = at.x + ui.px(26) + ImGui::CalcTextSize(text.c_str()).x, middle = at.y + std::floor(0.5f * height) + 0.5f;
  list.AddLine({end, middle}, {at.x + width, middle}, ui.theme.line);
  ImGui::PopFont();
  return clicked;
}

void rowText(const ImVec2& at, float width, float height, ImU32 colour, const std::string& text) {
  const float y = std::floor(at.y + 0.5f * (height - ImGui::GetFontSize()));
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), {at.x, y}, {at.x + width, y + ImGui::GetFontSize() + 4.0f}, at.x + width, at.x + width, text.c_str(), text.c_str() + text.size(), &size);
  ImGui::PopStyleColor();
}

void rowTextRight(float right, float y, float height, ImU32 colour, const std::string& text) {
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  ImGui::GetWindowDrawList()->AddText({std::floor(right - width), std::floor(y + 0.5f * (height - ImGui::GetFontSize()))}, colour, text.c_str());
}

void beginMenuStyle(const PanelContext& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(16), ui.px(6)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(8)));
}

void endMenuStyle() { ImGui::PopStyleVar(2); }

bool checkEntry(const std::string& label, bool on) {
  ImGui::PushItemFlag(ImGuiItemFlags_SelectableDontClosePopup, true);
  const bool clicked = ImGui::MenuItem(label.c_str(), nullptr, on);
  ImGui::PopItemFlag();
  return clicked;
}

void tooltip(const PanelContext& ui, const std::string& text) {
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax(), mouse = ImGui::GetIO().MousePos, window = ImGui::GetIO().DisplaySize;
  const bool below = max.y + ui.px(120) < window.y, right = mouse.x + ui.px(340) > window.x;
  if (max.y - min.y < ui.px(64)) ImGui::SetNextWindowPos({mouse.x, below ? max.y + ui.px(4) : min.y - ui.px(4)}, ImGuiCond_Always, {right ? 1.0f : 0.0f, below ? 0.0f : 1.0f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(8)));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ui.px(320));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

std::string capitals(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return out;
}

}  // namespace npsee::editor
