#include "editor/panels/mission/field_rows.h"
#include "editor/ui/controls.h"

#include <imgui_stdlib.h>

namespace npsee::editor {
namespace {

using Kind = ObjectRef::Kind;
using world::Field;

bool contains(std::string_view text, const std::string& word) { return word.empty() || capitals(text).find(capitals(word)) != std::string::npos; }

std::string nameOf(const FieldPath& path, std::string_view key) {
  std::string out = path.ref.kind == Kind::mission ? std::string() : path.ref.id + '.';
  for (const auto& [step, index] : path.steps) {
    out += std::string(step) + '.';
    if (index >= 0) out += std::to_string(index + 1) + '.';
  }
  return out + std::string(key);
}

/// The fields of one structure that are values, as rows.
std::vector<FieldRow> rowsOf(const PanelContext& ui, const FieldPath& path, const std::string& word) {
  std::vector<FieldRow> out;
  // Reading does not change the scenario; the table's accessors are shared with writing.
  const TablePart part = resolve(const_cast<Scenario&>(ui.session.mission().document.scenario()), path);
  if (!part) return out;
  const auto fresh = part.table->make();
  for (const Field& field : part.table->fields) {
    if (!field.scalar()) continue;
    const std::string label = fieldLabel(field.key);
    if (!contains(label, word) && !contains(field.key, word)) continue;
    out.push_back({*part.table, field, path, nameOf(path, field.key), label, field.read(part.object), field.read(fresh.get()), {}, std::string(field.idle != nullptr ? field.idle(part.object) : std::string_view())});
  }
  return out;
}

void drawRows(const PanelContext& ui, const std::string& title, const std::vector<FieldRow>& rows) {
  if (rows.empty()) return;
  auto& folded = ui.state.mission.folded_sections;
  for (const FieldRow& row : rows)
    if (askedFor(ui, row.name)) folded.erase(title);
  const bool searching = !ui.state.mission.parameter_search.empty();
  const bool is_folded = !searching && folded.contains(title);
  if (foldingHeading(ui, title, is_folded) && !searching) {
    if (!folded.erase(title)) folded.insert(title);
  }
  if (is_folded) return;
  for (const FieldRow& row : rows) drawFieldRow(ui, row);
  ImGui::Dummy(ImVec2(1, ui.px(6)));
}

/// The elements of a short list, such as an observer's mission orders, with buttons to add and remove.
void drawList(const PanelContext& ui, const FieldPath& path, const Field& field, const std::string& word) {
  MissionDocument& document = ui.session.mission().document;
  const TablePart part = resolve(const_cast<Scenario&>(document.scenario()), path);
  const std::size_t count = field.count(part.object);
  const std::string title = fieldLabel(field.key);
  if (!contains(title, word)) return;
  for (std::size_t i = 0; i < count; ++i) {
    FieldPath inner = path;
    inner.steps.emplace_back(field.key, static_cast<int>(i));
    drawRows(ui, title + ' ' + std::to_string(i + 1), rowsOf(ui, inner, {}));
  }
  if (textButton(ui, "Add " + std::string(field.child->name), "add " + nameOf(path, field.key)))
    ui.session.took(document.edit("Add " + std::string(field.child->name), {}, [&](Scenario& scenario) {
      const TablePart to = resolve(scenario, path);
      void* const made = field.append(to.object);
      // A new order is against something that is there.
      if (const Field* type = field.child->find("type")) type->write(made, std::int64_t{scenario.vehicles.empty() ? 51 : scenario.vehicles.front().type});
    }));
  if (count > 0) {
    ImGui::SameLine();
    if (textButton(ui, "Remove the last", "remove " + nameOf(path, field.key)))
      ui.session.took(document.edit("Remove " + std::string(field.child->name), {}, [&](Scenario& scenario) {
        for (ObserverSetup& observer : scenario.observers)
          if (path.ref == ObjectRef{Kind::observer, observer.id} && !observer.missions.empty()) observer.missions.pop_back();
      }));
  }
  ImGui::Dummy(ImVec2(1, ui.px(6)));
}

/// A structure, then its parts, each a section.
void drawStruct(const PanelContext& ui, const FieldPath& path, const std::string& title, const std::string& word) {
  const TablePart part = resolve(const_cast<Scenario&>(ui.session.mission().document.scenario()), path);
  if (!part) return;
  drawRows(ui, title, rowsOf(ui, path, word));
  for (const Field& field : part.table->fields) {
    if (field.type == world::FieldType::object) {
      FieldPath inner = path;
      inner.steps.emplace_back(field.key, -1);
      drawStruct(ui, inner, fieldLabel(field.key), word);
    } else if (field.type == world::FieldType::list && path.ref.kind == Kind::observer) {
      drawList(ui, path, field, word);
    }
  }
}

std::string batteryOf(const Scenario& scenario, const std::string& gun) {
  for (const BatterySetup& battery : scenario.batteries)
    for (const GunSetup& one : battery.guns)
      if (one.id == gun) return battery.id;
  return {};
}

void drawSearch(const PanelContext& ui) {
  MissionUi& my = ui.state.mission;
  ImGui::SetNextItemWidth(-1);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(10), std::floor(0.5f * (ui.px(26) - ImGui::GetFontSize()))));
  ImGui::InputTextWithHint("##fields", "find parameter", &my.parameter_search);
  ImGui::PopStyleVar();
  ui.item("field:search");
}

}  // namespace

void drawFieldPanel(const PanelContext& ui) {
  MissionDocument& document = ui.session.mission().document;
  const ObjectRef ref = ui.session.mission().editable(document.selected());
  if (!ui.state.typed.empty()) ui.state.mission.parameter_search.clear();
  drawSearch(ui);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), 0));
  ImGui::BeginChild("fields", ImVec2(0, 0), false, ImGuiWindowFlags_NoBackground);
  const std::string& word = ui.state.mission.parameter_search;
  const std::string title = fieldLabel(kindName(ref.kind));
  if (ui.session.mission().selectedFromFacts()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(("It comes from " + document.scenario().facts.string() + ". To change it, write what that file says into the mission.").c_str());
    ImGui::PopTextWrapPos();
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    if (textButton(ui, "Write into the mission", "adopt", true)) ui.session.took(ui.session.mission().adopt());
  }
  drawStruct(ui, {ref, {}}, ref == document.selected() ? title : "Group " + ref.id, word);
  if (ref.kind == Kind::gun) {
    const ObjectRef battery{Kind::battery, batteryOf(document.scenario(), ref.id)};
    drawStruct(ui, {battery, {}}, "Battery " + battery.id, word);
  }
  if (ref.kind == Kind::vehicle) {
    if (textButton(ui, ui.state.mission.click == GroundClick::goal ? "Setting goals" : "Set goals on the ground", "set goals", ui.state.mission.click == GroundClick::goal))
      ui.state.mission.click = ui.state.mission.click == GroundClick::goal ? GroundClick::select : GroundClick::goal;
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace npsee::editor
