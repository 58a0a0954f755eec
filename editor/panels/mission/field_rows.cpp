#include "editor/panels/mission/field_rows.h"

#include "editor/panels/row.h"
#include "editor/ui/controls.h"
#include "editor/ui/row_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace npsee::editor {
namespace {

using world::Field;
using world::FieldType;
using world::FieldValue;

bool commit(const PanelContext& ui, const FieldRow& row, const FieldValue& value, const std::string& merge_key = {}) {
  MissionDocument& document = ui.session.mission().document;
  if (std::string wrong = world::checkField(row.field, value); !wrong.empty()) {
    ui.session.notices.error = std::move(wrong);
    return false;
  }
  if (row.field.type == FieldType::id) return ui.session.took(document.renameObject(row.path.ref, std::get<std::string>(value)));
  return ui.session.took(document.edit(row.label, merge_key, [&](Scenario& scenario) {
    if (const TablePart part = resolve(scenario, row.path)) row.field.write(part.object, value);
  }));
}

double shown(const Field& field, double value) { return field.si ? toUnit(field.unit, value) : value; }
double stored(const Field& field, double value) { return field.si ? toSi(field.unit, value) : value; }

/// A range to drag over that fits the value: fields of missions know only their hard limits, which are wide.
NumberSpec specOf(const Field& field, double value, double initial, bool changed) {
  const double size = std::max({4.0 * std::abs(value), 10.0 * std::abs(initial), field.hard.max <= 1.0 ? field.hard.max : 10.0});
  NumberSpec spec{value, {0.0, size}, field.hard, Scale::linear, field.type == FieldType::integer, changed};
  if (!(spec.hard.max > spec.hard.min)) spec.hard = {-1e9, 1e9};
  spec.slider.max = std::min(spec.slider.max, std::max(spec.hard.max, 1.0));
  return spec;
}

void typedRow(const PanelContext& ui, const FieldRow& row) {
  const auto text = typingField(ui, row.control, row.field.hard.max > 1000.0 && row.field.key == "description");
  if (!text) return;
  const auto value = world::parseField(row.field, *text);
  if (!value) refuseTyping(ui, value.error().text());
  else if (commit(ui, row, *value)) ui.state.typing = {};
  else refuseTyping(ui, ui.session.notices.error);
}

void unitText(const Box& box, const PanelContext& ui, Unit unit, float width) {
  ImGui::PushFont(ui.fonts.small);
  rowText({box.right() - width + ui.px(4), box.at.y}, width, box.height, ui.theme.dim, shortUnit(unit));
  ImGui::PopFont();
}

void numberRow(const PanelContext& ui, const FieldRow& row) {
  const bool whole = row.field.type == FieldType::integer;
  const double now = whole ? static_cast<double>(std::get<std::int64_t>(row.value)) : shown(row.field, std::get<double>(row.value));
  const double initial = whole ? static_cast<double>(std::get<std::int64_t>(row.initial)) : shown(row.field, std::get<double>(row.initial));
  const float unit = ui.px(34);
  const Box box{row.control.at, row.control.width - unit, row.control.height};
  if (const auto changed = numberField(ui, row.name, specOf(row.field, now, initial, row.changed()), box)) {
    const FieldValue value = whole ? FieldValue(static_cast<std::int64_t>(std::llround(*changed))) : FieldValue(stored(row.field, *changed));
    commit(ui, row, value, row.name);
  }
  if (typingIn(ui, row.name)) ui.state.typing.text = world::fieldText(row.field, row.value, true);
  unitText(row.control, ui, row.field.unit, unit);
}

/// A place (x, z) or a vector (x, y, z) as numbers beside each other.
template <std::size_t count>
void partsRow(const PanelContext& ui, const FieldRow& row, std::array<double, count> parts, const std::array<double, count>& initials, const char* letters) {
  const float gap = ui.px(4), width = (row.control.width - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string letter(1, letters[i]), name = row.name + '.' + letter;
    const Box box{{row.control.at.x + static_cast<float>(i) * (width + gap), row.control.at.y}, width, row.control.height};
    const auto put = [&](double si) {
      parts[i] = si;
      if constexpr (count == 2) return FieldValue(Place{parts[0], parts[1]});
      else return FieldValue(Vec3{parts[0], parts[1], parts[2]});
    };
    if (typingIn(ui, name)) {
      const auto typed = typedNumber(ui, name, box, row.field.unit);
      if (typed && commit(ui, row, put(*typed))) ui.state.typing = {};
      else if (typed) refuseTyping(ui, ui.session.notices.error);
      continue;
    }
    NumberSpec spec = specOf(row.field, shown(row.field, parts[i]), 0.0, parts[i] != initials[i]);
    // A place is dragged by metres, wherever it is.
    if (count == 2) spec.slider = {0.0, 600.0};
    if (const auto changed = numberField(ui, name, spec, box, letter)) commit(ui, row, put(stored(row.field, *changed)), name);
  }
}

/// What a field chooses from: its own keys, vehicle types by name, presets of the library. Empty where it does not choose.
Choices choicesOf(const PanelContext& ui, const Field& field) {
  Choices out;
  for (const std::string_view key : field.choices) {
    std::string words(key);
    std::ranges::replace(words, '_', ' ');
    out.emplace_back(key, words);
  }
  if (field.type == FieldType::integer && field.key == "type")
    for (const VehicleType& type : vehicleTypes(ui.session.mission().document.scenario())) out.emplace_back(std::to_string(type.index), type.name.empty() ? "type " + std::to_string(type.index) : type.name);
  if (field.type == FieldType::integer && field.key == "weapon")
    for (const Weapon& weapon : ui.session.mission().weapons()) out.emplace_back(std::to_string(weapon.id), weapon.name);
  if (field.key != "preset") return out;
  out.emplace_back("", "by the weapon");
  for (const LibraryEntry& entry : ui.session.presets()) {
    const std::string name = bareName(entry.path);
    out.emplace_back(name, entry.title.empty() ? name : entry.title);
  }
  return out;
}

/// What an empty text stands for.
std::string emptyWords(std::string_view key) {
  if (key == "projectile" || key == "charges") return "by the weapon";
  if (key == "rules") return "the shipped ones alone";
  if (key == "weapons") return "the shipped ones";
  if (key == "batteries") return "all";
  if (key == "vehicle") return "one of his own";
  return "none";
}

void choiceRow(const PanelContext& ui, const FieldRow& row, const Choices& choices) {
  const auto chosen = choiceWidget(ui, row.name, world::fieldText(row.field, row.value), choices, row.changed(), row.control);
  if (!chosen) return;
  if (row.field.type == FieldType::integer) commit(ui, row, static_cast<std::int64_t>(std::stoll(*chosen)));
  else commit(ui, row, *chosen);
}

void textRow(const PanelContext& ui, const FieldRow& row) {
  const std::string text = world::fieldText(row.field, row.value);
  const bool marked = row.changed() && row.field.type != FieldType::id && row.field.key != "description";
  if (textWidget(ui, row.name, text, emptyWords(row.field.key), marked ? ui.theme.accent : ui.theme.text, row.control)) beginTyping(ui, row.name, text);
}

void drawWidget(const PanelContext& ui, const FieldRow& row) {
  if (typingIn(ui, row.name)) return typedRow(ui, row);
  if (const Choices choices = choicesOf(ui, row.field); !choices.empty()) return choiceRow(ui, row, choices);
  switch (row.field.type) {
    case FieldType::boolean:
      if (const bool on = std::get<bool>(row.value); switchWidget(ui, row.name, on, row.changed(), row.control)) commit(ui, row, !on);
      return;
    case FieldType::integer:
    case FieldType::number: return numberRow(ui, row);
    case FieldType::place: {
      const Place now = std::get<Place>(row.value), initial = std::get<Place>(row.initial);
      return partsRow<2>(ui, row, {now.x_m, now.z_m}, {initial.x_m, initial.z_m}, "xz");
    }
    case FieldType::vector: {
      const Vec3 now = std::get<Vec3>(row.value), initial = std::get<Vec3>(row.initial);
      return partsRow<3>(ui, row, {now.x, now.y, now.z}, {initial.x, initial.y, initial.z}, "xyz");
    }
    default: return textRow(ui, row);
  }
}

void takeScripted(const PanelContext& ui, const FieldRow& row) {
  const auto typed = ui.state.typed.find(row.name);
  if (typed == ui.state.typed.end()) return;
  const auto value = world::parseField(row.field, typed->second);
  if (!value) ui.state.typed_error = value.error().text();
  else if (!commit(ui, row, *value)) ui.state.typed_error = ui.session.notices.error;
  ui.state.typed.erase(typed);
}

void drawHelp(const PanelContext& ui, const FieldRow& row, const RowFrame& frame) {
  RowHelp help{row.label, std::string(row.field.doc), {}, row.idle};
  if (const std::string words = world::allowed(row.field); !words.empty()) help.lines.push_back("Allowed: " + words + (words.ends_with('.') ? "" : "."));
  help.lines.push_back("Now " + clipped(world::fieldText(row.field, row.value, true)) + ", by default " + clipped(world::fieldText(row.field, row.initial, true)) + '.');
  drawRowHelp(ui, frame, help);
}

}  // namespace

TablePart resolve(Scenario& scenario, const FieldPath& path) {
  TablePart at = partOf(scenario, path.ref);
  for (const auto& [key, index] : path.steps) {
    const Field* field = at ? at.table->find(key) : nullptr;
    if (field == nullptr || field->child == nullptr) return {};
    if (index < 0) {
      at = {field->child, field->part(at.object)};
    } else {
      if (static_cast<std::size_t>(index) >= field->count(at.object)) return {};
      at = {field->child, field->item(at.object, static_cast<std::size_t>(index))};
    }
  }
  return at;
}

std::string fieldLabel(std::string_view key) {
  std::string out;
  for (std::size_t start = 0; start < key.size();) {
    const std::size_t end = std::min(key.find('_', start), key.size());
    std::string word(key.substr(start, end - start));
    if (word == "pe" || word == "cep" || word == "fdc") word = capitals(word);
    else if (word == "expr") word = "function";
    else if (word == "pos") word = "position";
    out += (out.empty() ? "" : " ") + word;
    start = end + 1;
  }
  if (!out.empty() && out[0] >= 'a' && out[0] <= 'z') out[0] = static_cast<char>(out[0] - 'a' + 'A');
  return out;
}

bool askedFor(const PanelContext& ui, const std::string& name) {
  const std::string& wanted = ui.items.wanted();
  if (ui.state.typed.contains(name)) return true;
  const std::size_t colon = wanted.find(':');
  std::string_view plain = wanted;
  if (colon != std::string::npos) plain.remove_prefix(colon + 1);
  return plain == name || (plain.starts_with(name) && plain.size() > name.size() && (plain[name.size()] == '.' || plain[name.size()] == '='));
}

void drawFieldRow(const PanelContext& ui, FieldRow row) {
  const RowFrame frame = beginRow(ui, row.name, row.label, row.field.key == "description" ? 92.0f : 26.0f);
  row.control = frame.control;
  if (ui.resting(row.name, std::string(row.field.doc))) drawHelp(ui, row, frame);
  takeScripted(ui, row);
  drawWidget(ui, row);
  const bool resettable = row.changed() && !row.field.required;
  if (endRow(ui, frame, resettable ? clipped(world::fieldText(row.field, row.initial, true)) : std::string(), !row.idle.empty())) commit(ui, row, row.initial);
}

}  // namespace npsee::editor
