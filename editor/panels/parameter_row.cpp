#include "editor/panels/panels.h"
#include "editor/panels/row.h"
#include "editor/panels/vary_strip.h"
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

Choices choicesOf(const PanelContext& ui, const Row& row) {
  Choices out;
  for (const std::string_view key : row.parameter.choices) out.emplace_back(key, key);
  if (row.parameter.key != "parent") return out;
  // The layers that the selected one can hang on: all but itself. A ring of parents is refused by the document.
  const Document& document = ui.session.document;
  out.emplace_back("", "the burst");
  for (const Layer& layer : document.preset().layers)
    if (layer.name != document.layer().name) out.emplace_back(layer.name, layer.name);
  return out;
}

void choiceRow(const PanelContext& ui, const Row& row) {
  if (const auto chosen = choiceWidget(ui, row.name, std::get<std::string>(row.value), choicesOf(ui, row), row.changed, row.control)) commit(ui, row, *chosen);
}

void textRow(const PanelContext& ui, const Row& row) {
  const auto& text = std::get<std::string>(row.value);
  if (textWidget(ui, row.name, text, "none", ui.theme.text, row.control)) beginTyping(ui, row.name, text);
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

void drawHelp(const PanelContext& ui, const Row& row, const RowFrame& frame) {
  const Parameter& p = row.parameter;
  RowHelp help{std::string(p.label), std::string(p.doc), {}, row.idle};
  if (!p.thesis.empty()) help.lines.push_back("In the 1993 thesis: " + std::string(p.thesis) + ".");
  const std::string unit = symbol(p.unit).empty() ? "" : ' ' + std::string(symbol(p.unit));
  if (p.type == ParameterType::number || p.type == ParameterType::integer || p.type == ParameterType::vector)
    help.lines.push_back("From " + shortest(p.hard.min) + " to " + shortest(p.hard.max) + unit + ".");
  help.lines.push_back("Now " + clipped(valueText(p, row.value, true)) + ", by default " + clipped(valueText(p, p.initial, true)) + '.');
  if (locked(ui, row.name)) help.lines.push_back("Locked: randomising leaves it as it is.");
  drawRowHelp(ui, frame, help);
}

/// Tab in a field goes on to the next row that can be typed in, Shift+Tab to the one before.
void passTyping(const PanelContext& ui, const Row& row) {
  UiState::Tabbing& tab = ui.state.tabbing;
  using enum ParameterType;
  const bool typable = row.parameter.type == number || row.parameter.type == integer;
  if (!typable) return;
  if (tab.by < 0 && tab.from == row.name && !tab.before.empty()) {
    tab.to = tab.before;
    tab.by = 0;
  }
  if (tab.by > 0 && tab.before == tab.from && tab.from != row.name) {
    tab.to = row.name;
    tab.by = 0;
  }
  if (tab.to == row.name && tab.by == 0) {
    beginTyping(ui, row.name, valueText(row.parameter, row.value, true));
    ui.items.want("row:" + row.name);
    tab.to.clear();
  }
  tab.before = row.name;
}

void drawWidget(const PanelContext& ui, const Row& row) {
  if (typingIn(ui, row.name)) return typedRow(ui, row);
  switch (row.parameter.type) {
    case ParameterType::boolean:
      if (const bool on = std::get<bool>(row.value); switchWidget(ui, row.name, on, row.changed, row.control)) commit(ui, row, !on);
      return;
    case ParameterType::integer:
    case ParameterType::number: return numberRow(ui, row);
    case ParameterType::choice: return choiceRow(ui, row);
    case ParameterType::text: return row.parameter.key == "parent" ? choiceRow(ui, row) : textRow(ui, row);
    case ParameterType::vector: return vectorRow(ui, row);
    case ParameterType::colour: return colourRow(ui, row);
    case ParameterType::curve:
    case ParameterType::gradient: return lifeRow(ui, row);
  }
}

}  // namespace

void drawParameterRow(const PanelContext& ui, const Parameter& parameter) {
  const Document& document = ui.session.document;
  Row row{parameter, parameterName(document, parameter), document.value(parameter), false, {}, {}};
  row.changed = row.value != parameter.initial;
  row.idle = withoutEffect(parameter, document.preset(), document.hasLayer() ? &document.layer() : nullptr);
  const RowFrame frame = beginRow(ui, row.name, std::string(parameter.label), longText(parameter) ? 92.0f : 26.0f);
  row.control = frame.control;
  if (ui.resting(row.name, std::string(parameter.doc))) drawHelp(ui, row, frame);
  contextMenu(ui, ("menu:" + row.name).c_str(), [&] { drawRowMenu(ui, row); });
  drawLock(ui, row, frame);
  takeScripted(ui, row);
  passTyping(ui, row);
  drawWidget(ui, row);
  if (endRow(ui, frame, row.changed && resettable(row) ? clipped(valueText(parameter, parameter.initial, true)) : std::string(), !row.idle.empty())) commit(ui, row, parameter.initial);
  drawLifeList(ui, row);
  drawHistogram(ui, row);
}

}  // namespace npsee::editor
