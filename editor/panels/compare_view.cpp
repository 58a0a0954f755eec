#include "editor/panels/compare_view.h"

#include "editor/panels/desk/view_tools.h"
#include "editor/ui/controls.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {
namespace {

/// A name on the picture, "A  the kept state", from `left` or up to `right`.
void drawName(const PanelContext& ui, float x, float y, bool right, float room, const std::string& letter, const std::string& name) {
  ImGui::PushFont(ui.fonts.small);
  const float height = ui.px(22), letter_width = ImGui::CalcTextSize(letter.c_str()).x, wish = letter_width + ui.px(22) + ImGui::CalcTextSize(name.c_str()).x;
  const float width = std::min(wish, room);
  if (width > ui.px(30)) {
    const ImVec2 at{right ? x - width : x, y};
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + width, at.y + height}, faded(ui.theme.background, 0.82f), ui.px(4));
    rowText({at.x + ui.px(8), at.y}, letter_width + 1.0f, height, ui.theme.accent, letter);
    rowText({at.x + ui.px(14) + letter_width, at.y}, width - letter_width - ui.px(20), height, ui.theme.text, name);
  }
  ImGui::PopFont();
}

/// What stands where A would: B's picture is none of A.
void drawAbsence(const PanelContext& ui, const Box& box, float width) {
  const std::string& fault = ui.session.compare.shelf.fault(0);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(box.at, {box.at.x + width, box.end().y}, ui.theme.background);
  list.PushClipRect(box.at, {box.at.x + width, box.end().y}, true);
  const std::string words = fault.empty() ? "A is being computed" : "A cannot be shown.\n" + fault;
  const float room = std::max(width - ui.px(40), ui.px(60));
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {box.at.x + ui.px(20), std::floor(box.at.y + 0.4f * box.height)}, fault.empty() ? ui.theme.dim : ui.theme.error, words.c_str(), nullptr, room);
  list.PopClipRect();
}

void dragDivider(const PanelContext& ui, const Box& box) {
  Compare& compare = ui.session.compare;
  const float x = std::floor(box.at.x + static_cast<float>(compare.split) * box.width), half = ui.px(6);
  ImGui::SetCursorScreenPos({x - half, box.at.y + ui.px(80)});
  ImGui::InvisibleButton("compare:divider", ImVec2(2.0f * half, std::max(box.height - ui.px(126), 1.0f)));
  ui.item("compare:divider");
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActive()) compare.split = std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - box.at.x) / box.width), 0.02, 0.98);
  ui.resting("compare:divider", "Left of it A, right of it B; drag it.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({x - 1.0f, box.at.y}, {x + 1.0f, box.end().y}, lit ? ui.theme.accent : ui.theme.text);
  const float middle = std::floor(box.at.y + 0.5f * box.height);
  list.AddRectFilled({x - ui.px(4), middle - ui.px(16)}, {x + ui.px(4), middle + ui.px(16)}, lit ? ui.theme.accent : ui.theme.text, ui.px(3));
}

/// What A can be: the kept state, what the file holds, a state to undo to, a preset of the library.
void drawChoice(const PanelContext& ui, float width) {
  Session& session = ui.session;
  ImGui::SetNextItemWidth(width);
  if (!beginChoice(ui, "compare", "A: " + session.compare.name)) {
    ui.item("choice:compare");
    return;
  }
  const auto entry = [&](const std::string& label, const std::string& key) {
    const bool chosen = ImGui::Selectable((label + "##" + key).c_str(), false, 0, ImVec2(0, ui.px(22)));
    ui.item("choice:compare=" + key);
    return chosen;
  };
  if (entry("The state now", "now")) session.keepForComparing();
  const auto labels = session.document.history().undoLabels();
  for (std::size_t back = 1; back <= std::min<std::size_t>(labels.size(), 12); ++back)
    if (entry("Before: " + labels[labels.size() - back], "undo " + std::to_string(back))) session.compareWithUndo(back);
  if (!session.presets().empty()) ImGui::Separator();
  for (const LibraryEntry& preset : session.presets())
    if (preset.readable && entry(preset.title.empty() ? preset.path.filename().string() : preset.title, preset.path.filename().string())) session.compareWithFile(preset.path);
  ImGui::EndCombo();
}

/// The strip above the picture.
void drawStrip(const PanelContext& ui, const Box& box) {
  Compare& compare = ui.session.compare;
  const float choice = std::clamp(0.4f * box.width, ui.px(110), ui.px(230));
  const float chips = chipWidth(ui, "Split") + chipWidth(ui, "Flip") + chipWidth(ui, "Swap");
  const float width = choice + chips + ui.px(44), x = std::floor(box.at.x + 0.5f * (box.width - width)), y = box.at.y + ui.px(42);
  ImGui::GetWindowDrawList()->AddRectFilled({x, y}, {x + width, y + ui.px(32)}, faded(ui.theme.background, 0.9f), ui.px(4));
  ImGui::SetCursorScreenPos({x + ui.px(4), y + ui.px(4)});
  drawChoice(ui, choice);
  float at = x + choice + ui.px(8);
  const auto button = [&](const char* label, const char* name, bool on, const char* tip) {
    ImGui::SetCursorScreenPos({at, y + ui.px(5)});
    at += chipWidth(ui, label);
    return chip(ui, label, name, on, tip);
  };
  if (button("Split", "split", compare.mode == Compare::Mode::split, "A left, B right of a line (C)")) compare.mode = Compare::Mode::split;
  if (button("Flip", "flip", compare.mode == Compare::Mode::flip, "A or B, in turn (X)")) compare.mode = Compare::Mode::flip;
  if (button("Swap", "swap", false, "Edit A instead, and keep B to compare with; one undo step")) ui.session.swapCompared();
  ImGui::SetCursorScreenPos({x + width - ui.px(30), y + ui.px(3)});
  if (iconButton(ui, Icon::cross, "end comparing", "Compare no longer")) compare.mode = Compare::Mode::off;
}

}  // namespace

void drawCompare(const PanelContext& ui, const Box& box) {
  Compare& compare = ui.session.compare;
  if (!compare.on()) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool split = compare.mode == Compare::Mode::split;
  const auto share = static_cast<float>(split ? compare.split : compare.flipped ? 1.0 : 0.0);
  if (share > 0.0f && compare.explosion() != nullptr)
    if (const ImTextureID texture = ui.pictures.other(ui.session, {*compare.preset, compare.explosion(), compare.frame, compare.time_s}, 0, drawnPixels(ui, box.width), drawnPixels(ui, box.height)))
      list.AddImage(texture, box.at, {box.at.x + share * box.width, box.end().y}, {0, 1}, {share, 0});
  if (share > 0.0f && compare.explosion() == nullptr) drawAbsence(ui, box, share * box.width);
  const float y = box.end().y - ui.px(106);
  const std::string name = ui.session.file().name() + ", as edited";
  if (split) {
    const float x = box.at.x + share * box.width;
    drawName(ui, x - ui.px(12), y, true, x - box.at.x - ui.px(24), "A", compare.name);
    drawName(ui, x + ui.px(12), y, false, box.right() - x - ui.px(24), "B", name);
    dragDivider(ui, box);
  } else {
    drawName(ui, box.at.x + ui.px(14), box.at.y + ui.px(84), false, box.width - ui.px(28), compare.flipped ? "A" : "B", compare.flipped ? compare.name : name);
  }
  drawStrip(ui, box);
}

namespace {

constexpr int kColumns = 3;

/// One of the nine pictures. True if it is to be adopted.
bool drawCell(const PanelContext& ui, std::size_t index, const Box& box) {
  const Variations& variations = ui.session.variations;
  const std::string name = "variation:" + std::to_string(index + 1);
  ImGui::SetCursorScreenPos(box.at);
  const bool clicked = ImGui::InvisibleButton(name.c_str(), ImVec2(box.width, box.height));
  ui.item(name);
  const bool hovered = ImGui::IsItemHovered(), middle = index == Variations::kMiddle;
  ui.resting(name, middle ? "The preset as it is" : "Click adopts this variation; undo takes it back.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(box.at, box.end(), ui.theme.background);
  const auto& explosion = variations.shelf.at(index);
  if (explosion == nullptr) rowText({box.at.x + ui.px(10), box.at.y}, box.width - ui.px(20), box.height, variations.shelf.fault(index).empty() ? ui.theme.dim : ui.theme.error, variations.shelf.fault(index).empty() ? "being computed" : "cannot be computed: " + variations.shelf.fault(index));
  else if (const ImTextureID texture = ui.pictures.other(ui.session, {*variations.presets[index], explosion, variations.frames[index], variations.time_s}, 1 + static_cast<int>(index), drawnPixels(ui, box.width), drawnPixels(ui, box.height)))
    list.AddImage(texture, box.at, box.end(), {0, 1}, {1, 0});
  if (hovered || middle) list.AddRect(box.at, box.end(), hovered && !middle ? ui.theme.accent : ui.theme.text, 0.0f, 0, ui.px(2));
  ImGui::PushFont(ui.fonts.small);
  const std::string label = middle ? "now" : std::to_string(index + 1);
  const float width = ImGui::CalcTextSize(label.c_str()).x + ui.px(14);
  list.AddRectFilled({box.at.x + ui.px(6), box.at.y + ui.px(6)}, {box.at.x + ui.px(6) + width, box.at.y + ui.px(26)}, faded(ui.theme.background, 0.82f), ui.px(4));
  rowText({box.at.x + ui.px(13), box.at.y + ui.px(6)}, width, ui.px(20), middle ? ui.theme.text : ui.theme.accent, label);
  ImGui::PopFont();
  const ImGuiIO& io = ImGui::GetIO();
  const bool keyed = io.KeyAlt && !io.KeyCtrl && !io.KeyShift && ImGui::IsKeyPressed('1' + static_cast<int>(index), false);
  return (clicked || keyed) && !middle;
}

void drawVariationHead(const PanelContext& ui, const Box& box) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(box.at, box.end(), ui.theme.panel);
  const std::string amount = "Variations by " + shortNumber(std::round(100.0 * ui.session.design.amount)) + " %";
  const float buttons = ui.px(150);
  // As many words as there is room for.
  std::string words = amount;
  for (const char* more : {". A click adopts one; the slider at the right changes how far they go.", ". A click adopts one."})
    if (words == amount && ImGui::CalcTextSize((amount + more).c_str()).x < box.width - buttons - ui.px(16)) words += more;
  rowText({box.at.x + ui.px(12), box.at.y}, box.width - buttons - ui.px(16), box.height, ui.theme.dim, words);
  ImGui::SetCursorScreenPos({box.right() - buttons, box.at.y + ui.px(4)});
  if (textButton(ui, "Others", "other variations")) ui.session.showVariations();
  ImGui::SameLine();
  if (textButton(ui, "Close", "close variations")) ui.session.variations.open = false;
}

}  // namespace

void drawVariations(const PanelContext& ui) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const Box all{ImGui::GetCursorScreenPos(), std::max(std::floor(room.x), 1.0f), std::max(std::floor(room.y), 1.0f)};
  const float head = ui.px(34), gap = ui.px(3);
  drawVariationHead(ui, {all.at, all.width, head});
  const float width = std::max(1.0f, std::floor((all.width - 2.0f * gap) / kColumns)), height = std::max(1.0f, std::floor((all.height - head - 2.0f * gap) / kColumns));
  ui.session.setAspect(static_cast<double>(width / height));
  std::optional<std::size_t> adopted;
  for (std::size_t i = 0; i < Variations::kCount; ++i) {
    const std::size_t column = i % kColumns, row = i / kColumns;
    if (drawCell(ui, i, {{all.at.x + static_cast<float>(column) * (width + gap), all.at.y + head + static_cast<float>(row) * (height + gap)}, width, height})) adopted = i;
  }
  if (adopted) ui.session.adoptVariation(*adopted);
  if (!ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false) && !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) ui.session.variations.open = false;
}

}  // namespace npsee::editor
