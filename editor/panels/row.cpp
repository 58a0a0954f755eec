#include "editor/panels/row.h"

#include "editor/document/vary.h"
#include "editor/panels/vary_strip.h"

#include <utility>

namespace npsee::editor {
namespace {

Error faultOf(const Expected<Value>& parsed) { return parsed.error(); }

}  // namespace

bool commit(const PanelContext& ui, const Row& row, const Value& value, const std::string& merge_key) {
  return ui.session.took(ui.session.document.assign(row.parameter, value, merge_key));
}

void commitTyped(const PanelContext& ui, const Row& row, const Value& value) {
  if (commit(ui, row, value)) ui.state.typing = {};
  else refuseTyping(ui, ui.session.notices.error);
}

void typedRow(const PanelContext& ui, const Row& row) {
  const auto text = typingField(ui, row.control, longText(row.parameter));
  if (!text) return;
  const auto value = parseValue(row.parameter, *text);
  const int by = std::exchange(ui.state.typing.tab, 0);
  if (value) commitTyped(ui, row, *value);
  if (value && by != 0 && ui.state.typing.name.empty()) ui.state.tabbing = {by, row.name, {}, ui.state.tabbing.before};
  if (!value) refuseTyping(ui, faultOf(value).text());
}

std::optional<double> typedNumber(const PanelContext& ui, const std::string& name, const Box& box, Unit unit) {
  if (!typingIn(ui, name)) return std::nullopt;
  const auto text = typingField(ui, box);
  if (!text) return std::nullopt;
  const auto value = parseQuantity(*text, unit);
  if (value) return *value;
  refuseTyping(ui, value.error().text());
  return std::nullopt;
}

void takeScripted(const PanelContext& ui, const Row& row) {
  const auto typed = ui.state.typed.find(row.name);
  if (typed == ui.state.typed.end()) return;
  const auto value = parseValue(row.parameter, typed->second);
  if (!value) ui.state.typed_error = faultOf(value).text();
  else if (!commit(ui, row, *value)) ui.state.typed_error = ui.session.notices.error;
  ui.state.typed.erase(typed);
}

void drawRowMenu(const PanelContext& ui, const Row& row) {
  const auto entry = [&](const char* label, bool enabled = true) {
    const bool chosen = ImGui::MenuItem(label, nullptr, false, enabled);
    ui.item("item:" + std::string(label));
    return chosen;
  };
  if (entry("Type a value", row.parameter.type != ParameterType::boolean)) beginTyping(ui, row.name, valueText(row.parameter, row.value, true));
  if (entry("Reset", row.changed && resettable(row))) commit(ui, row, row.parameter.initial);
  if (varies(row.parameter) && entry(locked(ui, row.name) ? "Unlock" : "Lock against randomising")) toggleLock(ui, row.name);
  ImGui::Separator();
  if (entry("Copy value")) ImGui::SetClipboardText(valueText(row.parameter, row.value).c_str());
  if (entry("Copy key")) ImGui::SetClipboardText(row.name.c_str());
  if (entry("Copy as --set")) ImGui::SetClipboardText(("--set \"" + row.name + '=' + valueText(row.parameter, row.value) + '"').c_str());
}

bool longText(const Parameter& parameter) { return parameter.type == ParameterType::text && parameter.hard.max > 1000.0; }

bool resettable(const Row& row) { return row.parameter.key != "name"; }

std::string shortUnit(Unit unit) {
  if (unit == Unit::degree) return "\u00b0";
  if (unit == Unit::metre_per_second2) return "m/s\u00b2";
  // Counts and densities are plain from their labels.
  if (unit == Unit::particle || unit == Unit::fraction) return {};
  const std::string text(symbol(unit));
  return text.size() <= 5 ? text : std::string();
}

std::string clipped(const std::string& text) { return text.empty() ? "none" : text.size() <= 40 ? text : text.substr(0, 37) + "..."; }

}  // namespace npsee::editor
