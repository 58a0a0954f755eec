// Taking the observer's place: call for fire, corrections, grade.

#include "editor/panels/mission/panels.h"
#include "editor/panels/row.h"
#include "editor/ui/controls.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace npsee::editor {
namespace {

struct MethodEntry {
  FireMethod method;
  const char *key, *words;
};
constexpr std::array kMethods{
    MethodEntry{FireMethod::adjust_fire, "adjust_fire", "adjust fire"},
    MethodEntry{FireMethod::fire_for_effect, "fire_for_effect", "fire for effect"},
    MethodEntry{FireMethod::suppress, "suppress", "suppress"},
    MethodEntry{FireMethod::immediate_suppression, "immediate_suppression", "immediate suppression"},
    MethodEntry{FireMethod::smoke, "smoke", "smoke"},
    MethodEntry{FireMethod::illuminate, "illuminate", "illuminate"},
};

/// A row of the form: label, then what the caller draws into the box.
Box formRow(const PanelContext& ui, const char* label) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, column = std::floor(std::min(ui.px(112), 0.38f * width)), height = ui.px(26);
  rowText(at, column - ui.px(6), height, ui.theme.dim, label);
  ImGui::Dummy(ImVec2(width, height));
  return {{at.x + column, at.y}, width - column, height};
}

/// A number of the form: drag it, or type it with a unit.
void formNumber(const PanelContext& ui, const std::string& name, const Box& whole, double& value, Range hard, double span, Unit unit, const std::string& letter = {}) {
  const float room = ui.px(30);
  const Box box{whole.at, whole.width - room, whole.height};
  if (typingIn(ui, name)) {
    if (const auto text = typingField(ui, box)) {
      const auto typed = parseQuantity(*text, unit == Unit::mil ? Unit::none : unit);
      if (typed) {
        value = std::clamp(*typed, hard.min, hard.max);
        ui.state.typing = {};
      } else {
        refuseTyping(ui, typed.error().text());
      }
    }
  } else if (const auto changed = numberField(ui, name, {value, {0.0, span}, hard, Scale::linear, false, false}, box, letter)) {
    value = *changed;
  }
  ImGui::PushFont(ui.fonts.small);
  rowText({whole.right() - room + ui.px(4), whole.at.y}, room, whole.height, ui.theme.dim, unit == Unit::mil ? "mil" : "m");
  ImGui::PopFont();
}

void takeScripted(const PanelContext& ui, const std::string& name, double& value) {
  const auto typed = ui.state.typed.find(name);
  if (typed == ui.state.typed.end()) return;
  const auto number = parseQuantity(typed->second, Unit::none);
  if (number) value = *number;
  else ui.state.typed_error = number.error().text();
  ui.state.typed.erase(typed);
}

void drawMethod(const PanelContext& ui, CallForm& call) {
  const Box box = formRow(ui, "Warning order");
  const ImVec2 below = ImGui::GetCursorScreenPos();
  const auto now = std::ranges::find(kMethods, call.method, &MethodEntry::method);
  ImGui::SetCursorScreenPos({box.at.x, box.at.y + ui.px(1)});
  ImGui::SetNextItemWidth(box.width);
  const bool open = beginChoice(ui, "call method", now == kMethods.end() ? "adjust fire" : now->words);
  if (!open) ui.item("choice:call.method");
  if (open) {
    for (const MethodEntry& entry : kMethods) {
      if (ImGui::Selectable(entry.words, entry.method == call.method, 0, ImVec2(0, ui.px(22)))) call.method = entry.method;
      ui.item(std::string("choice:call.method=") + entry.key);
    }
    ImGui::EndCombo();
  }
  ImGui::SetCursorScreenPos(below);
}

void drawKnownPoint(const PanelContext& ui, CallForm& call, int observer) {
  const MissionSession& mission = ui.session.mission();
  const Box box = formRow(ui, "Known point");
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({box.at.x, box.at.y + ui.px(1)});
  ImGui::SetNextItemWidth(box.width);
  if (beginChoice(ui, "call known", call.known.empty() ? "choose" : call.known)) {
    for (const KnownPoint& point : knownPoints(*mission.recording(), observer, mission.clock.time_s)) {
      if (ImGui::Selectable(point.name.c_str(), point.name == call.known, 0, ImVec2(0, ui.px(22)))) call.known = point.name;
      ui.item("choice:call.known=" + point.name);
    }
    ImGui::EndCombo();
  } else {
    ui.item("choice:call.known");
  }
  ImGui::SetCursorScreenPos(below);
}

/// What lies in the middle of the observer's glass, as a polar location.
void readReticle(const PanelContext& ui, CallForm& call, int observer) {
  const MissionSession& mission = ui.session.mission();
  constexpr int kWidth = 1000, kHeight = 1000;
  const render::MissionEye eye = render::missionEye(*mission.recording(), mission.clock.time_s, mission.view.camera, kWidth, kHeight);
  const auto ground = eye.groundAt(mission.recording()->terrain, 0.5 * kWidth, 0.5 * kHeight);
  call.locate = Locate::polar;
  if (!ground) {
    ui.session.notices.error = "There is no ground in the middle of the glass.\n  Lower the view, or type the distance.";
    return;
  }
  const auto [azimuth, distance] = polarTo(*mission.recording(), observer, mission.clock.time_s, {ground->x, ground->z});
  call.azimuth_mil = std::round(azimuth);
  call.distance_m = std::round(distance / 10.0) * 10.0;
  call.grid = {std::round(ground->x), std::round(ground->z)};
}

/// The same place said in another way; a shift is from a point that has to be chosen first.
void sayOtherwise(const PanelContext& ui, CallForm& call, int observer, Locate way) {
  const MissionSession& mission = ui.session.mission();
  if (const auto place = placeOfCall(call, *mission.recording(), observer, mission.clock.time_s)) {
    const auto [azimuth, distance] = polarTo(*mission.recording(), observer, mission.clock.time_s, *place);
    call.grid = {std::round(place->x_m), std::round(place->z_m)};
    call.azimuth_mil = std::round(azimuth);
    call.distance_m = std::round(distance);
  }
  call.locate = way;
}

void drawLocation(const PanelContext& ui, CallForm& call, int observer) {
  const Box box = formRow(ui, "Location");
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({box.at.x, box.at.y + ui.px(2)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(2), 0));
  constexpr std::array<std::pair<Locate, const char*>, 3> kWays{{{Locate::grid, "grid"}, {Locate::polar, "polar"}, {Locate::shift, "shift"}}};
  for (const auto& [way, word] : kWays) {
    if (chip(ui, word, std::string("by ") + word, call.locate == way)) sayOtherwise(ui, call, observer, way);
    ImGui::SameLine();
  }
  ImGui::SetCursorScreenPos(below);
  const Box from = formRow(ui, "Taken from");
  const ImVec2 after_from = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({from.at.x, from.at.y + ui.px(2)});
  if (chip(ui, "a click", "pick target", ui.state.mission.click == GroundClick::call_for_fire, "The next click on the ground is the target")) {
    ui.state.mission.click = GroundClick::call_for_fire;
    if (call.locate == Locate::shift) call.locate = Locate::grid;
  }
  const render::MissionCamera& camera = ui.session.mission().view.camera;
  if (camera.kind == render::MissionCamera::Kind::observer) {
    ImGui::SameLine();
    if (chip(ui, "the reticle", "from the reticle", false, "Azimuth and distance of the ground in the middle of the glass")) readReticle(ui, call, observer);
  }
  ImGui::PopStyleVar();
  ImGui::SetCursorScreenPos(after_from);
  const WorldSetup& world = ui.session.mission().document.scenario().world;
  const auto number = [&](const char* label, const char* name, double& value, Range hard, double span, Unit unit) {
    takeScripted(ui, name, value);
    const Box row = formRow(ui, label);
    const ImVec2 after = ImGui::GetCursorScreenPos();
    formNumber(ui, name, row, value, hard, span, unit);
    ImGui::SetCursorScreenPos(after);
  };
  if (call.locate == Locate::grid) {
    number("East (x)", "call.x", call.grid.x_m, {0.0, world.size_x_m}, 600.0, Unit::metre);
    number("South (z)", "call.z", call.grid.z_m, {0.0, world.size_z_m}, 600.0, Unit::metre);
  } else if (call.locate == Locate::polar) {
    number("Azimuth", "call.azimuth", call.azimuth_mil, {0.0, 6400.0}, 300.0, Unit::mil);
    number("Distance", "call.distance", call.distance_m, {1.0, 100000.0}, 3000.0, Unit::metre);
  } else {
    drawKnownPoint(ui, call, observer);
    number("Right", "call.right", call.right_m, {-20000.0, 20000.0}, 3000.0, Unit::metre);
    number("Add", "call.add", call.add_m, {-20000.0, 20000.0}, 3000.0, Unit::metre);
  }
}

void drawCall(const PanelContext& ui, const std::string& id, int observer) {
  MissionSession& mission = ui.session.mission();
  CallForm& call = mission.call;
  heading(ui, "Call for fire");
  drawMethod(ui, call);
  drawLocation(ui, call, observer);
  const Box box = formRow(ui, "Target");
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({box.at.x, box.at.y + ui.px(1)});
  ImGui::SetNextItemWidth(box.width);
  ImGui::InputTextWithHint("##target", "description", &call.description);
  ui.item("field:call.description");
  ImGui::SetCursorScreenPos(below);
  if (const auto place = placeOfCall(call, *mission.recording(), observer, mission.clock.time_s)) {
    const auto [azimuth, distance] = polarTo(*mission.recording(), observer, mission.clock.time_s, *place);
    ImGui::PushFont(ui.fonts.small);
    ImGui::TextDisabled("%s", ("Grid " + placeText(place->x_m, place->z_m) + ", azimuth " + std::to_string(std::lround(azimuth)) + " mil, " + distanceText(distance)).c_str());
    ImGui::PopFont();
  }
  if (textButton(ui, "Call for fire", "call for fire", true)) ui.session.took(mission.callForFire(id));
}

std::string lastSpot(const Recording& recording, int number, double t) {
  for (std::size_t i = eventsUntil(recording.events, t); i-- > 0;)
    if (recording.events[i].kind == EventKind::spot && static_cast<int>(recording.events[i].number("mission")) == number) return eventSentence(recording.events[i]);
  return {};
}

/// One mission under way. Names of its widgets end in its number unless it is the newest.
void drawOpen(const PanelContext& ui, const std::string& id, const OpenMission& open, bool newest) {
  MissionSession& mission = ui.session.mission();
  CorrectionForm& form = mission.corrections[open.number];
  const std::string number = newest ? std::string() : std::to_string(open.number), dot = newest ? std::string() : '.' + number, space = newest ? std::string() : ' ' + number;
  std::string method = open.effect ? "fire for effect" : open.method;
  std::ranges::replace(method, '_', ' ');
  heading(ui, ("Mission " + std::to_string(open.number) + ", " + method).c_str());
  ImGui::PushTextWrapPos(0);
  const std::string spot = lastSpot(*mission.recording(), open.number, mission.clock.time_s);
  ImGui::TextDisabled("%s", spot.empty() ? "Waiting for the first burst. In the observer's view a click on it measures the deviation." : spot.c_str());
  ImGui::PopTextWrapPos();
  for (const auto& [label, key, value] : {std::tuple("Right (left -)", ".right", &form.right_m), std::tuple("Add (drop -)", ".add", &form.add_m)}) {
    const std::string name = "correct" + dot + key;
    takeScripted(ui, name, *value);
    const Box row = formRow(ui, label);
    const ImVec2 after = ImGui::GetCursorScreenPos();
    formNumber(ui, name, row, *value, {-5000.0, 5000.0}, 3000.0, Unit::metre);
    ImGui::SetCursorScreenPos(after);
  }
  if (textButton(ui, form.right_m == 0.0 && form.add_m == 0.0 ? "Repeat" : "Correct", "correct" + space, newest)) ui.session.took(mission.correct(id, open.number, false));
  ImGui::SameLine();
  if (textButton(ui, "Fire for effect", "fire for effect" + space)) ui.session.took(mission.correct(id, open.number, true));
  ImGui::SameLine();
  if (textButton(ui, "End", "end mission" + space)) ui.session.took(mission.endMission(id, open.number));
}

void drawGrade(const PanelContext& ui, const std::string& id) {
  const MissionSession& mission = ui.session.mission();
  const Grade grade = gradeOf(*mission.recording(), id, mission.clock.time_s);
  heading(ui, "Your corrections");
  ImGui::PushTextWrapPos(0);
  if (grade.corrections == 0) ImGui::TextDisabled("They are compared with what the rules would have said.");
  else ImGui::TextUnformatted((std::to_string(grade.corrections) + (grade.corrections == 1 ? " correction, " : " corrections, ") + distanceText(grade.mean_m) + " from the rules' on average, the last one " + distanceText(*grade.last_m) + '.').c_str());
  ImGui::PopTextWrapPos();
  ui.item("grade");
}

}  // namespace

void drawObserverCommands(const PanelContext& ui) {
  MissionSession& mission = ui.session.mission();
  const std::string id = mission.document.selected().id;
  const int observer = mission.selectedObserver();
  if (observer < 0) return ImGui::TextDisabled("He is not in the simulation.");
  if (!mission.taken(id)) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted("The rules decide for him. Take his place to call and correct fire yourself from this moment on; you are graded against the rules.");
    ImGui::PopTextWrapPos();
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    if (textButton(ui, "Take his place", "take", true) && ui.session.took(mission.take(id))) mission.look(render::MissionCamera::Kind::observer, observer);
    return;
  }
  if (textButton(ui, "Hand back to the rules", "release")) ui.session.took(mission.release(id));
  drawCall(ui, id, observer);
  // The newest first: it is the one that is measured and most likely corrected.
  const auto open = openMissions(*mission.recording(), id, mission.clock.time_s);
  for (auto one = open.rbegin(); one != open.rend(); ++one) drawOpen(ui, id, *one, one == open.rbegin());
  drawGrade(ui, id);
}

}  // namespace npsee::editor
