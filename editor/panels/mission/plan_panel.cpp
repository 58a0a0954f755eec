#include "editor/panels/mission/panels.h"
#include "editor/panels/mission/plan_view.h"
#include "editor/ui/controls.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace npsee::editor {
namespace {

using Kind = ObjectRef::Kind;

/// The part of the world with everything in it, or the whole where nothing is.
void frameWorld(const PanelContext& ui, const Box& box) {
  const MissionSession& mission = ui.session.mission();
  const Recording& recording = *mission.recording();
  MissionUi::Plan& plan = ui.state.mission.plan;
  double low_x = 1e300, high_x = -1e300, low_z = 1e300, high_z = -1e300;
  const auto add = [&](double x, double z) {
    low_x = std::min(low_x, x);
    high_x = std::max(high_x, x);
    low_z = std::min(low_z, z);
    high_z = std::max(high_z, z);
  };
  for (std::size_t i = 0; i < recording.vehicles.size(); ++i) {
    const Pose pose = recording.vehicles[i].track.at(mission.clock.time_s);
    add(pose.x_m, pose.z_m);
  }
  for (const GunRecord& gun : recording.guns) add(gun.muzzle_m.x, gun.muzzle_m.z);
  if (low_x > high_x) {
    add(0.0, 0.0);
    add(recording.terrain.sizeX(), recording.terrain.sizeZ());
  }
  plan.centre_x = 0.5 * (low_x + high_x);
  plan.centre_z = 0.5 * (low_z + high_z);
  plan.metre_per_px = std::max({1.25 * (high_x - low_x) / static_cast<double>(box.width), 1.25 * (high_z - low_z) / static_cast<double>(box.height), 400.0 / static_cast<double>(box.width)});
  plan.placed = true;
  plan.mission = mission.missionNumber();
}

struct Thing {
  ObjectRef ref;
  Place at;
  Symbol symbol;
  Side side;
  bool destroyed;
  std::string name;
};

/// Everything on the plan, what is drawn last on top.
std::vector<Thing> things(const PanelContext& ui) {
  const MissionSession& mission = ui.session.mission();
  const Recording& recording = *mission.recording();
  const double t = mission.clock.time_s;
  std::vector<Thing> out;
  for (int i = 0; i < static_cast<int>(recording.vehicles.size()); ++i) {
    const VehicleRecord& vehicle = recording.vehicles[static_cast<std::size_t>(i)];
    const ObjectRef& owner = mission.owner(i);
    if (owner.kind == Kind::observer) continue;
    const Pose pose = vehicle.track.at(t);
    out.push_back({owner, {pose.x_m, pose.z_m}, symbolOf(vehicle.type.side), vehicle.type.side, vehicle.destroyedAt(t), vehicle.id});
  }
  for (const GunRecord& gun : recording.guns) out.push_back({{Kind::gun, gun.id}, {gun.muzzle_m.x, gun.muzzle_m.z}, Symbol::gun, Side::friendly, false, gun.id});
  for (std::size_t i = 0; i < recording.observers.size(); ++i) {
    const Vec3 eye = recording.observerEye(i, t);
    const int vehicle = recording.observers[i].vehicle;
    const bool gone = vehicle >= 0 && recording.vehicles[static_cast<std::size_t>(vehicle)].destroyedAt(t);
    out.push_back({{Kind::observer, recording.observers[i].id}, {eye.x, eye.z}, Symbol::observer, Side::friendly, gone, recording.observers[i].id});
  }
  return out;
}

bool isSelected(const MissionSession& mission, const Thing& thing) { return mission.document.selected() == thing.ref; }

void drawThings(const PanelContext& ui, const PlanView& view, const std::vector<Thing>& all) {
  const MissionSession& mission = ui.session.mission();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto draw = [&](const Thing& thing, bool chosen) {
    const ImVec2 at = view.pixel(thing.at);
    if (!view.inside(at, ui.px(10))) return;
    if (chosen) list.AddCircle(at, ui.px(11), ui.theme.accent, 24, ui.px(1.5f));
    drawSymbol(ui, thing.symbol, at, ui.px(thing.symbol == Symbol::gun ? 10 : 12), thing.destroyed ? ui.theme.dim : sideColour(ui, thing.side), thing.destroyed);
    ui.item("plan:" + thing.name, {at.x - ui.px(6), at.y - ui.px(6)}, {at.x + ui.px(6), at.y + ui.px(6)});
  };
  for (const Thing& thing : all)
    if (!isSelected(mission, thing)) draw(thing, false);
  for (const Thing& thing : all)
    if (isSelected(mission, thing)) {
      draw(thing, true);
      ImGui::PushFont(ui.fonts.small);
      const ImVec2 at = view.pixel(thing.at), size = ImGui::CalcTextSize(thing.name.c_str());
      const float x = std::clamp(at.x - 0.5f * size.x, view.box.at.x + ui.px(2), std::max(view.box.at.x + ui.px(2), view.box.right() - size.x - ui.px(2)));
      const float y = at.y - ui.px(14) - size.y < view.box.at.y ? at.y + ui.px(13) : at.y - ui.px(14) - size.y;
      list.AddRectFilled({x - ui.px(3), y - 1}, {x + size.x + ui.px(3), y + size.y + 1}, faded(ui.theme.background, 0.7f), ui.px(3));
      list.AddText({std::floor(x), std::floor(y)}, ui.theme.accent, thing.name.c_str());
      ImGui::PopFont();
    }
}

const Thing* thingUnder(const PanelContext& ui, const PlanView& view, const std::vector<Thing>& all) {
  const Thing* best = nullptr;
  float nearest = ui.px(11);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  for (const Thing& thing : all) {
    const ImVec2 at = view.pixel(thing.at);
    const float away = std::hypot(at.x - mouse.x, at.y - mouse.y);
    // What is already selected keeps the hand where several things lie on one another.
    if (away < nearest || (best != nullptr && away <= ui.px(11) && isSelected(ui.session.mission(), thing))) {
      nearest = std::min(nearest, away);
      best = &thing;
    }
  }
  return best;
}

void clicked(const PanelContext& ui, const Thing* thing, const Place& ground) {
  MissionSession& mission = ui.session.mission();
  if (useGroundClick(ui, ground, thing != nullptr && thing->ref.kind == Kind::vehicle ? thing->ref.id : std::string())) return;
  if (mission.ruler.active) {
    mission.ruler.pick({ground.x_m, mission.recording()->terrain.surface(ground.x_m, ground.z_m), ground.z_m});
    ui.state.mission.bottom = MissionUi::Bottom::ruler;
    return;
  }
  mission.document.select(thing != nullptr ? thing->ref : ObjectRef{});
}

void steer(const PanelContext& ui, const PlanView& view, const std::vector<Thing>& all) {
  MissionSession& mission = ui.session.mission();
  MissionUi& my = ui.state.mission;
  const ImGuiIO& io = ImGui::GetIO();
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  const bool left = held && ImGui::IsMouseDown(ImGuiMouseButton_Left), pressed = ImGui::IsItemActivated() && left;
  const Place ground = view.place(io.MousePos);
  const Thing* const thing = hovered || pressed ? thingUnder(ui, view, all) : nullptr;
  if (pressed && thing != nullptr && my.click == GroundClick::select && !mission.ruler.active) mission.document.select(thing->ref);
  if (pressed) my.pressed_at = io.MousePos;
  const bool draggable = thing != nullptr && my.click == GroundClick::select && !mission.ruler.active;
  const bool was_moving = my.drag.moving;
  dragObject(ui, pressed, draggable ? std::optional(thing->ref) : std::nullopt, ground, left);
  const bool still = std::hypot(io.MousePos.x - my.pressed_at.x, io.MousePos.y - my.pressed_at.y) < 4.0f * ui.scale;
  const bool shifting = held && !my.drag.pressed && !still;
  if (shifting) {
    my.turning = true;
    my.plan.centre_x -= static_cast<double>(io.MouseDelta.x) * my.plan.metre_per_px;
    my.plan.centre_z -= static_cast<double>(io.MouseDelta.y) * my.plan.metre_per_px;
  }
  if (ImGui::IsItemDeactivated() && hovered && still && !was_moving && !my.turning) clicked(ui, thing, ground);
  if (!held) my.turning = false;
  if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && thing != nullptr) mission.showSelected();
  if (!hovered || io.MouseWheel == 0.0f) return;
  const double before = my.plan.metre_per_px;
  my.plan.metre_per_px = std::clamp(before * std::pow(0.85, static_cast<double>(io.MouseWheel)), 0.05, 2000.0);
  const double share = 1.0 - my.plan.metre_per_px / before;
  my.plan.centre_x += share * (ground.x_m - my.plan.centre_x);
  my.plan.centre_z += share * (ground.z_m - my.plan.centre_z);
}

void drawScale(const PanelContext& ui, const PlanView& view) {
  // A bar of a round length, about a quarter of the width.
  const double wish = 0.28 * static_cast<double>(view.box.width) * view.metre_per_px, decade = std::pow(10.0, std::floor(std::log10(wish)));
  const double metres = decade * (wish >= 5.0 * decade ? 5.0 : wish >= 2.0 * decade ? 2.0 : 1.0);
  const float width = static_cast<float>(metres / view.metre_per_px);
  const ImVec2 at{view.box.at.x + ui.px(10), view.box.end().y - ui.px(10)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string text = metres >= 1000.0 ? shortNumber(metres / 1000.0) + " km" : shortNumber(metres) + " m";
  ImGui::PushFont(ui.fonts.small);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  list.AddRectFilled({at.x - ui.px(4), at.y - size.y - ui.px(6)}, {at.x + std::max(width, size.x) + ui.px(4), at.y + ui.px(5)}, faded(ui.theme.background, 0.7f), ui.px(3));
  list.AddText({at.x, at.y - size.y - ui.px(4)}, ui.theme.text, text.c_str());
  list.AddLine(at, {at.x + width, at.y}, ui.theme.text, ui.px(1.5f));
  for (const float x : {at.x, at.x + width}) list.AddLine({x, at.y - ui.px(3)}, {x, at.y + ui.px(3)}, ui.theme.text, ui.px(1.5f));
  ImGui::PopFont();
}

}  // namespace

void drawPlanPanel(const PanelContext& ui) {
  MissionSession& mission = ui.session.mission();
  MissionUi::Plan& plan = ui.state.mission.plan;
  const ImVec2 top = ImGui::GetCursorScreenPos();
  const float full = ImGui::GetContentRegionAvail().x;
  heading(ui, "Plan");
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({top.x + full - ui.px(24), top.y + ui.px(1)});
  if (iconButton(ui, Icon::frame, "frame plan", "Show everything in the plan", false, 24)) plan.placed = false;
  ImGui::SetCursorScreenPos({below.x, below.y + ui.px(4)});
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const Box box{ImGui::GetCursorScreenPos(), std::max(std::floor(room.x), 1.0f), std::max(std::floor(room.y - ui.px(4)), 1.0f)};
  ImGui::InvisibleButton("plan", ImVec2(box.width, box.height), ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  ui.item("plan");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(box.at, box.end(), ui.theme.background, ui.px(4));
  if (mission.recording() == nullptr) return;
  // Another simulation of the same mission keeps the part shown.
  if (!plan.placed || plan.mission != mission.missionNumber()) frameWorld(ui, box);
  PlanView view{box, plan.centre_x, plan.centre_z, plan.metre_per_px};
  const auto all = things(ui);
  steer(ui, view, all);
  ui.resting("plan", "Click selects, dragging a thing moves it, dragging the ground shifts, the wheel zooms.");
  view = {box, plan.centre_x, plan.centre_z, plan.metre_per_px};
  list.PushClipRect(box.at, box.end(), true);
  drawGround(ui, view);
  drawPlanLines(ui, view);
  drawThings(ui, view, all);
  drawScale(ui, view);
  list.PopClipRect();
}

}  // namespace npsee::editor
