#include "editor/panels/mission/panels.h"
#include "editor/ui/controls.h"
#include "sim/core/text.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace npsee::editor {
namespace {

using Kind = ObjectRef::Kind;

/// A label and what it is now.
void fact(const PanelContext& ui, const std::string& label, const std::string& value, ImU32 colour = 0) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(22), column = std::min(ui.px(120), 0.42f * width);
  rowText(at, column, height, ui.theme.dim, label);
  rowText({at.x + column, at.y}, width - column, height, colour != 0 ? colour : ui.theme.text, value);
  ImGui::Dummy(ImVec2(width, height));
}

void words(const PanelContext& ui, const std::string& text, ImU32 colour) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::Dummy(ImVec2(1, ui.px(2)));
}

/// What he believes of one contact: how sure he is that it is hostile, how far away, and by how much he errs about its place.
void belief(const PanelContext& ui, const Recording& recording, const BeliefStep& step, const Vec3& eye, double t) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(24);
  const auto target = static_cast<std::size_t>(step.target);
  const std::string& id = recording.vehicles[target].id;
  ImGui::PushID(step.target);
  if (ImGui::InvisibleButton("belief", ImVec2(width, height))) ui.session.mission().selectVehicle(step.target);
  ImGui::PopID();
  ui.item("belief:" + id);
  const Vec3 real = recording.vehiclePlace(target, t);
  const double error = std::hypot(real.x - step.believed_m.x, real.z - step.believed_m.z), range = std::hypot(step.believed_m.x - eye.x, step.believed_m.z - eye.z);
  if (ui.resting("belief:" + id, "Hostile " + withDecimals(step.hostile, 2) + ", friendly " + withDecimals(step.friendly, 2) + "; believed at " + placeText(step.believed_m.x, step.believed_m.z) + ", " + distanceText(error) + " from where it is.")) tooltip(ui, ui.state.hint);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) list.AddRectFilled(at, {at.x + width, at.y + height}, ui.theme.raised, ui.px(3));
  const float bar = ui.px(64), right = at.x + width;
  rowText({at.x + ui.px(4), at.y}, width - bar - ui.px(150), height, step.seen ? ui.theme.text : ui.theme.dim, id);
  ImGui::PushFont(ui.fonts.small);
  rowTextRight(right - bar - ui.px(64), at.y, height, ui.theme.dim, step.seen ? distanceText(range) : "lost");
  rowTextRight(right - bar - ui.px(8), at.y, height, error < 0.5 ? ui.theme.dim : ui.theme.accent, error < 0.5 ? "exact" : "\u00b1" + withDecimals(error, 0) + " m");
  ImGui::PopFont();
  // Hostile from the left, friendly from the right, what is not known between them.
  const float y = at.y + std::floor(0.5f * height) - ui.px(3), x = right - bar;
  list.AddRectFilled({x, y}, {right, y + ui.px(6)}, ui.theme.line, ui.px(3));
  list.AddRectFilled({x, y}, {x + bar * static_cast<float>(std::clamp(step.hostile, 0.0, 1.0)), y + ui.px(6)}, ui.theme.error, ui.px(3));
  list.AddRectFilled({right - bar * static_cast<float>(std::clamp(step.friendly, 0.0, 1.0)), y}, {right, y + ui.px(6)}, ui.theme.geometry, ui.px(3));
}

void beliefs(const PanelContext& ui, const Recording& recording, int observer, double t) {
  const auto& steps = recording.observers[static_cast<std::size_t>(observer)].beliefs;
  std::set<int> told;
  std::vector<const BeliefStep*> now;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step)
    if (step->t_s <= t && step->target >= 0 && step->target < static_cast<int>(recording.vehicles.size()) && told.insert(step->target).second) now.push_back(&*step);
  std::ranges::sort(now, {}, [](const BeliefStep* step) { return std::pair(!step->seen, step->target); });
  heading(ui, ("Beliefs  " + std::to_string(now.size())).c_str());
  if (now.empty()) ImGui::TextDisabled("He has seen nothing yet.");
  constexpr std::size_t kMost = 200;
  const Vec3 eye = recording.observerEye(static_cast<std::size_t>(observer), t);
  for (std::size_t i = 0; i < std::min(now.size(), kMost); ++i) belief(ui, recording, *now[i], eye, t);
  if (now.size() > kMost) ImGui::TextDisabled("and %zu more", now.size() - kMost);
}

/// The newest decision of a rule about him, with the facts it fired on.
void lastRule(const PanelContext& ui, const Recording& recording, const std::string& observer, double t) {
  heading(ui, "Last rule fired");
  for (std::size_t i = eventsUntil(recording.events, t); i-- > 0;) {
    const MissionEvent& event = recording.events[i];
    if (event.text("observer") != observer || event.text("rule").empty()) continue;
    ImGui::PushFont(ui.fonts.numbers);
    words(ui, event.text("rule"), ui.theme.accent);
    ImGui::PopFont();
    ImGui::PushFont(ui.fonts.small);
    words(ui, "At " + momentText(event.t_s) + ": " + eventSentence(event), ui.theme.text);
    if (const auto* facts = event.find("facts"))
      if (const auto* list = std::get_if<std::vector<std::string>>(facts))
        for (const std::string& one : *list) words(ui, one, ui.theme.dim);
    ImGui::PopFont();
    return;
  }
  ImGui::TextDisabled("No rule has decided anything yet.");
}

void observerMind(const PanelContext& ui, const Recording& recording) {
  const MissionSession& mission = ui.session.mission();
  const int observer = mission.selectedObserver();
  const double t = mission.clock.time_s;
  const std::string& id = mission.document.selected().id;
  if (observer < 0) return ImGui::TextDisabled("He is not in the simulation.");
  const auto open = openMissions(recording, id, t);
  heading(ui, "Fire missions");
  if (open.empty()) ImGui::TextDisabled("None under way.");
  for (const OpenMission& one : open) {
    std::string method = one.effect ? "fire for effect" : one.method;
    std::ranges::replace(method, '_', ' ');
    fact(ui, "Mission " + std::to_string(one.number), method + (one.target.empty() ? "" : " on " + one.target) + ", " + std::to_string(one.rounds) + (one.rounds == 1 ? " round" : " rounds"));
  }
  beliefs(ui, recording, observer, t);
  lastRule(ui, recording, id, t);
}

void vehicleState(const PanelContext& ui, const Recording& recording, int index) {
  const double t = ui.session.mission().clock.time_s;
  const VehicleRecord& vehicle = recording.vehicles[static_cast<std::size_t>(index)];
  const Pose pose = vehicle.track.at(t);
  double heading_mil = std::fmod(pose.heading_rad * kMilPerRad, 6400.0);
  if (heading_mil < 0.0) heading_mil += 6400.0;
  heading(ui, "Now");
  fact(ui, "Place", placeText(pose.x_m, pose.z_m));
  fact(ui, "Height", distanceText(recording.terrain.surface(pose.x_m, pose.z_m)));
  fact(ui, "Speed", withDecimals(pose.speed_mps, 1) + " m/s, " + withDecimals(pose.speed_mps * 3.6, 0) + " km/h");
  fact(ui, "Heading", withDecimals(heading_mil, 0) + " mil");
  const DamageStep* damage = vehicle.damageAt(t);
  const bool destroyed = vehicle.destroyedAt(t);
  fact(ui, "Hull", damage == nullptr ? "unharmed" : destroyed ? "destroyed" : withDecimals(100.0 * (1.0 - damage->hull), 0) + " %", destroyed ? ui.theme.error : 0);
  if (damage != nullptr && !destroyed) {
    fact(ui, "Can move", damage->mobility ? "yes" : "no", damage->mobility ? 0 : ui.theme.error);
    fact(ui, "Can shoot", damage->firepower ? "yes" : "no", damage->firepower ? 0 : ui.theme.error);
  }
  heading(ui, "What happened to it");
  int lines = 0;
  for (std::size_t i = eventsUntil(recording.events, t); i-- > 0 && lines < 12;) {
    if (recording.events[i].text("target") != vehicle.id || !marked(recording.events[i].kind)) continue;
    ++lines;
    ImGui::PushFont(ui.fonts.small);
    words(ui, momentText(recording.events[i].t_s) + "  " + eventSentence(recording.events[i]), ui.theme.text);
    ImGui::PopFont();
  }
  if (lines == 0) ImGui::TextDisabled("Nothing yet.");
}

void gunState(const PanelContext& ui, const Recording& recording, int index) {
  const double t = ui.session.mission().clock.time_s;
  const GunRecord& gun = recording.guns[static_cast<std::size_t>(index)];
  const auto [azimuth, elevation] = gun.lineAt(t);
  int fired = 0;
  const ShellRecord* last = nullptr;
  for (const ShellRecord& shell : recording.shells)
    if (shell.gun == index && shell.fired_s <= t) {
      ++fired;
      last = &shell;
    }
  double mil = std::fmod(azimuth * kMilPerRad, 6400.0);
  if (mil < 0.0) mil += 6400.0;
  heading(ui, "Now");
  fact(ui, "Elevation", withDecimals(elevation * kMilPerRad, 1) + " mil");
  fact(ui, "Azimuth", withDecimals(mil, 1) + " mil");
  if (gun.battery >= 0 && gun.battery < static_cast<int>(recording.scenario.batteries.size())) {
    const int rounds = recording.scenario.batteries[static_cast<std::size_t>(gun.battery)].rounds;
    fact(ui, "Rounds left", std::to_string(std::max(0, rounds - fired)) + " of " + std::to_string(rounds), fired >= rounds ? ui.theme.error : 0);
  }
  if (last != nullptr) fact(ui, "Last shot", "shell " + std::to_string(last->number) + " at " + momentText(last->fired_s));
  fact(ui, "Muzzle", placeText(gun.muzzle_m.x, gun.muzzle_m.z) + ", " + distanceText(gun.muzzle_m.y) + " up");
}

void summary(const PanelContext& ui, const Recording& recording) {
  const MissionSession& mission = ui.session.mission();
  const double t = mission.clock.time_s;
  heading(ui, "Until now");
  const auto count = [&](EventKind kind) {
    const std::size_t until = eventsUntil(recording.events, t);
    return std::to_string(std::ranges::count(recording.events.begin(), recording.events.begin() + static_cast<std::ptrdiff_t>(until), kind, &MissionEvent::kind));
  };
  fact(ui, "Calls for fire", count(EventKind::call));
  fact(ui, "Refusals", count(EventKind::refuse));
  fact(ui, "Shots", count(EventKind::fire));
  fact(ui, "Corrections", count(EventKind::correction));
  fact(ui, "Destroyed", count(EventKind::destroyed));
  fact(ui, "Warnings", count(EventKind::warning));
  const auto& clauses = recording.scenario.expect;
  if (clauses.empty()) return;
  heading(ui, "What the mission expects");
  if (!recording.finished) return ImGui::TextDisabled("Known when the simulation has ended.");
  const auto unmet = unmetExpectations(recording);
  fact(ui, "Met", std::to_string(clauses.size() - std::min(unmet.size(), clauses.size())) + " of " + std::to_string(clauses.size()), unmet.empty() ? ui.theme.good : ui.theme.error);
  ImGui::PushFont(ui.fonts.small);
  for (const std::string& sentence : unmet) words(ui, sentence, ui.theme.error);
  ImGui::PopFont();
}

}  // namespace

void drawMindPanel(const PanelContext& ui) {
  const MissionSession& mission = ui.session.mission();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(8), ui.px(1)));
  ImGui::BeginChild("mind", ImVec2(0, 0), false, ImGuiWindowFlags_NoBackground);
  if (const Recording* recording = mission.recording()) {
    if (mission.document.selected().kind == Kind::observer) observerMind(ui, *recording);
    else if (mission.selectedVehicle() >= 0) vehicleState(ui, *recording, mission.selectedVehicle());
    else if (mission.selectedGun() >= 0) gunState(ui, *recording, mission.selectedGun());
    else if (mission.document.selected().kind == Kind::mission) summary(ui, *recording);
    else ImGui::TextDisabled("Its parts are in the list on the left.");
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace npsee::editor
