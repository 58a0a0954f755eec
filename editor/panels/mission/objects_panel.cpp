#include "editor/panels/mission/panels.h"
#include "editor/panels/panels.h"
#include "editor/ui/controls.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <functional>

namespace npsee::editor {
namespace {

using Kind = ObjectRef::Kind;

/// One line of the list.
struct Line {
  ObjectRef ref;
  Symbol symbol = Symbol::friendly;
  Side side = Side::friendly;
  std::string detail;
  bool destroyed = false, indented = false;
  int vehicle = -1;  ///< index in the recording
  std::string name;  ///< shown; the reference's id for most
};

bool contains(std::string_view text, const std::string& word) { return word.empty() || capitals(text).find(capitals(word)) != std::string::npos; }

std::string conditionOf(const MissionSession& mission, int vehicle) {
  const VehicleRecord& record = mission.recording()->vehicles[static_cast<std::size_t>(vehicle)];
  const DamageStep* damage = record.damageAt(mission.clock.time_s);
  if (damage == nullptr) return record.type.name;
  if (damage->hull >= 1.0) return "destroyed";
  return !damage->mobility ? "immobile" : !damage->firepower ? "disarmed" : "damaged";
}

std::vector<Line> vehicleLines(const MissionSession& mission, const std::string& word) {
  std::vector<Line> out;
  const Recording& recording = *mission.recording();
  for (int i = 0; i < static_cast<int>(recording.vehicles.size()); ++i) {
    const VehicleRecord& record = recording.vehicles[static_cast<std::size_t>(i)];
    // An observer's own vehicle is listed as the observer.
    if (mission.owner(i).kind == Kind::observer || (!contains(record.id, word) && !contains(record.type.name, word))) continue;
    out.push_back({mission.owner(i), symbolOf(record.type.side), record.type.side, {}, false, false, i, record.id});
  }
  return out;
}

std::vector<Line> observerLines(const MissionSession& mission, const std::string& word) {
  std::vector<Line> out;
  for (const ObserverSetup& observer : mission.shownScenario().observers) {
    if (!contains(observer.id, word)) continue;
    const int vehicle = mission.recording() != nullptr ? vehicleOf(*mission.recording(), {Kind::observer, observer.id}) : -1;
    const bool gone = vehicle >= 0 && mission.recording()->vehicles[static_cast<std::size_t>(vehicle)].destroyedAt(mission.clock.time_s);
    out.push_back({{Kind::observer, observer.id}, Symbol::observer, Side::friendly, gone ? "destroyed" : mission.taken(observer.id) ? "you" : observer.human ? "a person" : "automatic", gone, false, vehicle, observer.id});
  }
  return out;
}

std::vector<Line> gunLines(const MissionSession& mission, const std::string& word) {
  std::vector<Line> out;
  for (const BatterySetup& battery : mission.shownScenario().batteries) {
    std::vector<Line> guns;
    for (const GunSetup& gun : battery.guns)
      if (contains(gun.id, word) || contains(battery.id, word)) guns.push_back({{Kind::gun, gun.id}, Symbol::gun, Side::friendly, {}, false, true, -1, gun.id});
    if (guns.empty() && !contains(battery.id, word)) continue;
    out.push_back({{Kind::battery, battery.id}, Symbol::gun, Side::friendly, std::to_string(battery.guns.size()) + (battery.guns.size() == 1 ? " gun" : " guns"), false, false, -1, battery.id});
    out.insert(out.end(), guns.begin(), guns.end());
  }
  return out;
}

std::vector<Line> groupLines(const MissionSession& mission, const std::string& word) {
  std::vector<Line> out;
  const auto types = vehicleTypes(mission.document.scenario());
  for (const VehicleGroup& group : mission.document.scenario().groups) {
    if (!contains(group.id, word)) continue;
    const auto type = std::ranges::find(types, group.type, &VehicleType::index);
    const Side side = type == types.end() ? Side::neutral : type->side;
    out.push_back({{Kind::group, group.id}, symbolOf(side), side, std::to_string(group.count) + (type == types.end() ? "" : " " + type->name), false, false, -1, group.id});
  }
  return out;
}

void choose(const PanelContext& ui, const Line& line) {
  MissionSession& mission = ui.session.mission();
  mission.document.select(line.ref);
  ui.state.mission.seen = mission.document.selected();
}

/// As scripts call it.
std::string nameOf(const Line& line) { return std::string(kindName(line.ref.kind)) + ':' + line.name; }

void drawLine(const PanelContext& ui, Line line) {
  MissionSession& mission = ui.session.mission();
  if (line.ref.kind == Kind::vehicle) {
    line.detail = conditionOf(mission, line.vehicle);
    line.destroyed = line.detail == "destroyed";
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(24);
  const bool chosen = mission.document.selected() == line.ref;
  const std::string name = nameOf(line);
  ImGui::PushID(name.c_str());
  const bool clicked = ImGui::InvisibleButton("##line", ImVec2(width, height));
  ui.item(name);
  const bool hovered = ImGui::IsItemHovered();
  if (clicked) choose(ui, line);
  if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) mission.showSelected();
  ui.resting(name, "Click selects, double click shows it in the picture.");
  ImGui::PopID();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (chosen || hovered) list.AddRectFilled(at, {at.x + width, at.y + height}, ui.theme.raised, ui.px(4));
  if (chosen) list.AddRectFilled({at.x, at.y + ui.px(5)}, {at.x + ui.px(3), at.y + height - ui.px(5)}, ui.theme.accent, ui.px(1));
  const float indent = ui.px(line.indented ? 20 : 8);
  const ImU32 colour = line.destroyed ? ui.theme.dim : sideColour(ui, line.side);
  if (!line.indented || line.symbol != Symbol::gun) drawSymbol(ui, line.symbol, {at.x + indent + ui.px(8), at.y + 0.5f * height}, ui.px(13), colour, line.destroyed);
  const float text_x = at.x + indent + ui.px(22);
  ImGui::PushFont(ui.fonts.small);
  const float detail = line.detail.empty() ? 0.0f : std::min(ImGui::CalcTextSize(line.detail.c_str()).x + ui.px(12), 0.45f * width);
  if (detail > 0.0f) rowText({at.x + width - detail, at.y}, detail - ui.px(4), height, line.detail == "you" ? ui.theme.accent : ui.theme.dim, line.detail);
  ImGui::PopFont();
  rowText({text_x, at.y}, at.x + width - detail - ui.px(6) - text_x, height, line.destroyed ? ui.theme.dim : ui.theme.text, line.name);
}

void drawLines(const PanelContext& ui, const std::string& title, const std::vector<Line>& lines) {
  MissionUi& my = ui.state.mission;
  const bool folded = my.folded_lists.contains(title);
  const auto counted = std::ranges::count_if(lines, [](const Line& line) { return line.ref.kind != Kind::battery; });
  if (foldingHeading(ui, title + "  " + std::to_string(counted), folded)) {
    if (!my.folded_lists.erase(title)) my.folded_lists.insert(title);
  }
  if (folded) return;
  const ObjectRef& selected = ui.session.mission().document.selected();
  // A thousand vehicles are drawn only where they are seen; a newly selected one is scrolled to.
  const float top = ImGui::GetCursorPosY(), height = ui.px(24);
  const std::string& wanted = ui.items.wanted();
  if (selected != my.seen || !wanted.empty())
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (lines[i].ref == (selected != my.seen ? selected : ObjectRef{}) || nameOf(lines[i]) == wanted) {
        my.seen = selected;
        ImGui::SetScrollFromPosY(top - ImGui::GetScrollY() + (static_cast<float>(i) + 0.5f) * height, 0.5f);
        break;
      }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(lines.size()), height);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) drawLine(ui, lines[static_cast<std::size_t>(i)]);
}

void drawAddMenu(const PanelContext& ui) {
  MissionUi& my = ui.state.mission;
  const auto entry = [&](const std::string& label, GroundClick click, int type) {
    if (ImGui::MenuItem(label.c_str())) {
      my.click = click;
      my.click_type = type;
    }
    ui.item("item:" + label);
  };
  entry("Observer", GroundClick::observer, 0);
  entry("Gun", GroundClick::gun, 0);
  entry("Ten vehicles at random", GroundClick::group, 51);
  ImGui::Separator();
  for (const VehicleType& type : vehicleTypes(ui.session.mission().document.scenario())) entry(type.name.empty() ? "Type " + std::to_string(type.index) : type.name, GroundClick::vehicle, type.index);
}

void drawButtons(const PanelContext& ui, ImVec2 at, float width) {
  MissionDocument& document = ui.session.mission().document;
  const bool any = document.selected().kind != Kind::mission;
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({at.x + width - ui.px(3 * 24), at.y + ui.px(1)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  if (iconButton(ui, Icon::plus, "add object", "Add a vehicle, gun or observer; the next click on the ground places it", ui.state.mission.click != GroundClick::select, 24)) ImGui::OpenPopup("add object");
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  ImGui::SameLine();
  if (iconButton(ui, Icon::copy, "duplicate object", "Duplicate the selected thing", false, 24, any)) ui.session.took(document.duplicateSelected());
  ImGui::SameLine();
  if (iconButton(ui, Icon::bin, "delete object", "Delete the selected thing", false, 24, any)) ui.session.took(document.removeSelected());
  ImGui::PopStyleVar();
  dropDown(ui, "add object", min, max, [&] { drawAddMenu(ui); });
  ImGui::SetCursorScreenPos(below);
}

void drawMissionLine(const PanelContext& ui) {
  MissionDocument& document = ui.session.mission().document;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(24);
  const bool chosen = document.selected().kind == Kind::mission;
  if (ImGui::InvisibleButton("mission line", ImVec2(width, height))) document.select({});
  ui.item("mission:settings");
  ui.resting("mission:settings", "Name, duration, ground, weather and fire direction.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (chosen || ImGui::IsItemHovered()) list.AddRectFilled(at, {at.x + width, at.y + height}, ui.theme.raised, ui.px(4));
  if (chosen) list.AddRectFilled({at.x, at.y + ui.px(5)}, {at.x + ui.px(3), at.y + height - ui.px(5)}, ui.theme.accent, ui.px(1));
  const std::string title = document.scenario().title.empty() ? document.name() : document.scenario().title;
  rowText({at.x + ui.px(8), at.y}, width - ui.px(12), height, chosen ? ui.theme.accent : ui.theme.text, title);
}

void drawObjects(const PanelContext& ui) {
  MissionSession& mission = ui.session.mission();
  MissionUi& my = ui.state.mission;
  ImGui::SetNextItemWidth(-1);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(10), std::floor(0.5f * (ui.px(26) - ImGui::GetFontSize()))));
  ImGui::InputTextWithHint("##objects", "find", &my.search);
  ImGui::PopStyleVar();
  ui.item("field:find object");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), 0));
  ImGui::BeginChild("object list", ImVec2(0, 0));
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  drawMissionLine(ui);
  if (const auto lines = observerLines(mission, my.search); !lines.empty()) drawLines(ui, "Observers", lines);
  if (const auto lines = gunLines(mission, my.search); !lines.empty()) drawLines(ui, "Guns", lines);
  if (const auto lines = groupLines(mission, my.search); !lines.empty()) drawLines(ui, "Groups", lines);
  if (mission.recording() != nullptr)
    if (const auto lines = vehicleLines(mission, my.search); !lines.empty()) drawLines(ui, "Vehicles", lines);
  if (allNames(mission.shownScenario()).empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::Dummy(ImVec2(1, ui.px(6)));
    ImGui::TextDisabled("Nothing stands here yet. The plus adds vehicles, guns and observers; Missions lists the shipped ones.");
    ImGui::PopTextWrapPos();
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace

void drawObjectsPanel(const PanelContext& ui) {
  MissionUi& my = ui.state.mission;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const int tab = tabStrip(ui, "left", {"Objects", "Missions"}, static_cast<int>(my.left));
  my.left = static_cast<MissionUi::Left>(tab);
  if (my.left == MissionUi::Left::library) return drawLibraryList(ui);
  drawButtons(ui, at, width);
  drawObjects(ui);
}

}  // namespace npsee::editor
