#include "editor/panels/desk/sheets.h"
#include "editor/panels/panels.h"
#include "editor/panels/strip.h"
#include "editor/ui/controls.h"

namespace npsee::editor {
namespace {

/// After the strip was drawn. Editing goes on beside the question, so that what takes something for good counts only where it is meant: Delete, which
/// editing uses too, with the pointer over the strip.
void answerByKeys(const PanelContext& ui) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput || io.KeyCtrl || io.KeyShift || io.KeyAlt || ui.session.files.mode != FilePanel::Mode::closed) return;
  const bool over = ImGui::IsMouseHoveringRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()) && !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); };
  if (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter)) ui.session.answer(Answer::save);
  else if (pressed(ImGuiKey_Escape)) ui.session.answer(Answer::cancel);
  else if (over && pressed(ImGuiKey_Delete)) ui.session.answer(Answer::discard);
}

/// Quitting takes exports with it.
void drawExportQuestion(const PanelContext& ui) {
  const int count = ui.session.exporting;
  const bool waits = ui.session.waitingForExports();
  const std::string what = count == 1 ? "An export is at work" : std::to_string(count) + " exports are at work";
  const std::string text = waits ? what + ". The editor closes when " + (count == 1 ? "it is" : "they are") + " done." : what + ", which quitting cancels. Quit when " + (count == 1 ? "it is" : "they are") + " done?";
  strip(ui, "strip:question", ui.theme.accent, text, waits ? ui.px(196) : ui.px(290), [&] {
    if (!waits && textButton(ui, "When done", "quit when done", true)) ui.session.answer(Answer::save);
    if (!waits) ImGui::SameLine();
    if (textButton(ui, "Cancel export", "cancel exports and quit")) ui.session.answer(Answer::discard);
    ImGui::SameLine();
    if (textButton(ui, "Stay", "stay")) ui.session.answer(Answer::cancel);
  });
  ui.resting("strip:question", "Enter waits for it, Escape stays, Delete with the pointer here cancels it and quits.");
  answerByKeys(ui);
}

void drawQuestion(const PanelContext& ui) {
  const Session& session = ui.session;
  if (session.askingAboutExports()) return drawExportQuestion(ui);
  const char* next = session.asking() == Intent::quit ? "quitting" : session.asking() == Intent::open ? "opening another file" : session.asking() == Intent::recover ? "bringing back other unsaved work" : session.inMission() ? "starting a new mission" : "starting a new preset";
  const std::string text = "\"" + session.askingAbout() + "\" has changes that are not saved. Save them before " + next + "?";
  strip(ui, "strip:question", ui.theme.accent, text, ui.px(196), [&] {
    if (textButton(ui, "Save", "save", true)) ui.session.answer(Answer::save);
    ImGui::SameLine();
    if (textButton(ui, "Discard", "discard")) ui.session.answer(Answer::discard);
    ImGui::SameLine();
    if (textButton(ui, "Cancel", "cancel")) ui.session.answer(Answer::cancel);
  });
  ui.resting("strip:question", "Enter saves, Escape cancels, Delete with the pointer here discards.");
  answerByKeys(ui);
}

}  // namespace

void drawNotices(const PanelContext& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), 0));
  if (ui.session.asking() != Intent::none) drawQuestion(ui);
  drawDeskNotices(ui);
  Notices& notices = ui.session.notices;
  if (!notices.error.empty())
    strip(ui, "strip:error", ui.theme.error, notices.error, ui.px(40), [&] {
      if (iconButton(ui, Icon::cross, "dismiss", "Dismiss this message")) notices.error.clear();
    });
  ImGui::PopStyleVar();
}

}  // namespace npsee::editor
