#include "editor/panels/mission/panels.h"
#include "editor/ui/controls.h"

namespace npsee::editor {
namespace {

using Kind = ObjectRef::Kind;

/// What is selected, in large.
void drawTitle(const PanelContext& ui) {
  const MissionSession& mission = ui.session.mission();
  const ObjectRef& ref = mission.document.selected();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(30);
  std::string name = ref.kind == Kind::mission ? mission.document.scenario().title : ref.id;
  if (name.empty()) name = mission.document.name();
  std::string detail(kindName(ref.kind));
  Symbol symbol = ref.kind == Kind::observer ? Symbol::observer : Symbol::gun;
  Side side = Side::friendly;
  const int vehicle = mission.selectedVehicle();
  if (ref.kind == Kind::vehicle && vehicle >= 0) {
    const VehicleType& type = mission.recording()->vehicles[static_cast<std::size_t>(vehicle)].type;
    detail = type.name;
    side = type.side;
    symbol = symbolOf(side);
  }
  float x = at.x;
  if (ref.kind != Kind::mission && ref.kind != Kind::group) {
    drawSymbol(ui, symbol, {x + ui.px(9), at.y + 0.5f * height}, ui.px(15), sideColour(ui, side), false);
    x += ui.px(26);
  }
  ImGui::PushFont(ui.fonts.small);
  const float taken = ImGui::CalcTextSize(detail.c_str()).x;
  rowTextRight(at.x + width, at.y, height, ui.theme.dim, detail);
  ImGui::PopFont();
  ImGui::PushFont(ui.fonts.bold);
  rowText({x, at.y}, at.x + width - taken - ui.px(10) - x, height, ui.theme.text, name);
  ImGui::PopFont();
  ImGui::Dummy(ImVec2(width, height));
}

}  // namespace

void drawSelectedPanel(const PanelContext& ui) {
  MissionUi& my = ui.state.mission;
  const Kind kind = ui.session.mission().document.selected().kind;
  drawTitle(ui);
  const bool commanded = kind == Kind::observer || kind == Kind::vehicle;  // a single one of a group too
  std::vector<std::string> tabs{"Parameters", kind == Kind::observer ? "Mind" : kind == Kind::mission ? "Summary" : "State"};
  if (commanded) tabs.emplace_back(kind == Kind::observer ? "Fire" : "Drive");
  int chosen = static_cast<int>(my.right);
  if (!commanded && my.right == MissionUi::Right::command) chosen = 0;
  const int now = tabStrip(ui, "right", tabs, chosen);
  if (now != chosen) my.right = static_cast<MissionUi::Right>(now);
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  switch (now) {
    case 0: return drawFieldPanel(ui);
    case 1: return drawMindPanel(ui);
    default: return drawCommandPanel(ui);
  }
}

void drawCommandPanel(const PanelContext& ui) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), ui.px(4)));
  ImGui::BeginChild("commands", ImVec2(0, 0), false, ImGuiWindowFlags_NoBackground);
  if (ui.session.mission().document.selected().kind == Kind::observer) drawObserverCommands(ui);
  else drawVehicleCommands(ui);
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace npsee::editor
