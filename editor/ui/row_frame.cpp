#include "editor/ui/row_frame.h"

#include "editor/ui/controls.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {
namespace {

/// The text from its beginning, wrapped, in whole lines; what does not fit ends in an ellipsis.
void wrappedText(const PanelContext& ui, const Box& box, ImU32 colour, const std::string& text) {
  ImFont* const font = ui.fonts.text;
  const float line = font->FontSize;
  const char *at = text.c_str(), *const end = at + text.size();
  int left = std::max(1, static_cast<int>((box.height) / line));
  for (float y = box.at.y; at < end && left > 0; y += line, --left) {
    const char* stop = font->CalcWordWrapPositionA(1.0f, at, end, box.width);
    if (stop == at) ++stop;
    const char* const broken = std::find(at, stop, '\n');
    if (left == 1 && stop < end) return rowText({box.at.x, y}, box.width, line, colour, std::string(at, end));
    ImGui::GetWindowDrawList()->AddText(font, line, {box.at.x, y}, colour, at, broken);
    at = broken < stop ? broken + 1 : stop;
    while (at < end && *at == ' ') ++at;
  }
}

}  // namespace

RowFrame beginRow(const PanelContext& ui, const std::string& name, const std::string& label, float height) {
  RowFrame row{name, ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail().x, ui.px(height), {}};
  const float label_width = std::floor(std::clamp(0.41f * row.width, ui.px(96), ui.px(152))), mark = ui.px(20);
  row.control = {{row.at.x + label_width, row.at.y}, row.width - label_width - mark, row.height};
  ImGui::InvisibleButton(("row:" + name).c_str(), ImVec2(label_width, ui.px(26)));
  ui.item("row:" + name);
  rowText(row.at, label_width - ui.px(8), ui.px(26), ImGui::IsItemHovered() ? ui.theme.text : ui.theme.dim, label);
  return row;
}

bool endRow(const PanelContext& ui, const RowFrame& row, const std::string& initial, bool idle) {
  // A veil dims any widget and takes no input.
  if (idle) ImGui::GetWindowDrawList()->AddRectFilled(row.at, {row.control.right(), row.at.y + row.height}, faded(ui.theme.panel, 0.55f));
  bool reset = false;
  if (!initial.empty()) {
    ImGui::SetCursorScreenPos({row.control.right() + ui.px(2), row.at.y + ui.px(4)});
    reset = iconButton(ui, Icon::reset, "reset:" + row.name, "Back to " + initial, true, 18);
  }
  ImGui::SetCursorScreenPos(row.at);
  ImGui::Dummy(ImVec2(row.width, row.height));
  return reset;
}

void drawRowHelp(const PanelContext& ui, const RowFrame& row, const RowHelp& help) {
  ImGui::SetNextWindowPos({row.at.x - ui.px(16), row.at.y}, ImGuiCond_Always, {1.0f, 0.0f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(8)));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ui.px(330));
  ImGui::PushFont(ui.fonts.bold);
  ImGui::TextUnformatted(help.title.c_str());
  ImGui::PopFont();
  ImGui::TextUnformatted(help.doc.c_str());
  const auto line = [](ImU32 colour, const std::string& text) { ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour), "%s", text.c_str()); };
  if (!help.idle.empty()) line(ui.theme.accent, "No effect now: " + help.idle + '.');
  for (const std::string& text : help.lines) line(ui.theme.dim, text);
  ImGui::PushFont(ui.fonts.numbers);
  line(ui.theme.dim, row.name);
  ImGui::PopFont();
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

bool switchWidget(const PanelContext& ui, const std::string& name, bool on, bool changed, const Box& box) {
  const float width = ui.px(34), height = ui.px(18);
  const ImVec2 at{box.at.x, std::floor(box.at.y + 0.5f * (box.height - height))};
  ImGui::SetCursorScreenPos(at);
  const bool clicked = ImGui::InvisibleButton(("toggle:" + name).c_str(), ImVec2(width, height));
  ui.item("toggle:" + name);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + height}, !on ? ui.theme.line : changed ? ui.theme.accent : ui.theme.dim, 0.5f * height);
  const float knob = on ? at.x + width - 0.5f * height : at.x + 0.5f * height;
  list.AddCircleFilled({knob, at.y + 0.5f * height}, 0.5f * height - ui.px(3), on ? ui.theme.background : ui.theme.dim, 20);
  rowText({at.x + width + ui.px(8), box.at.y}, ui.px(60), box.height, ui.theme.dim, on ? "on" : "off");
  return clicked;
}

std::optional<std::string> choiceWidget(const PanelContext& ui, const std::string& name, const std::string& now, const Choices& choices, bool changed, const Box& box) {
  const auto chosen = std::ranges::find(choices, now, &Choices::value_type::first);
  ImGui::SetCursorScreenPos({box.at.x, box.at.y + ui.px(1)});
  ImGui::SetNextItemWidth(box.width);
  std::optional<std::string> out;
  if (!beginChoice(ui, name, chosen == choices.end() ? now : chosen->second, changed)) {
    ui.item("choice:" + name);
    return out;
  }
  for (const auto& [key, text] : choices) {
    if (ImGui::Selectable((text + "##" + key).c_str(), key == now, 0, ImVec2(0, ui.px(22)))) out = key;
    ui.item("choice:" + name + '=' + key);
  }
  ImGui::EndCombo();
  return out;
}

bool textWidget(const PanelContext& ui, const std::string& name, const std::string& text, const std::string& empty, ImU32 colour, const Box& box) {
  ImGui::SetCursorScreenPos(box.at);
  const bool clicked = ImGui::InvisibleButton(("text:" + name).c_str(), ImVec2(box.width, box.height));
  ui.item("text:" + name);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
  ImGui::GetWindowDrawList()->AddRectFilled({box.at.x, box.at.y + ui.px(2)}, {box.right(), box.end().y - ui.px(2)}, hovered ? ui.theme.raised : ui.theme.background, ui.px(4));
  const ImU32 shown = text.empty() ? ui.theme.dim : colour;
  const std::string& words = text.empty() ? empty : text;
  if (box.height > ui.px(40)) wrappedText(ui, {{box.at.x + ui.px(8), box.at.y + ui.px(6)}, box.width - ui.px(16), box.height - ui.px(10)}, shown, words);
  else rowText({box.at.x + ui.px(8), box.at.y}, box.width - ui.px(12), box.height, shown, words);
  return clicked;
}

}  // namespace npsee::editor
