// Driving a vehicle: by the keys W A S D, or by the buttons.

#include "editor/document/camera_moves.h"
#include "editor/panels/mission/panels.h"
#include "editor/ui/controls.h"

#include <npsee/units.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace npsee::editor {
namespace {

/// The selected vehicle if a person drives it at the moment shown; null otherwise.
const VehicleRecord* driven(const PanelContext& ui) {
  const MissionSession& mission = ui.session.mission();
  const int index = mission.document.selected().kind == ObjectRef::Kind::vehicle ? mission.selectedVehicle() : -1;
  return index >= 0 && mission.taken(mission.document.selected().id) ? &mission.recording()->vehicles[static_cast<std::size_t>(index)] : nullptr;
}

/// Gives the wish as a command if it is another one.
void wish(const PanelContext& ui, const std::string& id, double speed, double turn) {
  MissionUi::Driving& now = ui.state.mission.driving;
  if (now.vehicle == id && now.speed_mps == speed && now.turn_radps == turn) return;
  now.vehicle = id;
  now.speed_mps = speed;
  now.turn_radps = turn;
  ui.session.took(ui.session.mission().drive(id, speed, turn));
}

/// Arrows, Home and End: the thesis's keys move a free camera's viewpoint; the others turn, or shift a plan.
void moveCamera(const PanelContext& ui) {
  using CameraKind = render::MissionCamera::Kind;
  render::MissionCamera& camera = ui.session.mission().view.camera;
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), true) ? 1.0 : 0.0; };
  const double x = pressed(ImGuiKey_RightArrow) - pressed(ImGuiKey_LeftArrow), z = pressed(ImGuiKey_DownArrow) - pressed(ImGuiKey_UpArrow), y = pressed(ImGuiKey_Home) - pressed(ImGuiKey_End);
  if (x == 0.0 && y == 0.0 && z == 0.0) return;
  if (camera.kind == CameraKind::free) {
    const double step = keyStep_m(length(camera.target - camera.eye));
    camera.eye = camera.eye + step * Vec3{x, y, z};
    camera.target = camera.target + step * Vec3{x, y, z};
  } else if (camera.kind == CameraKind::plan) {
    camera.target = camera.target + 0.1 * camera.span_m * Vec3{x, 0.0, z};
    camera.span_m = std::clamp(camera.span_m * std::pow(0.8, y), 50.0, 400000.0);
  } else if (camera.kind == CameraKind::observer) {
    camera.turn_rad += 5.0 * x / kMilPerRad;
    camera.raise_rad -= 5.0 * z / kMilPerRad;
    camera.field_mil = std::clamp(camera.field_mil * std::pow(0.8, y), 10.0, 600.0);
  } else {
    camera.yaw_rad += 0.1 * x;
    camera.pitch_rad = std::clamp(camera.pitch_rad - 0.1 * z, 0.01, 1.55);
    camera.distance_m = std::clamp(camera.distance_m * std::pow(0.8, y), 5.0, 300000.0);
  }
}

}  // namespace

void handleMissionKeys(const PanelContext& ui) {
  MissionUi::Driving& now = ui.state.mission.driving;
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.WantTextInput && !io.KeyCtrl && !io.KeyAlt) moveCamera(ui);
  const VehicleRecord* vehicle = driven(ui);
  if (vehicle == nullptr) {
    now = {};
    return;
  }
  if (io.WantTextInput || io.KeyCtrl) return;
  const auto held = [&](char key) { return io.KeysDown[static_cast<int>(key)]; };
  const bool any = held('W') || held('A') || held('S') || held('D');
  if (any) {
    const double speed = held('W') ? vehicle->type.speed_mps * (io.KeyShift ? 0.4 : 1.0) : held('S') ? 0.0 : now.vehicle == vehicle->id ? now.speed_mps : 0.0;
    wish(ui, vehicle->id, speed, held('A') ? -vehicle->type.turn_radps : held('D') ? vehicle->type.turn_radps : 0.0);
  } else if (now.keys) {
    // Letting go keeps the speed and ends the turn, as with a wheel.
    wish(ui, vehicle->id, now.speed_mps, 0.0);
  }
  now.keys = any;
}

void drawVehicleCommands(const PanelContext& ui) {
  MissionSession& mission = ui.session.mission();
  const std::string id = mission.document.selected().id;
  const int index = mission.selectedVehicle();
  if (index < 0) return ImGui::TextDisabled("It is not in the simulation.");
  const VehicleRecord& vehicle = mission.recording()->vehicles[static_cast<std::size_t>(index)];
  ImGui::PushTextWrapPos(0);
  if (vehicle.destroyedAt(mission.clock.time_s)) {
    ImGui::TextDisabled("It is destroyed.");
    return ImGui::PopTextWrapPos();
  }
  if (!mission.taken(id)) {
    ImGui::TextUnformatted("It drives by its behaviour. Take the wheel to drive it yourself from this moment on, and to shoot.");
    ImGui::PopTextWrapPos();
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    if (textButton(ui, "Take the wheel", "take", true) && ui.session.took(mission.take(id))) mission.clock.playing = true;
    return;
  }
  ImGui::TextDisabled("W drives, S stops, A and D turn; Shift is slow.");
  ImGui::PopTextWrapPos();
  if (textButton(ui, "Hand back", "release")) ui.session.took(mission.release(id));
  heading(ui, "Drive");
  const MissionUi::Driving& now = ui.state.mission.driving;
  const double full = vehicle.type.speed_mps, turn = vehicle.type.turn_radps;
  const bool mine = now.vehicle == id;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(2), ui.px(4)));
  for (const auto& [word, share] : std::array<std::pair<const char*, double>, 4>{{{"stop", 0.0}, {"slow", 0.25}, {"half", 0.5}, {"full", 1.0}}}) {
    if (chip(ui, word, std::string("speed ") + word, mine && now.speed_mps == share * full)) wish(ui, id, share * full, mine ? now.turn_radps : 0.0);
    ImGui::SameLine();
  }
  ImGui::NewLine();
  for (const auto& [word, share] : std::array<std::pair<const char*, double>, 3>{{{"left", -1.0}, {"straight", 0.0}, {"right", 1.0}}}) {
    if (chip(ui, word, std::string("turn ") + word, mine && now.turn_radps == share * turn)) wish(ui, id, mine ? now.speed_mps : 0.0, share * turn);
    ImGui::SameLine();
  }
  ImGui::NewLine();
  ImGui::PopStyleVar();
  heading(ui, "Shoot");
  if (vehicle.type.weapon == 0) return ImGui::TextDisabled("It is unarmed.");
  if (textButton(ui, "Pick what to shoot at", "shoot", ui.state.mission.click == GroundClick::shoot)) ui.state.mission.click = GroundClick::shoot;
}

}  // namespace npsee::editor
