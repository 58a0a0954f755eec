#include "editor/panels/desk/sheets.h"

#include "editor/ui/controls.h"

namespace npsee::editor {

using Sheet = DeskUi::Sheet;

bool sheetOpen(const PanelContext& ui) { return ui.state.desk.sheet != Sheet::none; }

void drawSheet(const PanelContext& ui) {
  switch (ui.state.desk.sheet) {
    case Sheet::history: drawHistorySheet(ui); break;
    case Sheet::palette: drawPaletteSheet(ui); break;
    case Sheet::messages: drawMessagesSheet(ui); break;
    case Sheet::exports: drawExportSheet(ui); break;
    case Sheet::none: return;
  }
  // The question about unsaved work and fields keep their Escape.
  if (!ImGui::GetIO().WantTextInput && ui.session.asking() == Intent::none && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) ui.state.desk.sheet = Sheet::none;
}

void sheetHeading(const PanelContext& ui, const char* title) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  heading(ui, title);
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({at.x + width - ui.px(24), at.y});
  if (iconButton(ui, Icon::cross, "close sheet", "Close (Escape)", false, 24)) ui.state.desk.sheet = Sheet::none;
  ImGui::SetCursorScreenPos(below);
}

namespace {

void historyLine(const PanelContext& ui, int step, int now, const std::string& label) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(26);
  const std::string name = "history:" + std::to_string(step);
  const bool clicked = ImGui::InvisibleButton(name.c_str(), ImVec2(width, height));
  ui.item(name);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool here = step == now;
  if (here || ImGui::IsItemHovered()) list.AddRectFilled(at, {at.x + width, at.y + height}, here ? ui.theme.line : ui.theme.raised, ui.px(4));
  rowText({at.x + ui.px(8), at.y}, width - ui.px(14), height, here ? ui.theme.accent : step > now ? ui.theme.dim : ui.theme.text, label);
  if (ui.resting(name, here ? "What is shown now." : step < now ? "A click goes back to here." : "Undone; a click brings it back.")) {}
  // What is scrolled to follows undo and redo, not the wheel.
  if (here && ui.state.desk.shown_step != now) {
    ImGui::SetScrollHereY(0.5f);
    ui.state.desk.shown_step = now;
  }
  if (!clicked || here) return;
  ui.session.endMerge();
  ui.session.file().jump(step - now);
}

}  // namespace

void drawHistorySheet(const PanelContext& ui) {
  sheetHeading(ui, "History");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), 0));
  ImGui::BeginChild("history", ImVec2(0, 0));
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  const auto undone = ui.session.file().undoLabels(), redone = ui.session.file().redoLabels();
  const int now = static_cast<int>(undone.size());
  const bool whole = undone.size() < History::kMaxSteps;
  historyLine(ui, 0, now, !whole ? "Oldest step kept" : ui.session.file().path().empty() ? "As it began" : "As it was opened");
  for (int i = 0; i < now; ++i) historyLine(ui, i + 1, now, undone[static_cast<std::size_t>(i)]);
  for (int i = 0; i < static_cast<int>(redone.size()); ++i) historyLine(ui, now + i + 1, now, redone[static_cast<std::size_t>(i)]);
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

void drawMessagesSheet(const PanelContext& ui) {
  sheetHeading(ui, "Messages");
  ImGui::BeginChild("messages", ImVec2(0, 0));
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  ImGui::PushTextWrapPos(0);
  const auto& messages = ui.desk.messages();
  if (messages.empty()) ImGui::TextDisabled("Nothing was told yet.");
  int number = 0;
  for (auto message = messages.rbegin(); message != messages.rend(); ++message) {
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(message->error ? ui.theme.error : ui.theme.text), "%s", message->text.c_str());
    ui.item("message:" + std::to_string(number++));
    ImGui::Dummy(ImVec2(1, ui.px(4)));
  }
  ImGui::PopTextWrapPos();
  ImGui::EndChild();
}

}  // namespace npsee::editor
