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
  else if (listing.entries.empty()) ImGui::TextDisabled("No folders and no presets here.");
  for (const FolderListing::Entry& entry : listing.entries) {
    const bool clicked = listLine(ui, (entry.folder ? "folder:" : "file:") + entry.name, entry.folder ? Icon::folder : Icon::file, entry.name, entry.name == session.files.name);
    if (!clicked) continue;
    if (entry.folder) session.enterFolder(listing.folder / entry.name);
    else session.files.name = entry.name;
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
  const float below = ui.px(26 + 8 + 34);
  ImGui::BeginChild("entries", ImVec2(0, ImGui::GetContentRegionAvail().y - below));
  drawEntries(ui);
  ImGui::EndChild();
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputTextWithHint("##name", "file name or path", &session.files.name, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ui.item("field:file name");
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  const bool confirmed = textButton(ui, saving ? "Save" : "Open", saving ? "save as" : "open", true);
  ImGui::SameLine();
  const bool cancelled = textButton(ui, "Close", "close files");
  const bool escaped = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (entered || confirmed) session.confirmFiles();
  else if (cancelled || escaped) session.closeFiles();
}

void drawLibraryPanel(const PanelContext& ui) {
  heading(ui, "Library");
  const FolderListing& library = ui.session.library();
  ImGui::BeginChild("library", ImVec2(0, 0));
  bool any = false;
  for (const FolderListing::Entry& entry : library.entries) {
    if (entry.folder) continue;
    any = true;
    const std::filesystem::path path = library.folder / entry.name;
    std::string name = entry.name.substr(0, entry.name.size() - std::string_view(".npsee.json").size());
    std::error_code ignored;
    const bool open = !ui.session.document.path().empty() && std::filesystem::absolute(ui.session.document.path(), ignored).lexically_normal() == path;
    if (listLine(ui, "preset:" + name, Icon::file, name, open) && !open) ui.session.open(path);
    if (ui.resting("preset:" + name, path.string())) tooltip(ui, "Open " + path.string());
  }
  if (!any) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("No shipped presets were found. File > Open shows any folder.");
    ImGui::PopTextWrapPos();
  }
  ImGui::EndChild();
}

}  // namespace npsee::editor
