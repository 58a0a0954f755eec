#include "editor/document/camera_moves.h"
#include "editor/panels/desk/view_tools.h"
#include "editor/panels/mission/panels.h"
#include "editor/ui/controls.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee::editor {
namespace {

using CameraKind = render::MissionCamera::Kind;
using MarkKind = render::MissionMark::Kind;

constexpr double kTurn_radpp = 0.006;  ///< orbit, rad per unscaled pixel
constexpr double kSteepest_rad = 1.5533430342749532;

/// The mission's camera as the explosion's moves understand it.
render::Camera freeCamera(const render::MissionCamera& camera) { return {camera.eye, camera.target, camera.fov_y_rad}; }
void setFree(render::MissionCamera& camera, const render::Camera& to) {
  camera.eye = to.eye;
  camera.target = to.target;
}

void turn(render::MissionCamera& camera, double dx, double dy) {
  if (camera.kind == CameraKind::observer) {
    // In the glass the picture follows the hand: the whole circle is a hand's breadth.
    const double per_pixel = (camera.binoculars ? camera.field_mil * kTwoPi / 6400.0 : camera.fov_y_rad) / 700.0;
    camera.turn_rad -= per_pixel * dx;
    camera.raise_rad = std::clamp(camera.raise_rad + per_pixel * dy, -0.6, 0.6);
    return;
  }
  if (camera.kind == CameraKind::free) {
    // The viewpoint stays; what is looked at turns around it.
    const render::Camera now = freeCamera(camera);
    const render::Camera turned = orbited({now.target, now.eye, now.fov_y_rad}, -kTurn_radpp * 0.5 * dx, -kTurn_radpp * 0.5 * dy);
    camera.target = turned.eye;
    return;
  }
  camera.yaw_rad += kTurn_radpp * dx;
  camera.pitch_rad = std::clamp(camera.pitch_rad + kTurn_radpp * dy, camera.kind == CameraKind::orbit ? 0.01 : -0.4, kSteepest_rad);
}

void pan(const PanelContext& ui, const Box& box, double dx, double dy) {
  render::MissionCamera& camera = ui.session.mission().view.camera;
  const double share_x = dx / static_cast<double>(box.height), share_y = dy / static_cast<double>(box.height);
  if (camera.kind == CameraKind::plan) {
    camera.target.x -= share_x * camera.span_m;
    camera.target.z -= share_y * camera.span_m;
  } else if (camera.kind == CameraKind::orbit) {
    const double metres = 2.0 * camera.distance_m * std::tan(0.5 * camera.fov_y_rad);
    // Along the ground: right of the view and away from the eye.
    const double sine = std::sin(camera.yaw_rad), cosine = std::cos(camera.yaw_rad);
    const double right = -share_x * metres, away = share_y * metres / std::max(std::sin(camera.pitch_rad), 0.25);
    camera.target.x += right * cosine + away * sine;
    camera.target.z += right * sine - away * cosine;
    if (const Recording* recording = ui.session.mission().recording()) camera.target.y = recording->terrain.surface(camera.target.x, camera.target.z);
  } else if (camera.kind == CameraKind::free) {
    setFree(camera, panned(freeCamera(camera), share_x, share_y));
  } else {
    turn(camera, dx / static_cast<double>(ui.scale), dy / static_cast<double>(ui.scale));
  }
}

void zoom(const PanelContext& ui, const Box& box, double steps, const std::optional<Vec3>& ground) {
  render::MissionCamera& camera = ui.session.mission().view.camera;
  const double factor = std::pow(0.86, steps);
  const auto towards = [&](double share) {
    // The place under the pointer stays there.
    if (!ground) return;
    camera.target.x += share * (ground->x - camera.target.x);
    camera.target.z += share * (ground->z - camera.target.z);
  };
  switch (camera.kind) {
    case CameraKind::plan: {
      const double before = camera.span_m;
      camera.span_m = std::clamp(before * factor, 50.0, 400000.0);
      towards(1.0 - camera.span_m / before);
      return;
    }
    case CameraKind::orbit: {
      const double before = camera.distance_m;
      camera.distance_m = std::clamp(before * factor, 5.0, 300000.0);
      towards(1.0 - camera.distance_m / before);
      return;
    }
    case CameraKind::observer:
      if (camera.binoculars) camera.field_mil = std::clamp(camera.field_mil * factor, 10.0, 600.0);
      else camera.fov_y_rad = std::clamp(camera.fov_y_rad * factor, 0.05, 1.6);
      return;
    case CameraKind::free: {
      const double half = 0.5 * static_cast<double>(box.height);
      const ImVec2 mouse = ImGui::GetIO().MousePos;
      const double x = (static_cast<double>(mouse.x - box.at.x) - 0.5 * static_cast<double>(box.width)) / half;
      setFree(camera, dollied(freeCamera(camera), factor, x, 1.0 - static_cast<double>(mouse.y - box.at.y) / half));
      return;
    }
    case CameraKind::follow:
    case CameraKind::gun: camera.distance_m = std::clamp(camera.distance_m * factor, 2.0, 20000.0); return;
  }
}

/// What lies nearest under the pointer.
const render::MissionMark* markUnder(const PanelContext& ui, const Box& box) {
  const render::MissionMark* best = nullptr;
  double nearest = 1e9;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  for (const render::MissionMark& mark : ui.pictures.marks(ui.session.mission(), static_cast<int>(box.width), static_cast<int>(box.height))) {
    if (mark.kind == MarkKind::burst || mark.kind == MarkKind::belief) continue;
    const double away = std::hypot(mark.x - static_cast<double>(mouse.x - box.at.x), mark.y - static_cast<double>(mouse.y - box.at.y));
    if (away > std::max(0.6 * mark.size_px, static_cast<double>(ui.px(13))) || away >= nearest) continue;
    nearest = away;
    best = &mark;
  }
  return best;
}

std::optional<ObjectRef> refOf(const MissionSession& mission, const render::MissionMark* mark) {
  if (mark == nullptr || mission.recording() == nullptr || mark->index < 0) return std::nullopt;
  const Recording& recording = *mission.recording();
  const auto index = static_cast<std::size_t>(mark->index);
  if (mark->kind == MarkKind::gun && index < recording.guns.size()) return ObjectRef{ObjectRef::Kind::gun, recording.guns[index].id};
  if (mark->kind == MarkKind::observer && index < recording.observers.size()) return ObjectRef{ObjectRef::Kind::observer, recording.observers[index].id};
  if (mark->kind == MarkKind::vehicle && index < recording.vehicles.size()) return mission.owner(mark->index);
  return std::nullopt;
}

/// In the observer's eye a click on a burst measures how far it is off the line, in mils.
bool measured(const PanelContext& ui, const Vec3& ray) {
  MissionSession& mission = ui.session.mission();
  const ObjectRef& selected = mission.document.selected();
  if (mission.view.camera.kind != CameraKind::observer || selected.kind != ObjectRef::Kind::observer || !mission.taken(selected.id)) return false;
  const auto right = mission.measure(selected.id, ray);
  if (!right) return false;
  const int newest = openMissions(*mission.recording(), selected.id, mission.clock.time_s).back().number;
  ui.session.notices.note = std::to_string(std::lround(std::abs(*right))) + (*right < 0.0 ? " mil left" : " mil right") + " of the target: " + correctionText(mission.corrections[newest].right_m, 0.0) + ".";
  return true;
}

void clicked(const PanelContext& ui, const render::MissionMark* mark, const std::optional<Vec3>& ground, const Vec3& ray) {
  MissionSession& mission = ui.session.mission();
  if (ground && ui.state.mission.click != GroundClick::select) {
    const bool vehicle = mark != nullptr && mark->kind == MarkKind::vehicle;
    useGroundClick(ui, {ground->x, ground->z}, vehicle ? mission.recording()->vehicles[static_cast<std::size_t>(mark->index)].id : std::string());
    return;
  }
  if (mission.ruler.active && ground) {
    mission.ruler.pick(*ground);
    ui.state.mission.bottom = MissionUi::Bottom::ruler;
    return;
  }
  if (mark != nullptr && mark->kind == MarkKind::shell) return mission.look(CameraKind::follow, mark->index);
  const auto ref = refOf(mission, mark);
  if (!ref && measured(ui, ray)) return;
  // Who looks through the glass keeps looking when he clicks beside things.
  if (!ref && mission.view.camera.kind == CameraKind::observer) return;
  mission.document.select(ref.value_or(ObjectRef{}));
}

void steer(const PanelContext& ui, const Box& box) {
  MissionSession& mission = ui.session.mission();
  render::MissionCamera& camera = mission.view.camera;
  const ImGuiIO& io = ImGui::GetIO();
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  const Recording* recording = mission.recording();
  if (recording == nullptr || (!hovered && !held)) return;
  const render::MissionEye eye = render::missionEye(*recording, mission.clock.time_s, camera, static_cast<int>(box.width), static_cast<int>(box.height));
  const auto ground = eye.groundAt(recording->terrain, static_cast<double>(io.MousePos.x - box.at.x), static_cast<double>(io.MousePos.y - box.at.y));
  const bool pressed = ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const render::MissionMark* mark = pressed || ImGui::IsItemDeactivated() || hovered ? markUnder(ui, box) : nullptr;
  // Only what is selected is moved by dragging it here; everything else turns the view.
  auto under = pressed ? refOf(mission, mark) : std::nullopt;
  if (under && *under != mission.document.selected()) under.reset();
  const bool left = held && ImGui::IsMouseDown(ImGuiMouseButton_Left), middle = held && ImGui::IsMouseDown(ImGuiMouseButton_Middle);
  MissionUi::Drag& drag = ui.state.mission.drag;
  const bool was_moving = drag.moving;
  const bool moving = dragObject(ui, pressed, under, ground ? std::optional(Place{ground->x, ground->z}) : std::nullopt, left);
  if (pressed) ui.state.mission.pressed_at = io.MousePos;
  const ImVec2 way{io.MousePos.x - ui.state.mission.pressed_at.x, io.MousePos.y - ui.state.mission.pressed_at.y};
  const bool still = std::hypot(way.x, way.y) < 4.0f * ui.scale;
  if (left && !moving && !drag.pressed && !still) {
    const ImVec2 step = ui.state.mission.turning ? io.MouseDelta : way;
    ui.state.mission.turning = true;
    if (camera.kind == CameraKind::plan) pan(ui, box, static_cast<double>(step.x), static_cast<double>(step.y));
    else turn(camera, static_cast<double>(step.x / ui.scale), static_cast<double>(step.y / ui.scale));
  }
  if (middle) pan(ui, box, static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y));
  if (ImGui::IsItemDeactivated() && hovered && still && !was_moving && !ui.state.mission.turning) clicked(ui, mark, ground, eye.rayThrough(static_cast<double>(io.MousePos.x - box.at.x), static_cast<double>(io.MousePos.y - box.at.y)));
  if (!held) ui.state.mission.turning = false;
  if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && mark != nullptr) mission.showSelected();
  if (hovered && io.MouseWheel != 0.0f) zoom(ui, box, static_cast<double>(io.MouseWheel), ground);
}

void drawPlate(const PanelContext& ui, const ImVec2& at, const std::string& text, ImU32 colour) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(ui.fonts.small);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  list.AddRectFilled({at.x - ui.px(8), at.y - ui.px(4)}, {at.x + size.x + ui.px(8), at.y + size.y + ui.px(4)}, faded(ui.theme.background, 0.82f), ui.px(4));
  list.AddText(at, colour, text.c_str());
  ImGui::PopFont();
}

/// The ruler's line over the picture.
void drawRuler(const PanelContext& ui, const Box& box) {
  const MissionSession& mission = ui.session.mission();
  const Ruler& ruler = mission.ruler;
  if (ruler.points == 0 || mission.recording() == nullptr) return;
  const render::MissionEye eye = render::missionEye(*mission.recording(), mission.clock.time_s, mission.view.camera, static_cast<int>(box.width), static_cast<int>(box.height));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto pixel = [&](const Vec3& p) -> std::optional<ImVec2> {
    const auto at = eye.project(p);
    if (!at) return std::nullopt;
    return ImVec2(box.at.x + static_cast<float>(at->x), box.at.y + static_cast<float>(at->y));
  };
  const auto a = pixel(ruler.from), b = pixel(ruler.to);
  if (a && b && ruler.complete()) list.AddLine(*a, *b, ui.theme.accent, ui.px(1.5f));
  for (const auto& end : {a, b})
    if (end) list.AddCircleFilled(*end, ui.px(4), ui.theme.accent, 16);
}

std::string hint(const PanelContext& ui) {
  const MissionSession& mission = ui.session.mission();
  if (std::string click = groundClickHint(ui); !click.empty()) return click;
  const Recording& recording = *mission.recording();
  const CameraKind camera = mission.view.camera.kind;
  if (camera == CameraKind::observer && recording.observers.empty()) return "There is no observer to look through. The plus above the list of objects adds one.";
  if (camera == CameraKind::gun && recording.guns.empty()) return "There is no gun to stand at. The plus above the list of objects adds one.";
  if (camera == CameraKind::follow && recording.shells.empty()) return "No shell was fired that could be followed.";
  return mission.live() ? "You are in the loop: the mission is simulated as it is played." : std::string();
}

void drawOver(const PanelContext& ui, const Box& box) {
  const MissionSession& mission = ui.session.mission();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(box.at, box.end(), true);
  if (ui.state.mission.labels) drawLabels(ui, box);
  drawRuler(ui, box);
  drawPlate(ui, {box.at.x + ui.px(18), box.at.y + ui.px(14)}, momentText(mission.clock.time_s), ui.theme.text);
  if (const std::string text = hint(ui); !text.empty()) drawPlate(ui, {box.at.x + ui.px(18), box.at.y + ui.px(40)}, text, ui.theme.accent);
  // A thin bar tells how far the simulation has come; the last good picture stays.
  if (mission.simulating() && !mission.live()) list.AddRectFilled(box.at, {box.at.x + static_cast<float>(mission.progress()) * box.width, box.at.y + ui.px(2)}, ui.theme.accent);
  list.PopClipRect();
}

void drawNothing(const PanelContext& ui, const Box& box) {
  const MissionSession& mission = ui.session.mission();
  const char* words = mission.simulating() ? "Simulating the mission" : "There is no mission to show";
  const ImVec2 size = ImGui::CalcTextSize(words);
  ImGui::GetWindowDrawList()->AddText({std::floor(box.at.x + 0.5f * (box.width - size.x)), std::floor(box.at.y + 0.5f * (box.height - size.y))}, ui.theme.dim, words);
}

}  // namespace

void drawMissionViewport(const PanelContext& ui) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const Box box{ImGui::GetCursorScreenPos(), std::max(std::floor(room.x), 1.0f), std::max(std::floor(room.y), 1.0f)};
  MissionSession& mission = ui.session.mission();
  mission.setAspect(static_cast<double>(box.width / box.height));
  ImGui::InvisibleButton("viewport", ImVec2(box.width, box.height), ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  ui.item("viewport");
  steer(ui, box);
  ui.resting("viewport", "Click selects, left drag turns, middle drag shifts, the wheel moves nearer; dragging the selected thing moves it.");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (mission.recording() == nullptr) {
    list.AddRectFilled(box.at, box.end(), ui.theme.background);
    return drawNothing(ui, box);
  }
  if (const ImTextureID texture = ui.pictures.mission(mission, drawnPixels(ui, box.width), drawnPixels(ui, box.height))) list.AddImage(texture, box.at, box.end(), {0, 1}, {1, 0});
  else list.AddRectFilled(box.at, box.end(), ui.theme.background);
  drawOver(ui, box);
}

}  // namespace npsee::editor
