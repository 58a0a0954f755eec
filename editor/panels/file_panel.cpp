#include "editor/mission/document.h"
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

namespace {

/// A preset with its title over the file's name.
void libraryLine(const PanelContext& ui, const LibraryEntry& entry, bool open) {
  const std::string file = entry.path.filename().string(), name = file.substr(0, file.find('.', 1));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(44), inset = ui.px(10);
  const std::string item = (isMissionFile(entry.path) ? "mission:" : "preset:") + name;
  const bool clicked = ImGui::InvisibleButton(item.c_str(), ImVec2(width, height));
  ui.item(item);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (open || ImGui::IsItemHovered()) list.AddRectFilled(at, {at.x + width, at.y + height}, ui.theme.raised, ui.px(4));
  if (open) list.AddRectFilled({at.x, at.y + ui.px(8)}, {at.x + ui.px(3), at.y + height - ui.px(8)}, ui.theme.accent, ui.px(1));
  rowText({at.x + inset, at.y + ui.px(3)}, width - 2.0f * inset, ui.px(22), !entry.readable ? ui.theme.error : open ? ui.theme.accent : ui.theme.text, entry.title.empty() ? name : entry.title);
  ImGui::PushFont(ui.fonts.small);
  rowText({at.x + inset, at.y + ui.px(22)}, width - 2.0f * inset, ui.px(18), ui.theme.dim, entry.readable ? name : "cannot be read");
  ImGui::PopFont();
  if (ui.resting(item, entry.path.string()) && !entry.description.empty()) tooltip(ui, entry.description);
  if (clicked && !open) ui.session.open(entry.path);
}

}  // namespace

void drawLibraryPanel(const PanelContext& ui) {
  heading(ui, "Library");
  drawLibraryList(ui);
}

void drawLibraryList(const PanelContext& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), ui.px(2)));
  ImGui::BeginChild("library", ImVec2(0, 0));
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  std::error_code ignored;
  const auto& path = ui.session.file().path();
  const std::filesystem::path now = path.empty() ? path : std::filesystem::absolute(path, ignored).lexically_normal();
  for (const LibraryEntry& entry : ui.session.library()) libraryLine(ui, entry, entry.path == now);
  if (ui.session.library().empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("Nothing shipped was found. File > Open shows any folder.");
    ImGui::PopTextWrapPos();
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace npsee::editor
