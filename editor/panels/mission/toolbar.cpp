#include "editor/panels/mission/panels.h"
#include "editor/ui/controls.h"

#include <array>
#include <string>

namespace npsee::editor {
namespace {

using CameraKind = render::MissionCamera::Kind;

struct CameraEntry {
  CameraKind kind;
  const char *name, *label, *tip;
};
constexpr std::array kCameras{
    CameraEntry{CameraKind::free, "free", "Free", "A camera of your own; arrows, Home and End move it (1)"},
    CameraEntry{CameraKind::orbit, "orbit", "Orbit", "Around a point of the ground (2)"},
    CameraEntry{CameraKind::follow, "follow", "Shell", "Follows the shell fired last, or the one clicked (3)"},
    CameraEntry{CameraKind::gun, "gun", "Gun", "At the selected gun (4)"},
    CameraEntry{CameraKind::observer, "observer", "Observer", "Through the observer's binoculars, with a reticle in mils (5)"},
    CameraEntry{CameraKind::plan, "plan", "Plan", "From straight above (6)"},
};

struct OverlayEntry {
  bool render::MissionOverlays::*flag;
  const char *name, *label, *tip;
};
constexpr std::array kOverlays{
    OverlayEntry{&render::MissionOverlays::trails, "trails", "Trails", "Paths of the shells in the air"},
    OverlayEntry{&render::MissionOverlays::drop_lines, "drop lines", "Drops", "Lines from the shells' paths down to the ground"},
    OverlayEntry{&render::MissionOverlays::trajectories, "trajectories", "Flights", "The whole flight of every shell in the air"},
    OverlayEntry{&render::MissionOverlays::fire_lines, "fire lines", "Fire", "Lines of fire from gun to burst"},
    OverlayEntry{&render::MissionOverlays::range_rings, "range rings", "Rings", "Reach of the guns"},
    OverlayEntry{&render::MissionOverlays::sight_fan, "sight fan", "Sight", "What the selected observer can see, by how far sight clears the ground"},
    OverlayEntry{&render::MissionOverlays::beliefs, "beliefs", "Beliefs", "Where observers believe their targets to be, joined with where they are"},
    OverlayEntry{&render::MissionOverlays::contours, "contours", "Contours", "Height lines and the kilometre grid"},
    OverlayEntry{&render::MissionOverlays::scorch, "scorch", "Scorch", "Burnt ground where shells burst"},
    OverlayEntry{&render::MissionOverlays::icons, "icons", "Marks", "A mark over every vehicle, gun and observer"},
};

void chooseCamera(const PanelContext& ui, CameraKind kind) {
  MissionSession& mission = ui.session.mission();
  const int subject = kind == CameraKind::gun ? mission.selectedGun() : kind == CameraKind::observer ? mission.selectedObserver() : -1;
  mission.look(kind, subject);
}

/// Toggles, each by name and word.
template <class Draw>
void eachToggle(const PanelContext& ui, const Draw& draw) {
  MissionSession& mission = ui.session.mission();
  for (const OverlayEntry& entry : kOverlays)
    draw(entry.label, entry.name, mission.view.overlays.*entry.flag, entry.tip, [&] { mission.view.overlays.*entry.flag = !(mission.view.overlays.*entry.flag); });
  draw("My burst", "my burst", mission.own_burst, "Bursts show the preset that is open in the explosion mode, as it is edited", [&] { mission.own_burst = !mission.own_burst; });
  draw("Names", "labels", ui.state.mission.labels, "Names of what is seen", [&] { ui.state.mission.labels = !ui.state.mission.labels; });
}

void drawShowMenu(const PanelContext& ui) {
  const bool clicked = chip(ui, "Show", "overlays", ImGui::IsPopupOpen("overlays"), "What is drawn over the ground");
  ui.item("button:show");
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  if (clicked) ImGui::OpenPopup("overlays");
  dropDown(ui, "overlays", min, max, [&] {
    eachToggle(ui, [&](const char* label, const char* name, bool on, const char* tip, const auto& flip) {
      if (checkEntry(label, on)) flip();
      const std::string full = std::string("toggle:") + name;
      ui.item(full);
      ui.resting(full, tip);
    });
  });
}

}  // namespace

void drawMissionToolbar(const PanelContext& ui) {
  MissionSession& mission = ui.session.mission();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(32);
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + width, at.y + height}, ui.theme.panel);
  mission.view.overlays.observer = mission.selectedObserver();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(2), 0));
  ImGui::SetCursorScreenPos({at.x + ui.px(8), at.y + ui.px(5)});
  for (const CameraEntry& entry : kCameras) {
    if (chip(ui, entry.label, std::string("camera ") + entry.name, mission.view.camera.kind == entry.kind, entry.tip)) chooseCamera(ui, entry.kind);
    ImGui::SameLine();
  }
  float needed = 0.0f;
  eachToggle(ui, [&](const char* label, auto&&...) { needed += chipWidth(ui, label) + ui.px(2); });
  const float ruler = chipWidth(ui, "Ruler") + ui.px(12), left = ImGui::GetCursorScreenPos().x + ui.px(10);
  const bool fits = left + needed + ruler < at.x + width;
  ImGui::SetCursorScreenPos({fits ? at.x + width - needed - ruler : at.x + width - ruler - chipWidth(ui, "Show") - ui.px(2), at.y + ui.px(5)});
  if (fits) {
    eachToggle(ui, [&](const char* label, const char* name, bool on, const char* tip, const auto& flip) {
      if (chip(ui, label, name, on, tip)) flip();
      ImGui::SameLine();
    });
  } else {
    drawShowMenu(ui);
  }
  ImGui::SetCursorScreenPos({at.x + width - ruler, at.y + ui.px(5)});
  if (chip(ui, "Ruler", "ruler", mission.ruler.active, "Distance, azimuth and sight between two points (M)")) {
    mission.ruler.active = !mission.ruler.active;
    if (mission.ruler.active) ui.state.mission.bottom = MissionUi::Bottom::ruler;
  }
  ImGui::PopStyleVar();
  ImGui::SetCursorScreenPos({at.x, at.y + height});
}

}  // namespace npsee::editor
