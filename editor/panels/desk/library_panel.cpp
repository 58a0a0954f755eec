// The library: presets as pictures, searched by words and tags, favourites and what was worked on last; missions as a list.

#include "editor/mission/document.h"
#include "editor/panels/panels.h"
#include "editor/ui/controls.h"

#include "sim/core/text.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace npsee::editor {
namespace {

namespace fs = std::filesystem;
using Show = DeskUi::Library::Show;

std::vector<std::string> tagsOf(const std::string& text) {
  std::vector<std::string> out;
  for (const std::string_view tag : splitAt(text, ','))
    if (!trimmed(tag).empty()) out.emplace_back(trimmed(tag));
  return out;
}

bool matches(const LibraryEntry& entry, const DeskUi::Library& my) {
  if (my.tag.empty() && my.word.empty()) return true;
  const auto tags = tagsOf(entry.tags);
  if (!my.tag.empty() && std::ranges::find(tags, my.tag) == tags.end()) return false;
  const std::string all = capitals(entry.title + ' ' + bareName(entry.path) + ' ' + entry.tags + ' ' + entry.description);
  const std::string typed = capitals(my.word);
  return std::ranges::all_of(splitAt(typed, ' '), [&](std::string_view word) { return all.find(word) != std::string::npos; });
}

/// What is listed: the library's own, or files from anywhere that were favoured or worked on.
std::vector<const LibraryEntry*> listed(const PanelContext& ui) {
  const DeskUi::Library& my = ui.state.desk.library;
  std::vector<const LibraryEntry*> out;
  if (my.show == Show::all) {
    for (const LibraryEntry& entry : ui.session.library()) out.push_back(&entry);
  } else {
    std::error_code ignored;
    for (const std::string& file : my.show == Show::recent ? ui.desk.settings.recent : ui.desk.settings.favourites)
      if (fs::is_regular_file(file, ignored))
        if (const LibraryEntry& entry = ui.session.libraryEntry(file); entry.mission == ui.session.inMission()) out.push_back(&entry);
  }
  std::erase_if(out, [&](const LibraryEntry* entry) { return !matches(*entry, my); });
  return out;
}

void drawStar(const PanelContext& ui, const LibraryEntry& entry, ImVec2 centre, bool offered) {
  const bool on = ui.desk.favourite(entry.path);
  if (!on && !offered) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImVec2 points[10];
  for (int i = 0; i < 10; ++i) {
    const float turn = 0.6283185f * static_cast<float>(i) - 1.5707963f, radius = ui.px(i % 2 == 0 ? 7.0f : 3.0f);
    points[i] = {centre.x + radius * std::cos(turn), centre.y + radius * std::sin(turn)};
  }
  list.AddCircleFilled(centre, ui.px(11), faded(ui.theme.background, 0.75f), 24);
  // Filled from the middle: the star is not convex.
  for (int i = 0; on && i < 10; ++i) list.AddTriangleFilled(centre, points[i], points[(i + 1) % 10], ui.theme.accent);
  list.AddPolyline(points, 10, on ? ui.theme.accent : ui.theme.dim, ImDrawFlags_Closed, ui.px(1.2f));
}

/// The star's own button in the corner of an entry. True if the pointer is on it.
bool starButton(const PanelContext& ui, const LibraryEntry& entry, ImVec2 centre, bool offered) {
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({centre.x - ui.px(11), centre.y - ui.px(11)});
  const std::string name = "button:favourite:" + bareName(entry.path);
  if (ImGui::InvisibleButton(name.c_str(), ImVec2(ui.px(22), ui.px(22)))) ui.desk.flipFavourite(entry.path);
  ui.item(name);
  const bool hovered = ImGui::IsItemHovered();
  const std::string tip = ui.desk.favourite(entry.path) ? "No favourite any more" : "Make it a favourite";
  if (ui.resting(name, tip)) tooltip(ui, tip);
  drawStar(ui, entry, centre, offered || hovered);
  ImGui::SetCursorScreenPos(after);
  return hovered;
}

void describe(const PanelContext& ui, const std::string& item, const LibraryEntry& entry) {
  const std::string tags = entry.tags.empty() ? std::string() : "\n" + entry.tags;
  if (ui.resting(item, entry.path.string()) && !entry.description.empty()) tooltip(ui, entry.description + tags);
}

/// A preset as its picture over its title.
void card(const PanelContext& ui, const LibraryEntry& entry, ImVec2 at, ImVec2 size, bool open) {
  ImGui::SetCursorScreenPos(at);
  const std::string item = "preset:" + bareName(entry.path);
  const bool clicked = ImGui::InvisibleButton(item.c_str(), size);
  ImGui::SetItemAllowOverlap();
  ui.item(item);
  const bool hovered = ImGui::IsItemHovered();
  describe(ui, item, entry);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float high = std::floor(size.x * 0.625f);
  if (open || hovered) list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ui.theme.raised, ui.px(4));
  const ImVec2 end{at.x + size.x, at.y + high};
  // A large library is looked at as it comes into view.
  const bool seen = ImGui::IsRectVisible(at, {at.x + size.x, at.y + size.y});
  const fs::path file = entry.readable && seen ? ui.desk.thumbnails().picture(entry.path) : fs::path();
  if (const ImTextureID picture = file.empty() ? nullptr : ui.pictures.file(file)) list.AddImageRounded(picture, at, end, {0, 0}, {1, 1}, IM_COL32_WHITE, ui.px(4));
  else list.AddRectFilled(at, end, ui.theme.background, ui.px(4));
  if (file.empty()) drawIcon(list, Icon::file, {0.5f * (at.x + end.x), 0.5f * (at.y + end.y)}, ui.px(20), entry.readable ? ui.theme.line : ui.theme.error);
  if (open) list.AddRect(at, end, ui.theme.accent, ui.px(4), ImDrawFlags_None, ui.px(2));
  ImGui::PushFont(ui.fonts.small);
  rowText({at.x + ui.px(3), at.y + high}, size.x - ui.px(6), size.y - high, !entry.readable ? ui.theme.error : open ? ui.theme.accent : ui.theme.text, entry.title.empty() ? bareName(entry.path) : entry.title);
  ImGui::PopFont();
  const bool star = starButton(ui, entry, {at.x + size.x - ui.px(13), at.y + ui.px(13)}, hovered);
  if (clicked && !open && !star) ui.session.open(entry.path);
}

/// A mission with its title over the file's name.
void line(const PanelContext& ui, const LibraryEntry& entry, bool open) {
  const std::string name = bareName(entry.path), item = (entry.mission ? "mission:" : "preset:") + name;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(44), inset = ui.px(10);
  const bool clicked = ImGui::InvisibleButton(item.c_str(), ImVec2(width, height));
  ImGui::SetItemAllowOverlap();
  ui.item(item);
  const bool hovered = ImGui::IsItemHovered();
  describe(ui, item, entry);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (open || hovered) list.AddRectFilled(at, {at.x + width, at.y + height}, ui.theme.raised, ui.px(4));
  if (open) list.AddRectFilled({at.x, at.y + ui.px(8)}, {at.x + ui.px(3), at.y + height - ui.px(8)}, ui.theme.accent, ui.px(1));
  const float room = width - 2.0f * inset - ui.px(22);
  rowText({at.x + inset, at.y + ui.px(3)}, room, ui.px(22), !entry.readable ? ui.theme.error : open ? ui.theme.accent : ui.theme.text, entry.title.empty() ? name : entry.title);
  ImGui::PushFont(ui.fonts.small);
  rowText({at.x + inset, at.y + ui.px(22)}, room, ui.px(18), ui.theme.dim, entry.readable ? name : "cannot be read");
  ImGui::PopFont();
  const bool star = starButton(ui, entry, {at.x + width - ui.px(14), at.y + 0.5f * height}, hovered);
  if (clicked && !open && !star) ui.session.open(entry.path);
}

void drawTags(const PanelContext& ui, float width) {
  DeskUi::Library& my = ui.state.desk.library;
  const auto everyTag = [&] {
    std::set<std::string> tags;
    for (const LibraryEntry& entry : ui.session.library())
      for (std::string& tag : tagsOf(entry.tags)) tags.insert(std::move(tag));
    return tags;
  };
  if (!my.tag.empty() && !everyTag().contains(my.tag)) my.tag.clear();
  ImGui::SetNextItemWidth(width);
  const bool open = beginChoice(ui, "tag", my.tag.empty() ? "any tag" : my.tag, !my.tag.empty());
  ui.item("choice:tag");
  if (!open) return;
  const auto offer = [&](const std::string& tag, const char* label) {
    if (ImGui::Selectable(label, my.tag == tag)) my.tag = tag;
    ui.item("choice:tag=" + tag);
  };
  offer("", "any tag");
  for (const std::string& tag : everyTag()) offer(tag, tag.c_str());
  ImGui::EndCombo();
}

void drawFilters(const PanelContext& ui) {
  DeskUi::Library& my = ui.state.desk.library;
  const float width = ImGui::GetContentRegionAvail().x;
  const bool tagged = !ui.session.inMission() && width > ui.px(200);
  const float tag_width = tagged ? std::floor(0.42f * width) : 0.0f;
  ImGui::SetNextItemWidth(width - tag_width - (tagged ? ui.px(4) : 0.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(8), std::floor(0.5f * (ui.px(24) - ImGui::GetFontSize()))));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(4), ui.px(4)));
  ImGui::InputTextWithHint("##library search", ui.session.inMission() ? "find mission" : "find preset", &my.word);
  ui.item("field:library");
  ImGui::PopStyleVar();
  if (tagged) {
    ImGui::SameLine();
    drawTags(ui, ImGui::GetContentRegionAvail().x);
  }
  const struct { Show show; const char *label, *tip; } shown[] = {{Show::all, "All", "What the library's folder holds"}, {Show::favourites, "Favourites", "What has a star"}, {Show::recent, "Recent", "What was worked on last"}};
  for (const auto& [show, label, tip] : shown) {
    if (show != Show::all) ImGui::SameLine();
    if (chip(ui, label, std::string("library ") + label, my.show == show, tip)) my.show = show;
  }
  ImGui::PopStyleVar();
}

std::string emptyText(const PanelContext& ui) {
  const DeskUi::Library& my = ui.state.desk.library;
  if (!my.word.empty() || !my.tag.empty()) return "Nothing fits these words and tags.";
  if (my.show == Show::favourites) return "No favourites yet. The star in a picture's corner makes one.";
  if (my.show == Show::recent) return "Nothing was opened yet.";
  return "Nothing shipped was found. File > Open shows any folder.";
}

}  // namespace

void drawLibraryPanel(const PanelContext& ui) {
  heading(ui, "Library");
  drawLibraryList(ui);
}

void drawLibraryList(const PanelContext& ui) {
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  drawFilters(ui);
  const auto entries = listed(ui);
  std::error_code ignored;
  const auto& path = ui.session.file().path();
  const fs::path now = path.empty() ? path : fs::absolute(path, ignored).lexically_normal();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), ui.px(2)));
  ImGui::BeginChild("library", ImVec2(0, 0));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float gap = ui.px(8), width = ImGui::GetContentRegionAvail().x - ui.px(2);
  const int columns = std::max(1, static_cast<int>((width + gap) / (ui.px(104) + gap)));
  const float wide = std::floor((width + gap) / static_cast<float>(columns) - gap), high = std::floor(wide * 0.625f) + ui.px(22);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const LibraryEntry& entry = *entries[i];
    const bool open = entry.path == now;
    if (ui.session.inMission()) {
      line(ui, entry, open);
      continue;
    }
    const std::size_t each = static_cast<std::size_t>(columns), column = i % each, row = i / each;
    card(ui, entry, {at.x + static_cast<float>(column) * (wide + gap), at.y + static_cast<float>(row) * (high + ui.px(4))}, {wide, high}, open);
  }
  if (entries.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("%s", emptyText(ui).c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace npsee::editor
