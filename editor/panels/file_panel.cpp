#include "editor/panels/panels.h"
#include "editor/ui/controls.h"

#include <imgui_stdlib.h>

#include <cmath>

namespace npsee::editor {
namespace {

/// One line of a list with an icon. Returns true when clicked.
bool listLine(const PanelContext& ui, const std::string& name, Icon icon, const std::string& text, bool chosen) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(26);
  const bool clicked = ImGui::InvisibleButton(name.c_str(), ImVec2(width, height));
  ui.item(name);
  if (chosen || ImGui::IsItemHovered()) ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + width, at.y + height}, chosen ? ui.theme.line : ui.theme.raised, ui.px(4));
  drawIcon(*ImGui::GetWindowDrawList(), icon, {at.x + ui.px(13), at.y + 0.5f * height}, ui.px(13), ui.theme.dim);
  rowText({at.x + ui.px(28), at.y}, width - ui.px(32), height, chosen ? ui.theme.accent : ui.theme.text, text);
  return clicked;
}

void drawEntries(const PanelContext& ui) {
  Session& session = ui.session;
  const FolderListing listing = session.files.listing;  // a copy: entering a folder replaces it while it is drawn
  if (!listing.problem.empty()) ImGui::TextWrapped("%s", listing.problem.c_str());
  else if (listing.entries.empty()) ImGui::TextDisabled("No folders, presets or missions here.");
  for (const FolderListing::Entry& entry : listing.entries) {
    const bool clicked = listLine(ui, (entry.folder ? "folder:" : "file:") + entry.name, entry.folder ? Icon::folder : Icon::file, entry.name, entry.name == session.files.name);
    if (!clicked && !(ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))) continue;
    if (entry.folder) session.enterFolder(listing.folder / entry.name);
    else session.files.name = entry.name;
    if (!entry.folder && !clicked && session.files.mode == FilePanel::Mode::open) return session.confirmFiles();
  }
  if (listing.shortened) ImGui::TextDisabled("Only the first %zu are listed; type a name.", FolderListing::kMaxEntries);
}

}  // namespace

void drawFilePanel(const PanelContext& ui) {
  Session& session = ui.session;
  const bool saving = session.files.mode == FilePanel::Mode::save_as;
  heading(ui, saving ? "Save as" : "Open");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  if (iconButton(ui, Icon::up, "up", "The folder above")) session.enterFolder(session.files.listing.folder.parent_path());
  rowText({at.x + ui.px(32), at.y}, width - ui.px(32), ui.px(26), ui.theme.dim, session.files.listing.folder.string());
  const bool replaces = !session.files.replacing.empty();
  const float below = ui.px(replaces ? 26 + 8 + 34 + 44 : 26 + 8 + 34);
  ImGui::BeginChild("entries", ImVec2(0, ImGui::GetContentRegionAvail().y - below));
  drawEntries(ui);
  ImGui::EndChild();
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputTextWithHint("##name", "file name or path", &session.files.name, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ui.item("field:file name");
  if (ImGui::IsItemEdited()) session.files.replacing.clear();
  if (replaces) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(ui.theme.accent), "%s exists. Replace it, or choose another name.", session.files.replacing.filename().c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  const bool confirmed = textButton(ui, replaces ? "Replace" : saving ? "Save" : "Open", saving ? "save as" : "open", true);
  ImGui::SameLine();
  const bool cancelled = textButton(ui, "Close", "close files");
  const bool escaped = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (entered || confirmed) session.confirmFiles();
  else if (cancelled || escaped) session.closeFiles();
}

}  // namespace npsee::editor
