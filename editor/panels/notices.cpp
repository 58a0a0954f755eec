#include "editor/panels/panels.h"
#include "editor/ui/controls.h"

namespace npsee::editor {
namespace {

/// A strip over the whole width whose height follows its words. `draw` fills the right end.
template <class Draw>
void strip(const PanelContext& ui, const char* id, ImU32 edge, const std::string& text, float room, const Draw& draw) {
  const float width = ImGui::GetContentRegionAvail().x, inset = ui.px(12), wrap = width - room - 2.0f * inset;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
  const float height = std::max(size.y + ui.px(14), ui.px(38));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ui.theme.raised);
  ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.line);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ui.theme.dim);
  ImGui::BeginChild(id, ImVec2(width, height), false, ImGuiWindowFlags_NoScrollbar);
  const ImVec2 at = ImGui::GetWindowPos();
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + ui.px(4), at.y + height}, edge);
  ImGui::SetCursorPos({inset, std::floor(0.5f * (height - size.y))});
  ImGui::PushTextWrapPos(inset + wrap);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::SetCursorPos({width - room - inset + ui.px(8), std::floor(0.5f * (height - ui.px(26)))});
  draw();
  ImGui::EndChild();
  ImGui::PopStyleColor(3);
  ui.item(id);
}

void drawQuestion(const PanelContext& ui) {
  const Session& session = ui.session;
  const char* next = session.asking() == Intent::quit ? "quitting" : session.asking() == Intent::open ? "opening another file" : session.inMission() ? "starting a new mission" : "starting a new preset";
  const std::string text = "\"" + session.askingAbout() + "\" has changes that are not saved. Save them before " + next + "?";
  strip(ui, "strip:question", ui.theme.accent, text, ui.px(196), [&] {
    if (textButton(ui, "Save", "save", true)) ui.session.answer(Answer::save);
    ImGui::SameLine();
    if (textButton(ui, "Discard", "discard")) ui.session.answer(Answer::discard);
    ImGui::SameLine();
    if (textButton(ui, "Cancel", "cancel")) ui.session.answer(Answer::cancel);
  });
}

}  // namespace

void drawNotices(const PanelContext& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), 0));
  if (ui.session.asking() != Intent::none) drawQuestion(ui);
  Notices& notices = ui.session.notices;
  if (!notices.error.empty())
    strip(ui, "strip:error", ui.theme.error, notices.error, ui.px(40), [&] {
      if (iconButton(ui, Icon::cross, "dismiss", "Dismiss this message")) notices.error.clear();
    });
  ImGui::PopStyleVar();
}

}  // namespace npsee::editor
