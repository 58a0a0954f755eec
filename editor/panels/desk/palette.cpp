// Commands, parameters and presets by a few letters of their name.

#include "editor/panels/actions.h"
#include "editor/panels/desk/sheets.h"
#include "editor/ui/controls.h"
#include "editor/ui/slider.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace npsee::editor {
namespace {

constexpr std::size_t kMostShown = 60;

struct Entry {
  std::string name;   ///< as scripts call it, after "found:"
  std::string label;
  std::string where;  ///< menu, section or kind
  std::string key;
  std::function<void()> run;
  int rank = 0;
};

/// How well a name fits the letters typed: 0 best, -1 not at all. All words must be there in any order; the start of the name, then the start
/// of a word, count more than the middle.
int rankOf(const std::string& name, const std::string& typed) {
  int rank = 0;
  for (std::size_t at = 0; at < typed.size();) {
    const std::size_t end = std::min(typed.find(' ', at), typed.size());
    const std::string word = typed.substr(at, end - at);
    at = end + 1;
    if (word.empty()) continue;
    const std::size_t found = name.find(word);
    if (found == std::string::npos) return -1;
    rank += found == 0 ? 0 : name[found - 1] == ' ' ? 1 : 2;
  }
  return rank;
}

void addActions(const PanelContext& ui, std::vector<Entry>& out) {
  for (const Action& action : actions()) {
    if (!action.here(ui) || (action.enabled != nullptr && !action.enabled(ui))) continue;
    out.push_back({std::string(action.label), std::string(action.label), std::string(action.menu), shortcutText(action),
                   [&ui, run = action.run] { run(ui); }});
  }
}

/// Parameters of the burst and of the selected layer: their row is unfolded, scrolled into view, and its value typed.
void addParameters(const PanelContext& ui, std::vector<Entry>& out) {
  if (ui.session.inMission()) return;
  for (const Parameter& parameter : parameters()) {
    if (parameter.scope == Scope::layer && !ui.session.document.hasLayer()) continue;
    const std::string name = parameterName(ui.session.document, parameter);
    out.push_back({name, std::string(parameter.label), parameter.scope == Scope::layer ? ui.session.document.layer().name : std::string(title(parameter.section)), std::string(parameter.key), [&ui, &parameter, name] {
                     ui.state.show_right = true;
                     ui.state.search.clear();
                     ui.items.want("row:" + name);
                     if (parameter.type == ParameterType::number || parameter.type == ParameterType::integer) beginTyping(ui, name, valueText(parameter, ui.session.document.value(parameter), true));
                   }});
  }
}

void addFiles(const PanelContext& ui, std::vector<Entry>& out) {
  for (const LibraryEntry& entry : ui.session.library()) {
    if (!entry.readable) continue;
    const std::string name = bareName(entry.path);
    out.push_back({name, entry.title.empty() ? name : entry.title, "open", name, [&ui, path = entry.path] { ui.session.open(path); }});
  }
}

std::vector<Entry> found(const PanelContext& ui, const std::string& typed) {
  std::vector<Entry> out;
  addActions(ui, out);
  addParameters(ui, out);
  addFiles(ui, out);
  const std::string word = capitals(typed);
  for (Entry& entry : out) entry.rank = rankOf(capitals(entry.label + ' ' + entry.key + ' ' + entry.where), word);
  std::erase_if(out, [](const Entry& entry) { return entry.rank < 0; });
  std::ranges::stable_sort(out, {}, &Entry::rank);
  if (out.size() > kMostShown) out.resize(kMostShown);
  return out;
}

bool entryLine(const PanelContext& ui, const Entry& entry, bool chosen) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(40);
  const std::string name = "found:" + entry.name;
  const bool clicked = ImGui::InvisibleButton(name.c_str(), ImVec2(width, height));
  ui.item(name);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (chosen || ImGui::IsItemHovered()) list.AddRectFilled(at, {at.x + width, at.y + height}, chosen ? ui.theme.line : ui.theme.raised, ui.px(4));
  rowText({at.x + ui.px(8), at.y + ui.px(2)}, width - ui.px(14), ui.px(20), chosen ? ui.theme.accent : ui.theme.text, entry.label);
  ImGui::PushFont(ui.fonts.small);
  const float taken = ImGui::CalcTextSize(entry.key.c_str()).x + ui.px(16);
  rowText({at.x + ui.px(8), at.y + ui.px(20)}, std::max(width - taken - ui.px(12), 1.0f), ui.px(18), ui.theme.dim, entry.where);
  rowTextRight(at.x + width - ui.px(8), at.y + ui.px(20), ui.px(18), ui.theme.dim, entry.key);
  ImGui::PopFont();
  return clicked;
}

/// Up, down and Enter belong to the list while the field is typed in.
bool chooseByKeys(DeskUi::Palette& my, int count) {
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
  const int before = my.chosen;
  if (pressed(ImGuiKey_DownArrow)) ++my.chosen;
  if (pressed(ImGuiKey_UpArrow)) --my.chosen;
  my.chosen = std::clamp(my.chosen, 0, std::max(0, count - 1));
  my.follow = my.follow || my.chosen != before;
  return count > 0 && (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter));
}

}  // namespace

void drawPaletteSheet(const PanelContext& ui) {
  DeskUi::Palette& my = ui.state.desk.palette;
  sheetHeading(ui, "Find");
  ImGui::SetNextItemWidth(-1);
  if (my.fresh) ImGui::SetKeyboardFocusHere();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(10), std::floor(0.5f * (ui.px(28) - ImGui::GetFontSize()))));
  ImGui::InputTextWithHint("##find", "command, parameter or preset", &my.word);
  ImGui::PopStyleVar();
  ui.item("field:find");
  const bool typing = ImGui::IsItemActive();
  if (typing) my.fresh = false;
  if (ImGui::IsItemEdited()) my.chosen = 0;
  const bool escaped = ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  const bool entered_field = ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter));
  const auto entries = found(ui, my.word);
  const bool entered = (typing || entered_field) && chooseByKeys(my, static_cast<int>(entries.size()));
  std::function<void()> run = entered ? entries[static_cast<std::size_t>(my.chosen)].run : std::function<void()>();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), ui.px(2)));
  ImGui::BeginChild("found", ImVec2(0, 0));
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  for (int i = 0; i < static_cast<int>(entries.size()); ++i) {
    if (entryLine(ui, entries[static_cast<std::size_t>(i)], i == my.chosen)) run = entries[static_cast<std::size_t>(i)].run;
    if (i == my.chosen && std::exchange(my.follow, false)) ImGui::SetScrollHereY(0.5f);
  }
  if (entries.empty()) ImGui::TextDisabled("Nothing has these words in its name.");
  ImGui::EndChild();
  ImGui::PopStyleVar();
  if (run || escaped) ui.state.desk.sheet = DeskUi::Sheet::none;
  if (run) run();
}

}  // namespace npsee::editor
