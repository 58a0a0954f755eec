#include "editor/document/clipboard.h"
#include "editor/panels/design_actions.h"
#include "editor/panels/panels.h"
#include "editor/ui/controls.h"
#include "editor/ui/slider.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace npsee::editor {
namespace {

/// A line of the list: layers in the order of the tree, children below their parent.
struct Line {
  int index = 0, depth = 0;
  int above = 0;  ///< lines up to the one that this one's stroke of the tree comes down from
};

/// Presets are valid, so there are no rings.
std::vector<Line> tree(const Preset& preset) {
  std::vector<Line> out;
  const std::function<void(const std::string&, int, int)> addChildren = [&](const std::string& parent, int depth, int parent_line) {
    for (int i = 0; i < static_cast<int>(preset.layers.size()); ++i) {
      const Layer& layer = preset.layers[static_cast<std::size_t>(i)];
      if (layer.parent != parent) continue;
      const int line = static_cast<int>(out.size());
      out.push_back({i, depth, line - parent_line});
      addChildren(layer.name, depth + 1, line);
    }
  };
  addChildren({}, 0, 0);
  return out;
}

std::string countText(const PanelContext& ui, int layer) {
  const Explosion* explosion = ui.session.explosion();
  const std::string& name = ui.session.document.preset().layers[static_cast<std::size_t>(layer)].name;
  if (explosion == nullptr) return {};
  for (const LayerSpan& span : explosion->layers())
    if (span.name == name) return std::to_string(span.count);
  return "0";
}

void toggleLayer(const PanelContext& ui, int index) {
  ui.session.took(ui.session.document.edit("Enabled", {}, [index](Preset& preset) {
    Layer& layer = preset.layers[static_cast<std::size_t>(index)];
    layer.enabled = !layer.enabled;
  }));
}

void nameField(const PanelContext& ui, const Box& box) {
  const auto text = typingField(ui, box);
  if (!text) return;
  if (ui.session.took(ui.session.document.renameLayer(*text))) ui.state.typing = {};
  else refuseTyping(ui, ui.session.notices.error);
}

/// When the layer's particles start, as its line says it.
std::string triggerWords(const Layer& layer) {
  const auto key = std::get<std::string>(findParameter(Scope::layer, "trigger")->get(layer));
  return layer.parent.empty() ? std::string() : (layer.trigger == Trigger::path ? "along " : "at ") + key;
}

/// What the layer's particles look like: its colour, or how that changes over life.
void drawChip(const PanelContext& ui, const Layer& layer, ImVec2 min, ImVec2 max) {
  const auto packed = [&](const Colour& c) { return ImGui::ColorConvertFloat4ToU32({static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b), layer.enabled ? 1.0f : 0.4f}); };
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Gradient& life = layer.colour_over_life;
  if (life.size() < 2) return list.AddRectFilled(min, max, packed(life.empty() ? layer.colour : life.front().colour), ui.px(2));
  for (std::size_t i = 0; i + 1 < life.size(); ++i) {
    const float steps = static_cast<float>(life.size() - 1), width = max.x - min.x;
    const float from = min.x + width * static_cast<float>(i) / steps, to = min.x + width * static_cast<float>(i + 1) / steps;
    const ImU32 left = packed(life[i].colour), right = packed(life[i + 1].colour);
    list.AddRectFilledMultiColor({from, min.y}, {to, max.y}, left, right, right, left);
  }
}

void toggleSolo(const PanelContext& ui, const std::string& name) {
  if (!ui.session.design.solo.erase(name)) ui.session.design.solo.insert(name);
}

void layerMenu(const PanelContext& ui, int index) {
  Document& document = ui.session.document;
  const Layer layer = document.preset().layers[static_cast<std::size_t>(index)];
  contextMenu(ui, ("menu:" + layer.name).c_str(), [&] {
    const auto entry = [&](const char* label, bool checked = false) {
      const bool chosen = ImGui::MenuItem(label, nullptr, checked);
      ui.item("item:" + std::string(label));
      return chosen;
    };
    document.select(index);
    if (entry("Copy layer")) ImGui::SetClipboardText(layerText(document.preset(), index).c_str());
    if (entry("Paste")) pasteClipboard(ui);
    if (entry("Duplicate layer")) ui.session.took(document.duplicateLayer());
    if (entry("Rename layer")) ui.state.rename_layer = true;
    ImGui::Separator();
    if (entry("Show alone", ui.session.design.solo.contains(layer.name))) toggleSolo(ui, layer.name);
    if (entry("Enabled", layer.enabled)) toggleLayer(ui, index);
    ImGui::Separator();
    if (entry("Delete layer")) ui.session.took(document.deleteLayer());
  });
}

/// The strokes of the tree, from the parent's line to this one.
void drawBranch(const PanelContext& ui, const Line& line, ImVec2 at, float height) {
  if (line.depth == 0) return;
  const float x = std::floor(at.x + ui.px(14) * static_cast<float>(line.depth) - ui.px(1)) + 0.5f, middle = std::floor(at.y + 0.5f * height) + 0.5f;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({x, middle - height * static_cast<float>(line.above) + ui.px(9)}, {x, middle}, ui.theme.line);
  list.AddLine({x, middle}, {x + ui.px(8), middle}, ui.theme.line);
}

/// The name as a button that selects, is dragged, renamed and has the menu.
void nameButton(const PanelContext& ui, const Line& line, const Layer& layer, const Box& box) {
  Document& document = ui.session.document;
  const std::string full = "layer:" + layer.name;
  ImGui::SetCursorScreenPos(box.at);
  const bool clicked = ImGui::InvisibleButton(full.c_str(), ImVec2(box.width, box.height));
  ui.item(full);
  UiState::LayerDrag& drag = ui.state.layer_drag;
  if (ImGui::IsItemActivated()) drag = {layer.name, false};
  if (ImGui::IsItemActive() && std::abs(ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, ui.px(5)).y) > 0.0f) drag.moving = true;
  if (clicked && !drag.moving) document.select(line.index);
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) ui.state.rename_layer = true;
  std::string hint = "Layer " + layer.name;
  if (!layer.parent.empty()) hint += ", starts " + triggerWords(layer) + " of " + layer.parent;
  if (ui.resting(full, hint)) tooltip(ui, "Click selects, double click renames. Drag it between others to reorder, onto another to hang it there.");
  layerMenu(ui, line.index);
}

void layerLine(const PanelContext& ui, const Line& line) {
  Document& document = ui.session.document;
  const Layer layer = document.preset().layers[static_cast<std::size_t>(line.index)];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(26), indent = ui.px(14) * static_cast<float>(line.depth);
  const bool selected = line.index == document.selected(), solo = ui.session.design.solo.contains(layer.name);
  const bool hovered = ImGui::IsMouseHoveringRect(at, {at.x + width, at.y + height}) && ImGui::IsWindowHovered();
  const float text_x = at.x + indent + ui.px(50), right = at.x + width - ui.px(80);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (selected && ui.state.seen_layer != layer.name) {
    ui.state.seen_layer = layer.name;
    ImGui::SetScrollFromPosY(at.y + 0.5f * height - ImGui::GetWindowPos().y, 0.5f);
  }
  if (selected) list.AddRectFilled(at, {at.x + width, at.y + height}, ui.theme.raised, ui.px(4));
  if (selected) list.AddRectFilled({at.x, at.y + ui.px(5)}, {at.x + ui.px(3), at.y + height - ui.px(5)}, ui.theme.accent, ui.px(1));
  if (hovered && !selected) list.AddRect(at, {at.x + width, at.y + height}, ui.theme.line, ui.px(4));
  drawBranch(ui, line, at, height);
  const bool shown = layer.enabled && ui.session.design.shows(layer.name);
  const ImU32 colour = !shown ? faded(ui.theme.dim, 0.6f) : selected ? ui.theme.text : ui.theme.dim;
  if (typingIn(ui, "layer name") && selected) {
    nameField(ui, {{text_x - ui.px(8), at.y}, right - text_x, height});
  } else {
    nameButton(ui, line, layer, {{text_x - ui.px(4), at.y}, right - text_x, height});
    ImGui::PushFont(ui.fonts.small);
    const std::string words = triggerWords(layer);
    float words_width = words.empty() ? 0.0f : ImGui::CalcTextSize(words.c_str()).x;
    if (words_width > 0.5f * (right - text_x)) words_width = 0.0f;
    if (words_width > 0.0f) rowTextRight(right, at.y, height, shown ? ui.theme.geometry : colour, words);
    ImGui::PopFont();
    rowText({text_x, at.y}, right - text_x - words_width - ui.px(8), height, colour, layer.name);
  }
  ImGui::PushFont(ui.fonts.numbers);
  rowTextRight(at.x + width - ui.px(8), at.y, height, layer.enabled ? ui.theme.dim : faded(ui.theme.dim, 0.6f), countText(ui, line.index));
  ImGui::PopFont();
  ImGui::SetCursorScreenPos({at.x + indent + ui.px(6), at.y + ui.px(2)});
  if (iconButton(ui, layer.enabled ? Icon::eye : Icon::eye_off, "enable:" + layer.name, layer.enabled ? "Disable this layer" : "Enable this layer", false, 22)) toggleLayer(ui, line.index);
  ImGui::SetCursorScreenPos({right + ui.px(2), at.y + ui.px(2)});
  if (iconButton(ui, Icon::solo, "solo:" + layer.name, solo ? "Show the other layers again" : "Show this layer alone; more can be added", solo, 22)) toggleSolo(ui, layer.name);
  drawChip(ui, layer, {at.x + indent + ui.px(32), at.y + ui.px(8)}, {at.x + indent + ui.px(42), at.y + ui.px(18)});
  ImGui::SetCursorScreenPos({at.x, at.y + height});
}

/// The dragged layer's new place, shown as a line between two others or a frame around one, and taken on release.
void dropLayer(const PanelContext& ui, const std::vector<Line>& lines, ImVec2 first, float width) {
  UiState::LayerDrag& drag = ui.state.layer_drag;
  if (drag.name.empty()) return;
  const bool held = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const float height = ui.px(26), y = (ImGui::GetIO().MousePos.y - first.y) / height;
  if (drag.moving && !lines.empty()) {
    const int line = std::clamp(static_cast<int>(std::floor(y)), 0, static_cast<int>(lines.size()) - 1);
    const float share = y - static_cast<float>(line);
    const auto place = share < 0.3f ? Document::Place::before : share > 0.7f ? Document::Place::after : Document::Place::inside;
    const Line& target = lines[static_cast<std::size_t>(line)];
    const float top = first.y + height * static_cast<float>(line), left = first.x + ui.px(14) * static_cast<float>(target.depth);
    const float edge = place == Document::Place::before ? top : top + height;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (place == Document::Place::inside) list.AddRect({left, top}, {first.x + width, top + height}, ui.theme.accent, ui.px(4), 0, ui.px(1.5f));
    else list.AddLine({left, edge}, {first.x + width, edge}, ui.theme.accent, ui.px(2));
    const std::string& beside = ui.session.document.preset().layers[static_cast<std::size_t>(target.index)].name;
    ui.state.hint = place == Document::Place::inside ? "Hang " + drag.name + " on " + beside : "Put " + drag.name + (place == Document::Place::before ? " before " : " after ") + beside;
    if (!held) ui.session.took(ui.session.document.placeLayer(findLayer(ui.session.document.preset(), drag.name), target.index, place));
  }
  if (!held) drag = {};
}

}  // namespace

void drawLayerPanel(const PanelContext& ui) {
  Document& document = ui.session.document;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  heading(ui, "Layers");
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({at.x + width - ui.px(3 * 24), at.y + ui.px(1)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  if (iconButton(ui, Icon::plus, "add layer", "Add a layer below the selected one", false, 24)) ui.session.took(document.addLayer());
  ImGui::SameLine();
  if (iconButton(ui, Icon::copy, "duplicate layer", "Duplicate the selected layer", false, 24, document.hasLayer())) ui.session.took(document.duplicateLayer());
  ImGui::SameLine();
  if (iconButton(ui, Icon::bin, "delete layer", "Delete the selected layer and what hangs on it", false, 24, document.hasLayer())) ui.session.took(document.deleteLayer());
  ImGui::SetCursorScreenPos(below);
  if (ui.state.rename_layer && document.hasLayer()) beginTyping(ui, "layer name", document.layer().name);
  ui.state.rename_layer = false;
  const auto lines = tree(document.preset());
  // A tall window has room for more lines.
  const auto most = std::max<std::size_t>(7, static_cast<std::size_t>(0.28f * ImGui::GetIO().DisplaySize.y / ui.px(26)));
  const float shown = static_cast<float>(std::clamp<std::size_t>(lines.size(), 1, most));
  ImGui::BeginChild("layers", ImVec2(0, shown * ui.px(26) + ui.px(8)), false, ImGuiWindowFlags_NoBackground);
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  if (lines.empty()) ImGui::TextDisabled("No layers. The plus adds one.");
  const ImVec2 first = ImGui::GetCursorScreenPos();
  const float line_width = ImGui::GetContentRegionAvail().x;
  for (const Line& line : lines) {
    // A menu may just have deleted it.
    if (line.index >= static_cast<int>(document.preset().layers.size())) break;
    layerLine(ui, line);
  }
  if (lines.size() == document.preset().layers.size()) dropLayer(ui, lines, first, line_width);
  ImGui::Dummy(ImVec2(1, 1));
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace npsee::editor
