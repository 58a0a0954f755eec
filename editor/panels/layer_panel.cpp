#include "editor/panels/panels.h"
#include "editor/ui/controls.h"
#include "editor/ui/slider.h"

#include <algorithm>
#include <functional>

namespace npsee::editor {
namespace {

/// Layers in the order of the tree with their depth: children below their parent. Presets are valid, so there are no rings.
std::vector<std::pair<int, int>> tree(const Preset& preset) {
  std::vector<std::pair<int, int>> out;
  const std::function<void(const std::string&, int)> addChildren = [&](const std::string& parent, int depth) {
    for (int i = 0; i < static_cast<int>(preset.layers.size()); ++i) {
      const Layer& layer = preset.layers[static_cast<std::size_t>(i)];
      if (layer.parent != parent) continue;
      out.emplace_back(i, depth);
      addChildren(layer.name, depth + 1);
    }
  };
  addChildren({}, 0);
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

void layerLine(const PanelContext& ui, int index, int depth) {
  Document& document = ui.session.document;
  const Layer layer = document.preset().layers[static_cast<std::size_t>(index)];
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(26), indent = ui.px(14) * static_cast<float>(depth);
  const bool selected = index == document.selected();
  const float text_x = at.x + indent + ui.px(50), text_width = at.x + width - ui.px(56) - text_x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (selected && ui.state.seen_layer != layer.name) {
    ui.state.seen_layer = layer.name;
    ImGui::SetScrollFromPosY(at.y + 0.5f * height - ImGui::GetWindowPos().y, 0.5f);
  }
  if (selected) list.AddRectFilled(at, {at.x + width, at.y + height}, ui.theme.raised, ui.px(4));
  if (selected) list.AddRectFilled({at.x, at.y + ui.px(5)}, {at.x + ui.px(3), at.y + height - ui.px(5)}, ui.theme.accent, ui.px(1));
  if (typingIn(ui, "layer name") && selected) {
    nameField(ui, {{text_x - ui.px(8), at.y}, text_width, height});
  } else {
    ImGui::SetCursorScreenPos({text_x - ui.px(4), at.y});
    if (ImGui::InvisibleButton(("layer:" + layer.name).c_str(), ImVec2(at.x + width - text_x, height))) document.select(index);
    ui.item("layer:" + layer.name);
    if (ImGui::IsItemHovered() && !selected) list.AddRect(at, {at.x + width, at.y + height}, ui.theme.line, ui.px(4));
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) ui.state.rename_layer = true;
    if (ui.resting("layer:" + layer.name, layer.parent.empty() ? "Layer " + layer.name : "Layer " + layer.name + ", hangs on " + layer.parent)) tooltip(ui, "Click selects, double click renames.");
    rowText({text_x, at.y}, text_width, height, !layer.enabled ? faded(ui.theme.dim, 0.6f) : selected ? ui.theme.text : ui.theme.dim, layer.name);
  }
  ImGui::PushFont(ui.fonts.numbers);
  rowTextRight(at.x + width - ui.px(8), at.y, height, layer.enabled ? ui.theme.dim : faded(ui.theme.dim, 0.6f), countText(ui, index));
  ImGui::PopFont();
  ImGui::SetCursorScreenPos({at.x + indent + ui.px(6), at.y + ui.px(2)});
  if (iconButton(ui, layer.enabled ? Icon::eye : Icon::eye_off, "enable:" + layer.name, layer.enabled ? "Disable this layer" : "Enable this layer", false, 22)) toggleLayer(ui, index);
  const ImVec4 colour(static_cast<float>(layer.colour.r), static_cast<float>(layer.colour.g), static_cast<float>(layer.colour.b), layer.enabled ? 1.0f : 0.4f);
  list.AddRectFilled({at.x + indent + ui.px(32), at.y + ui.px(8)}, {at.x + indent + ui.px(42), at.y + ui.px(18)}, ImGui::ColorConvertFloat4ToU32(colour), ui.px(2));
  ImGui::SetCursorScreenPos({at.x, at.y + height});
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
  const float shown = static_cast<float>(std::clamp<std::size_t>(lines.size(), 1, 7));
  ImGui::BeginChild("layers", ImVec2(0, shown * ui.px(26) + ui.px(8)), false, ImGuiWindowFlags_NoBackground);
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  if (lines.empty()) ImGui::TextDisabled("No layers. The plus adds one.");
  for (const auto& [index, depth] : lines) layerLine(ui, index, depth);
  ImGui::Dummy(ImVec2(1, 1));
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace npsee::editor
