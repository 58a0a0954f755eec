#include "editor/panels/vary_strip.h"

#include "editor/document/vary.h"
#include "editor/ui/controls.h"

#include <cmath>

namespace npsee::editor {

void varyLayers(const PanelContext& ui, int layer, std::optional<Section> section) {
  Design& design = ui.session.design;
  const Variation variation{design.amount, ++design.draws, layer, section, &design.locked};
  const std::uint64_t before = ui.session.document.revision();
  if (!ui.session.took(ui.session.document.edit("Randomise", {}, [&](Preset& preset) { preset = varied(preset, variation); }))) return;
  if (ui.session.document.revision() == before) ui.session.notices.note = "Nothing was varied: everything that could be is locked, off, or the amount is too small.";
}

void varySeed(const PanelContext& ui) {
  const Parameter& seed = *findParameter(Scope::burst, "seed");
  const auto now = std::get<std::int64_t>(ui.session.document.value(seed));
  const auto next = static_cast<double>(now) + 1.0 > seed.hard.max ? static_cast<std::int64_t>(seed.hard.min) : now + 1;
  if (ui.session.took(ui.session.document.assign(seed, next))) ui.session.notices.note = "Seed " + std::to_string(next) + '.';
}

bool locked(const PanelContext& ui, const std::string& name) { return ui.session.design.locked.contains(name); }

void toggleLock(const PanelContext& ui, const std::string& name) {
  if (!ui.session.design.locked.erase(name)) ui.session.design.locked.insert(name);
}

void drawLock(const PanelContext& ui, const Row& row, const RowFrame& frame) {
  if (!varies(row.parameter)) return;
  const bool on = locked(ui, row.name);
  const ImVec2 end{frame.control.right() + ui.px(20), frame.at.y + ui.px(26)};
  if (!on && !(ImGui::IsMouseHoveringRect(frame.at, end) && ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem))) return;
  ImGui::SetItemAllowOverlap();  // the label lies under it
  ImGui::SetCursorScreenPos({frame.control.at.x - ui.px(24), frame.at.y + ui.px(4)});
  if (iconButton(ui, on ? Icon::lock : Icon::lock_open, "lock:" + row.name, on ? "Locked: randomising leaves it as it is" : "Lock against randomising", on, 18)) toggleLock(ui, row.name);
}

void drawVaryStrip(const PanelContext& ui) {
  Design& design = ui.session.design;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(28), button = ui.px(26);
  ImGui::InvisibleButton("row:vary.amount", ImVec2(ui.px(80), height));
  ui.resting("row:vary.amount", "How far randomising (D) may go from what is there; a row's lock keeps it out.");
  rowText({at.x, at.y}, ui.px(80), height, ui.theme.dim, "Randomise");
  const float left = at.x + ui.px(88), right = at.x + width - 2.0f * button - ui.px(4);
  const NumberSpec spec{100.0 * design.amount, {1.0, 100.0}, {1.0, 100.0}, Scale::linear, true, false};
  if (typingIn(ui, "vary.amount")) {
    if (const auto typed = typedNumber(ui, "vary.amount", {{left, at.y}, right - left, height}, Unit::none)) {
      design.amount = std::clamp(*typed, 1.0, 100.0) / 100.0;
      ui.state.typing = {};
    }
  } else {
    const Box track{{left, at.y}, right - left - ui.px(56), height};
    if (const auto changed = slider(ui, "vary.amount", spec, track)) design.amount = *changed / 100.0;
    if (typingIn(ui, "vary.amount")) ui.state.typing.text = shortNumber(100.0 * design.amount);
    ImGui::PushFont(ui.fonts.numbers);
    rowTextRight(right - ui.px(8), at.y, height, ui.theme.text, shortNumber(std::round(100.0 * design.amount)) + " %");
    ImGui::PopFont();
  }
  ImGui::SetCursorScreenPos({right, at.y + ui.px(1)});
  if (iconButton(ui, Icon::dice, "randomise", "Randomise the selected layer (D)", false, 26, ui.session.document.hasLayer())) varyLayers(ui, ui.session.document.selected());
  ImGui::SetCursorScreenPos({right + button + ui.px(2), at.y + ui.px(1)});
  if (iconButton(ui, Icon::seed, "vary seed", "Another seed: other particles, the same settings (Shift+D)")) varySeed(ui);
  ImGui::SetCursorScreenPos({at.x, at.y + height});
  ImGui::Dummy(ImVec2(1, ui.px(2)));
}

}  // namespace npsee::editor
