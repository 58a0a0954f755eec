#include "editor/panels/panels.h"
#include "editor/panels/row.h"
#include "editor/ui/controls.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {
namespace {

NumberSpec specOf(const Row& row, double value) {
  return {value, row.parameter.slider, row.parameter.hard, row.parameter.scale, row.parameter.type == ParameterType::integer, row.changed};
}

Value numberValue(const Parameter& parameter, double shown) {
  if (parameter.type == ParameterType::integer) return static_cast<std::int64_t>(std::llround(shown));
  return toSi(parameter.unit, shown);
}

double shownNumber(const Parameter& parameter, const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  return toUnit(parameter.unit, std::get<double>(value));
}

void numberRow(const PanelContext& ui, const Row& row) {
  const double shown = shownNumber(row.parameter, row.value);
  const float value_width = ui.px(78), gap = ui.px(10);
  const Box track{{row.control.at.x + ui.px(6), row.control.at.y}, row.control.width - value_width - gap - ui.px(6), row.control.height};
  if (const auto changed = slider(ui, row.name, specOf(row, shown), track)) commit(ui, row, numberValue(row.parameter, *changed), row.name);
  if (typingIn(ui, row.name)) ui.state.typing.text = valueText(row.parameter, row.value, true);
  const Box box{{row.control.right() - value_width, row.control.at.y}, value_width, row.control.height};
  ImGui::SetCursorScreenPos(box.at);
  ImGui::InvisibleButton(("value:" + row.name).c_str(), ImVec2(box.width, box.height));
  ui.item("value:" + row.name);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && (ImGui::GetIO().KeyCtrl || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))) beginTyping(ui, row.name, valueText(row.parameter, row.value, true));
  if (hovered) ImGui::GetWindowDrawList()->AddRectFilled({box.at.x, box.at.y + ui.px(2)}, {box.right(), box.end().y - ui.px(2)}, ui.theme.background, ui.px(4));
  // The unit stands in a column of its own, so that the digits line up.
  const float unit_width = ui.px(34);
  ImGui::PushFont(ui.fonts.numbers);
  rowTextRight(box.right() - unit_width, box.at.y, box.height, row.changed ? ui.theme.accent : ui.theme.text, shortNumber(shown));
  ImGui::PopFont();
  ImGui::PushFont(ui.fonts.small);
  rowText({box.right() - unit_width + ui.px(4), box.at.y}, unit_width, box.height, ui.theme.dim, shortUnit(row.parameter.unit));
  ImGui::PopFont();
}

void booleanRow(const PanelContext& ui, const Row& row) {
  const bool on = std::get<bool>(row.value);
  const float width = ui.px(34), height = ui.px(18);
  const ImVec2 at{row.control.at.x, std::floor(row.control.at.y + 0.5f * (row.control.height - height))};
  ImGui::SetCursorScreenPos(at);
  const bool clicked = ImGui::InvisibleButton(("toggle:" + row.name).c_str(), ImVec2(width, height));
  ui.item("toggle:" + row.name);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 fill = !on ? ui.theme.line : row.changed ? ui.theme.accent : ui.theme.dim;
  list.AddRectFilled(at, {at.x + width, at.y + height}, fill, 0.5f * height);
  const float knob = on ? at.x + width - 0.5f * height : at.x + 0.5f * height;
  list.AddCircleFilled({knob, at.y + 0.5f * height}, 0.5f * height - ui.px(3), on ? ui.theme.background : ui.theme.dim, 20);
  rowText({at.x + width + ui.px(8), row.control.at.y}, ui.px(60), row.control.height, ui.theme.dim, on ? "on" : "off");
  if (clicked) commit(ui, row, !on);
}

void choiceList(const PanelContext& ui, const Row& row, const std::vector<std::pair<std::string, std::string>>& choices) {
  const auto& now = std::get<std::string>(row.value);
  std::string label = now;
  for (const auto& [key, text] : choices)
    if (key == now) label = text;
  ImGui::SetCursorScreenPos({row.control.at.x, row.control.at.y + ui.px(1)});
  ImGui::SetNextItemWidth(row.control.width);
  if (!beginChoice(ui, row.name, label, row.changed)) return ui.item("choice:" + row.name);
  for (const auto& [key, text] : choices) {
    if (ImGui::Selectable(text.c_str(), key == now, 0, ImVec2(0, ui.px(22)))) commit(ui, row, key);
    ui.item("choice:" + row.name + '=' + key);
  }
  ImGui::EndCombo();
}

void choiceRow(const PanelContext& ui, const Row& row) {
  std::vector<std::pair<std::string, std::string>> choices;
  for (const std::string_view key : row.parameter.choices) choices.emplace_back(key, key);
  choiceList(ui, row, choices);
}

/// The layers that the selected one can hang on: all but itself. A ring of parents is refused by the document.
void parentRow(const PanelContext& ui, const Row& row) {
  const Document& document = ui.session.document;
  std::vector<std::pair<std::string, std::string>> choices{{"", "the burst"}};
  for (const Layer& layer : document.preset().layers)
    if (layer.name != document.layer().name) choices.emplace_back(layer.name, layer.name);
  choiceList(ui, row, choices);
}

void textRow(const PanelContext& ui, const Row& row) {
  const auto& text = std::get<std::string>(row.value);
  ImGui::SetCursorScreenPos(row.control.at);
  const bool clicked = ImGui::InvisibleButton(("text:" + row.name).c_str(), ImVec2(row.control.width, row.control.height));
  ui.item("text:" + row.name);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({row.control.at.x, row.control.at.y + ui.px(2)}, {row.control.right(), row.control.end().y - ui.px(2)}, ImGui::IsItemHovered() ? ui.theme.raised : ui.theme.background, ui.px(4));
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
  if (longText(row.parameter)) {
    const ImVec2 at{row.control.at.x + ui.px(8), row.control.at.y + ui.px(6)};
    list.PushClipRect(row.control.at, row.control.end(), true);
    list.AddText(ui.fonts.text, ui.fonts.text->FontSize, at, text.empty() ? ui.theme.dim : ui.theme.text, text.empty() ? "none" : text.c_str(), nullptr, row.control.width - ui.px(16));
    list.PopClipRect();
  } else {
    rowText({row.control.at.x + ui.px(8), row.control.at.y}, row.control.width - ui.px(12), row.control.height, text.empty() ? ui.theme.dim : ui.theme.text, text.empty() ? "none" : text);
  }
  if (clicked) beginTyping(ui, row.name, text);
}

void vectorRow(const PanelContext& ui, const Row& row) {
  Vec3 vector = std::get<Vec3>(row.value);
  const float gap = ui.px(4), width = (row.control.width - 2.0f * gap) / 3.0f;
  const Vec3 initial = std::get<Vec3>(row.parameter.initial);
  double* const parts[] = {&vector.x, &vector.y, &vector.z};
  const double initials[] = {initial.x, initial.y, initial.z};
  for (int i = 0; i < 3; ++i) {
    const std::string letter(1, "xyz"[i]), name = row.name + '.' + letter;
    const Box box{{row.control.at.x + static_cast<float>(i) * (width + gap), row.control.at.y}, width, row.control.height};
    NumberSpec spec = specOf(row, *parts[i]);
    spec.changed = *parts[i] != initials[i];
    if (const auto typed = typedNumber(ui, name, box, row.parameter.unit)) {
      *parts[i] = *typed;
      commitTyped(ui, row, vector);
    } else if (!typingIn(ui, name)) {
      if (const auto changed = numberField(ui, name, spec, box, letter)) {
        *parts[i] = *changed;
        commit(ui, row, vector, name);
      }
    }
  }
}

/// Stands left of the panel, so that it hides neither the row nor its neighbours.
void drawTooltip(const PanelContext& ui, const Row& row, const ImVec2& beside) {
  const Parameter& p = row.parameter;
  ImGui::SetNextWindowPos({beside.x - ui.px(16), beside.y}, ImGuiCond_Always, {1.0f, 0.0f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(8)));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ui.px(330));
  ImGui::PushFont(ui.fonts.bold);
  ImGui::TextUnformatted(p.label.data(), p.label.data() + p.label.size());
  ImGui::PopFont();
  ImGui::TextUnformatted(p.doc.data(), p.doc.data() + p.doc.size());
  const auto line = [&](const std::string& text) { ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(ui.theme.dim), "%s", text.c_str()); };
  if (!p.thesis.empty()) line("In the 1993 thesis: " + std::string(p.thesis) + ".");
  const std::string unit = symbol(p.unit).empty() ? "" : ' ' + std::string(symbol(p.unit));
  if (p.type == ParameterType::number || p.type == ParameterType::integer || p.type == ParameterType::vector)
    line("From " + shortest(p.hard.min) + " to " + shortest(p.hard.max) + unit + ".");
  line("Now " + clipped(valueText(p, row.value, true)) + ", by default " + clipped(valueText(p, p.initial, true)) + '.');
  ImGui::PushFont(ui.fonts.numbers);
  line(row.name);
  ImGui::PopFont();
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void drawWidget(const PanelContext& ui, const Row& row) {
  if (typingIn(ui, row.name)) return typedRow(ui, row);
  switch (row.parameter.type) {
    case ParameterType::boolean: return booleanRow(ui, row);
    case ParameterType::integer:
    case ParameterType::number: return numberRow(ui, row);
    case ParameterType::choice: return choiceRow(ui, row);
    case ParameterType::text: return row.parameter.key == "parent" ? parentRow(ui, row) : textRow(ui, row);
    case ParameterType::vector: return vectorRow(ui, row);
    case ParameterType::colour: return colourRow(ui, row);
    case ParameterType::curve:
    case ParameterType::gradient: return lifeRow(ui, row);
  }
}

}  // namespace

void drawParameterRow(const PanelContext& ui, const Parameter& parameter) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(longText(parameter) ? 78 : 26), mark = ui.px(20);
  const float label_width = std::floor(std::clamp(0.405f * width, ui.px(96), ui.px(152)));
  Row row{parameter, parameterName(ui.session.document, parameter), ui.session.document.value(parameter), false, {}};
  row.changed = row.value != parameter.initial;
  row.control = {{at.x + label_width, at.y}, width - label_width - mark, height};
  takeScripted(ui, row);

  ImGui::InvisibleButton(("row:" + row.name).c_str(), ImVec2(label_width, ui.px(26)));
  ui.item("row:" + row.name);
  rowText(at, label_width - ui.px(8), ui.px(26), ImGui::IsItemHovered() ? ui.theme.text : ui.theme.dim, std::string(parameter.label));
  if (ui.resting(row.name, std::string(parameter.doc))) drawTooltip(ui, row, at);
  if (ImGui::BeginPopupContextItem(("menu:" + row.name).c_str())) {
    drawRowMenu(ui, row);
    ImGui::EndPopup();
  }
  drawWidget(ui, row);
  if (row.changed && resettable(row)) {
    ImGui::SetCursorScreenPos({at.x + width - mark + ui.px(2), at.y + ui.px(4)});
    if (iconButton(ui, Icon::reset, "reset:" + row.name, "Back to " + clipped(valueText(parameter, parameter.initial, true)), true, 18)) commit(ui, row, parameter.initial);
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy(ImVec2(width, height));
  drawLifeList(ui, row);
  drawHistogram(ui, row);
}

}  // namespace npsee::editor
