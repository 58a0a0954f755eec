#include "editor/panels/mission/panels.h"

#include <cmath>

namespace npsee::editor {
namespace {

using Kind = ObjectRef::Kind;

constexpr float kDragThreshold_px = 4.0f;

/// A gun is added to the battery that is selected, or whose gun is.
std::string selectedBattery(const MissionDocument& document) {
  if (document.selected().kind == Kind::battery) return document.selected().id;
  for (const BatterySetup& battery : document.scenario().batteries)
    for (const GunSetup& gun : battery.guns)
      if (document.selected() == ObjectRef{Kind::gun, gun.id}) return battery.id;
  return document.scenario().batteries.empty() ? std::string() : document.scenario().batteries.front().id;
}

}  // namespace

bool useGroundClick(const PanelContext& ui, const Place& at, const std::string& vehicle_there) {
  MissionUi& my = ui.state.mission;
  MissionSession& mission = ui.session.mission();
  MissionDocument& document = mission.document;
  const GroundClick click = my.click;
  my.click = GroundClick::select;
  const Place whole{std::round(at.x_m), std::round(at.z_m)};
  switch (click) {
    case GroundClick::select: return false;
    case GroundClick::vehicle: ui.session.took(document.add("Add vehicle", [&](Scenario& s) { return addVehicle(s, my.click_type, whole); })); break;
    case GroundClick::gun: ui.session.took(document.add("Add gun", [&](Scenario& s) { return addGun(s, selectedBattery(document), whole); })); break;
    case GroundClick::observer: ui.session.took(document.add("Add observer", [&](Scenario& s) { return addObserver(s, whole); })); break;
    case GroundClick::group: ui.session.took(document.add("Add group", [&](Scenario& s) { return addGroup(s, my.click_type, whole); })); break;
    case GroundClick::goal:
      ui.session.took(document.edit("Add goal", {}, [&](Scenario& s) {
        for (VehicleSetup& vehicle : s.vehicles)
          if (document.selected() == ObjectRef{Kind::vehicle, vehicle.id}) {
            vehicle.goals.push_back(whole);
            vehicle.behaviour = Behaviour::goals;
          }
      }));
      my.click = GroundClick::goal;  // goals are set in a row
      break;
    case GroundClick::call_for_fire: {
      mission.call.grid = whole;
      if (mission.selectedObserver() >= 0) {
        const auto [azimuth, distance] = polarTo(*mission.recording(), mission.selectedObserver(), mission.clock.time_s, whole);
        mission.call.azimuth_mil = std::round(azimuth);
        mission.call.distance_m = std::round(distance);
      }
      break;
    }
    case GroundClick::shoot:
      if (document.selected().kind == Kind::vehicle) ui.session.took(mission.shoot(document.selected().id, at, vehicle_there));
      break;
  }
  return true;
}

std::string groundClickHint(const PanelContext& ui) {
  switch (ui.state.mission.click) {
    case GroundClick::select: return ui.session.mission().ruler.active ? "Click two points of the ground; Escape ends." : std::string();
    case GroundClick::vehicle: return "Click where the vehicle starts; Escape cancels.";
    case GroundClick::group: return "Click the middle of the vehicles' area; Escape cancels.";
    case GroundClick::gun: return "Click where the gun stands; Escape cancels.";
    case GroundClick::observer: return "Click where the observer stands; Escape cancels.";
    case GroundClick::goal: return "Click the goals in turn; Escape ends.";
    case GroundClick::call_for_fire: return "Click the target; Escape cancels.";
    case GroundClick::shoot: return "Click what to shoot at; Escape cancels.";
  }
  return {};
}

bool dragObject(const PanelContext& ui, bool pressed, const std::optional<ObjectRef>& under, const std::optional<Place>& ground, bool held) {
  MissionUi::Drag& drag = ui.state.mission.drag;
  if (pressed) drag = under && ground ? MissionUi::Drag{ui.session.mission().editable(*under), *ground, true, false, ImGui::GetIO().MousePos} : MissionUi::Drag{};
  if (!held) drag = {};
  if (!drag.pressed || !ground) return drag.moving;
  const ImVec2 now = ImGui::GetIO().MousePos;
  if (!drag.moving && std::hypot(now.x - drag.at.x, now.y - drag.at.y) < kDragThreshold_px * ui.scale) return false;
  drag.moving = true;
  const double dx = ground->x_m - drag.grabbed.x_m, dz = ground->z_m - drag.grabbed.z_m;
  if (dx == 0.0 && dz == 0.0) return true;
  MissionDocument& document = ui.session.mission().document;
  if (!exists(document.scenario(), drag.ref)) ui.session.took(ui.session.mission().adopt());
  const auto before = placeOf(document.scenario(), drag.ref);
  ui.session.took(document.edit("Move " + drag.ref.id, "move " + drag.ref.id, [&](Scenario& scenario) { shift(scenario, drag.ref, dx, dz); }));
  const auto after = placeOf(document.scenario(), drag.ref);
  // What the world's edge or a refusal kept back does not count, so that the thing comes along again when the pointer returns.
  if (before && after) drag.grabbed = {drag.grabbed.x_m + after->x_m - before->x_m, drag.grabbed.z_m + after->z_m - before->z_m};
  return true;
}

}  // namespace npsee::editor
