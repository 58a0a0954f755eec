#include "editor/document/clipboard.h"
#include "editor/panels/design_actions.h"
#include "editor/panels/panels.h"
#include "editor/panels/vary_strip.h"
#include "editor/ui/controls.h"

#include <imgui_stdlib.h>

#include <array>
#include <span>
#include <vector>

namespace npsee::editor {
namespace {

// What is shaped most often stands first; a section's rows are those of the table.
constexpr std::array kOrder{Section::burst, Section::region, Section::launch, Section::time, Section::flight, Section::ground,
                            Section::look, Section::pieces, Section::layer, Section::hierarchy, Section::surroundings, Section::about};

/// Searched for, it shows the controls that the thesis's editor had.
constexpr std::string_view kThesisWord = "1993";

bool contains(std::string_view text, const std::string& word) { return capitals(text).find(word) != std::string::npos; }

bool matches(const Parameter& parameter, const std::string& word) {
  if (word == kThesisWord) return !parameter.thesis.empty();
  return word.empty() || contains(parameter.label, word) || contains(parameter.key, word) || contains(parameter.thesis, word) || contains(title(parameter.section), word);
}

/// True if a script wants a row of that parameter, to type in it or to use its widgets.
bool asked(const PanelContext& ui, const Parameter& parameter) {
  const std::string name = parameterName(ui.session.document, parameter);
  const std::string& wanted = ui.items.wanted();
  return ui.state.typed.contains(name) || (!wanted.empty() && wanted.ends_with(name));
}

std::vector<const Parameter*> rowsOf(const PanelContext& ui, Section section, const std::string& word) {
  std::vector<const Parameter*> out;
  for (const Parameter& parameter : parameters()) {
    if (parameter.section != section || (parameter.scope == Scope::layer && !ui.session.document.hasLayer())) continue;
    if (matches(parameter, word)) out.push_back(&parameter);
  }
  return out;
}

/// All parameters of a section back to their defaults, as one step.
void resetSection(const PanelContext& ui, Section section) {
  Document& document = ui.session.document;
  ui.session.took(document.edit("Reset " + std::string(title(section)), {}, [&](Preset& preset) {
    for (const Parameter& row : parameters()) {
      if (row.section != section || row.key == "name") continue;
      if (row.scope == Scope::burst) row.assign(preset, row.initial);
      else if (document.hasLayer()) row.assign(preset.layers[static_cast<std::size_t>(document.selected())], row.initial);
    }
  }));
}

void sectionMenu(const PanelContext& ui, Section section) {
  const std::string name(title(section));
  contextMenu(ui, ("menu:section:" + name).c_str(), [&] {
    const auto entry = [&](const std::string& label) {
      const bool chosen = ImGui::MenuItem(label.c_str());
      ui.item("item:" + label);
      return chosen;
    };
    const Document& document = ui.session.document;
    if (entry("Copy " + name)) {
      ImGui::SetClipboardText(sectionText(document.preset(), document.hasLayer() ? &document.layer() : nullptr, section).c_str());
      ui.session.notices.note = "Copied " + name + " to the clipboard, as text.";
    }
    if (entry("Paste")) pasteClipboard(ui);
    ImGui::Separator();
    if (entry("Reset " + name)) resetSection(ui, section);
    if (document.hasLayer() && entry("Randomise " + name)) varyLayers(ui, document.selected(), section);
  });
}

void drawSection(const PanelContext& ui, Section section, std::span<const Parameter* const> rows, const std::string& word) {
  for (const Parameter* row : rows)
    if (asked(ui, *row)) ui.state.folded.erase(section);
  // A search shows what it found.
  const bool folded = word.empty() && ui.state.folded.contains(section);
  if (foldingHeading(ui, std::string(title(section)), folded) && word.empty()) {
    if (!ui.state.folded.erase(section)) ui.state.folded.insert(section);
  }
  ui.resting("section:" + std::string(title(section)), "Click folds it; the right button copies, pastes, resets or randomises all its parameters.");
  sectionMenu(ui, section);
  if (folded) return;
  for (const Parameter* row : rows) drawParameterRow(ui, *row);
  ImGui::Dummy(ImVec2(1, ui.px(6)));
}

void drawSearch(const PanelContext& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::SetNextItemWidth(ui.state.search.empty() ? width : width - ui.px(30));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(10), std::floor(0.5f * (ui.px(28) - ImGui::GetFontSize()))));
  ImGui::InputTextWithHint("##search", "find parameter, or 1993 for the thesis's", &ui.state.search);
  ImGui::PopStyleVar();
  ui.item("field:search");
  if (ui.state.search.empty()) return;
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({at.x + width - ui.px(26), at.y + ui.px(1)});
  if (iconButton(ui, Icon::cross, "clear search", "Show all parameters")) ui.state.search.clear();
  ImGui::SetCursorScreenPos(below);
}

}  // namespace

void drawParameterPanel(const PanelContext& ui) {
  drawSearch(ui);
  drawVaryStrip(ui);
  for (const Parameter& parameter : parameters())
    if ((parameter.scope == Scope::burst || ui.session.document.hasLayer()) && asked(ui, parameter)) ui.state.search.clear();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), 0));
  ImGui::BeginChild("parameters", ImVec2(0, 0), false, ImGuiWindowFlags_NoBackground);
  const std::string word = capitals(ui.state.search);
  bool any = false;
  ui.state.tabbing.before.clear();
  for (const Section section : kOrder) {
    const auto rows = rowsOf(ui, section, word);
    if (rows.empty()) continue;
    any = true;
    drawSection(ui, section, rows, word);
  }
  if (!any) ImGui::TextDisabled("No parameter has \"%s\" in its name.", ui.state.search.c_str());
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace npsee::editor
