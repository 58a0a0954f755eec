#include "editor/ui/slider.h"

#include <imgui_stdlib.h>

namespace npsee::editor {
namespace {

/// Tab would complete the text: here it ends the typing, to go on with another row.
int onTab(ImGuiInputTextCallbackData* data) {
  *static_cast<int*>(data->UserData) = ImGui::GetIO().KeyShift ? -1 : 1;
  return 0;
}

}  // namespace

std::optional<std::string> typingField(const PanelContext& ui, const Box& box, bool several_lines) {
  UiState::Typing& typing = ui.state.typing;
  typing.shown = true;
  ImGui::SetCursorScreenPos({box.at.x, box.at.y + ui.px(1)});
  ImGui::SetNextItemWidth(box.width);
  if (typing.fresh) ImGui::SetKeyboardFocusHere();
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1.0f);
  ImGui::PushStyleColor(ImGuiCol_Border, typing.wrong.empty() ? ui.theme.accent : ui.theme.error);
  ImGui::PushID(typing.name.c_str());  // another row's field is another field, also in the frame in which Tab changes them
  const bool entered = several_lines ? ImGui::InputTextMultiline("##typing", &typing.text, ImVec2(box.width, box.height), ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CtrlEnterForNewLine)
                                     : ImGui::InputText("##typing", &typing.text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CallbackCompletion, onTab, &typing.tab);
  ImGui::PopID();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ui.item("field:" + typing.name);
  if (ImGui::IsItemActive()) typing.fresh = false;
  if (entered || (typing.tab != 0 && !typing.fresh)) return typing.text;
  if (typing.fresh || !ImGui::IsItemDeactivated()) return std::nullopt;
  // Escape takes nothing, and neither does leaving a field whose text was refused before.
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)) || !typing.wrong.empty()) {
    typing = {};
    return std::nullopt;
  }
  return typing.text;
}

}  // namespace npsee::editor
