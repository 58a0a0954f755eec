// The hints of the first start: where they point, one after the other.

#include "editor/panels/desk/sheets.h"
#include "editor/ui/controls.h"

#include <algorithm>
#include <array>

namespace npsee::editor {
namespace {

struct Hint {
  const char *item, *text;
};
constexpr std::array kHints{
    Hint{"viewport", "Drag turns the view, the middle button shifts it, the wheel goes nearer. Space plays and pauses, F shows everything."},
    Hint{"template", "The template shows the settings and changes them: drag its rim, its top or its foot."},
    Hint{"field:search", "Every parameter has a slider here. Double click types a value with a unit, Shift drags finely."},
    Hint{"field:library", "A click opens a preset, the star keeps it at hand. Files can be dropped on the window too."},
    Hint{"menu:Help", "F1 lists all keys, Ctrl+P finds any command or parameter, Ctrl+H goes back to any step."},
};

void end(const PanelContext& ui) {
  ui.state.desk.tour = -1;
  ui.desk.settings.tour_done = true;
}

}  // namespace

void drawTour(const PanelContext& ui) {
  int& at = ui.state.desk.tour;
  if (at < 0 || ui.session.inMission() || sheetOpen(ui) || ui.state.show_help || ui.session.files.mode != FilePanel::Mode::closed) return;
  const auto count = static_cast<int>(kHints.size());
  const Hint& hint = kHints[static_cast<std::size_t>(std::min(at, count - 1))];
  const Items::Item* const item = ui.items.find(hint.item);
  if (item == nullptr || !item->visible) return;
  // Inside what is large, beside what is small, always in the window.
  const ImVec2 window = ImGui::GetIO().DisplaySize, size{ui.px(300), ui.px(118)};
  const bool large = item->max.y - item->min.y > ui.px(200);
  ImVec2 place{large ? item->min.x + ui.px(20) : item->min.x, large ? item->min.y + ui.px(48) : item->max.y + ui.px(8)};
  place.x = std::clamp(place.x, ui.px(8), std::max(ui.px(8), window.x - size.x - ui.px(8)));
  place.y = std::clamp(place.y, ui.px(8), std::max(ui.px(8), window.y - size.y - ui.px(8)));
  ImGui::GetForegroundDrawList()->AddRect({item->min.x - ui.px(2), item->min.y - ui.px(2)}, {item->max.x + ui.px(2), item->max.y + ui.px(2)}, ui.theme.accent, ui.px(4), ImDrawFlags_None, ui.px(1.5f));
  ImGui::SetNextWindowPos(place);
  ImGui::SetNextWindowSize({size.x, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(14), ui.px(10)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.theme.raised);
  ImGui::PushStyleColor(ImGuiCol_Border, ui.theme.accent);
  ImGui::Begin("tour", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(hint.text);
  ImGui::PopTextWrapPos();
  ImGui::Dummy(ImVec2(1, ui.px(4)));
  const bool last = at + 1 >= count;
  const bool next = textButton(ui, last ? "Begin" : "Next", "tour next", true);
  ImGui::SameLine();
  const bool skip = !last && textButton(ui, "Skip", "tour skip");
  ImGui::SameLine();
  ImGui::TextDisabled("%d of %d", at + 1, count);
  ImGui::End();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar(3);
  if (next) ++at;
  if (skip || at >= count) end(ui);
}

}  // namespace npsee::editor
