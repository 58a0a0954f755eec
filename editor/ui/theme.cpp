#include "editor/ui/theme.h"

#include <cmath>

namespace npsee::editor {
namespace {

constexpr ImU32 rgb(unsigned hex) { return IM_COL32((hex >> 16) & 255u, (hex >> 8) & 255u, hex & 255u, 255u); }

ImVec4 vec(ImU32 colour) { return ImGui::ColorConvertU32ToFloat4(colour); }

void applyColours(const Theme& t, ImVec4* c) {
  c[ImGuiCol_Text] = vec(t.text);
  c[ImGuiCol_TextDisabled] = vec(t.dim);
  c[ImGuiCol_WindowBg] = vec(t.background);
  c[ImGuiCol_ChildBg] = vec(t.panel);
  c[ImGuiCol_PopupBg] = c[ImGuiCol_MenuBarBg] = vec(t.panel);
  c[ImGuiCol_Border] = c[ImGuiCol_Separator] = vec(t.line);
  c[ImGuiCol_FrameBg] = vec(t.background);
  c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_FrameBgActive] = vec(t.raised);
  c[ImGuiCol_Button] = vec(t.raised);
  c[ImGuiCol_ButtonHovered] = c[ImGuiCol_ButtonActive] = vec(t.line);
  c[ImGuiCol_Header] = vec(t.raised);
  c[ImGuiCol_HeaderHovered] = c[ImGuiCol_HeaderActive] = vec(t.line);
  c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrab] = c[ImGuiCol_SliderGrabActive] = vec(t.accent);
  c[ImGuiCol_TextSelectedBg] = vec(faded(t.geometry, 0.35f));
  c[ImGuiCol_ScrollbarBg] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_ScrollbarGrab] = vec(t.line);
  c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = vec(t.dim);
  c[ImGuiCol_NavHighlight] = vec(t.accent);
}

}  // namespace

Theme darkTheme() {
  return {rgb(0x16181c), rgb(0x1e2127), rgb(0x272b33), rgb(0x343944), rgb(0xd9dce3), rgb(0x8b92a0), rgb(0xf2a33c), rgb(0x5fb3d9), rgb(0xe2574c), rgb(0x7fbf6a), true};
}

Theme lightTheme() {
  return {rgb(0xe4e6ea), rgb(0xf4f5f7), rgb(0xe3e6eb), rgb(0xc4c9d2), rgb(0x23272f), rgb(0x5a6270), rgb(0xa85a00), rgb(0x1d6f98), rgb(0xb3261e), rgb(0x33752a), false};
}

ImU32 faded(ImU32 colour, float opacity) {
  const auto alpha = static_cast<ImU32>(std::lround(opacity * 255.0f));
  return (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

void applyTheme(const Theme& theme, float scale) {
  ImGuiStyle style;
  style.WindowPadding = style.FramePadding = ImVec2(8, 4);
  style.ItemSpacing = ImVec2(8, 4);
  style.ItemInnerSpacing = ImVec2(6, 4);
  style.CellPadding = ImVec2(4, 2);
  style.WindowRounding = style.ChildRounding = 0;
  style.FrameRounding = style.PopupRounding = style.GrabRounding = style.ScrollbarRounding = 4;
  style.WindowBorderSize = style.ChildBorderSize = style.FrameBorderSize = 0;
  style.PopupBorderSize = 1;
  style.ScrollbarSize = 10;
  style.IndentSpacing = 16;
  style.ScaleAllSizes(scale);
  // Hairlines stay one pixel at every scale and rounding is exact only with whole segments.
  style.PopupBorderSize = 1;
  applyColours(theme, style.Colors);
  ImGui::GetStyle() = style;
}

}  // namespace npsee::editor
