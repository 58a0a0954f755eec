#include "editor/panels/actions.h"
#include "editor/panels/mission/panels.h"

#include <array>

namespace npsee::editor {
namespace {

using Ui = const PanelContext&;
using CameraKind = render::MissionCamera::Kind;
constexpr auto kMission = WorkMode::mission;

MissionSession& mission(Ui ui) { return ui.session.mission(); }
bool hasObject(Ui ui) { return mission(ui).document.selected().kind != ObjectRef::Kind::mission; }

template <CameraKind kind>
void look(Ui ui) {
  const int subject = kind == CameraKind::gun ? mission(ui).selectedGun() : kind == CameraKind::observer ? mission(ui).selectedObserver() : -1;
  mission(ui).look(kind, subject);
}
template <CameraKind kind>
bool looks(Ui ui) {
  return mission(ui).view.camera.kind == kind;
}
template <GroundClick click>
void place(Ui ui) {
  ui.state.mission.click = click;
}

const std::vector<MissionEvent>& events(Ui ui) {
  static const std::vector<MissionEvent> kNone;
  return mission(ui).recording() != nullptr ? mission(ui).recording()->events : kNone;
}

void flipRuler(Ui ui) {
  Ruler& ruler = mission(ui).ruler;
  ruler.active = !ruler.active;
  if (ruler.active) ui.state.mission.bottom = MissionUi::Bottom::ruler;
}

void cancel(Ui ui) {
  ui.state.mission.click = GroundClick::select;
  mission(ui).ruler.active = false;
}
bool canCancel(Ui ui) { return ui.state.mission.click != GroundClick::select || mission(ui).ruler.active; }

void flipTaken(Ui ui) {
  MissionSession& m = mission(ui);
  const ObjectRef ref = m.document.selected();
  ui.session.took(m.taken(ref.id) ? m.release(ref.id) : m.take(ref.id));
}
bool canTake(Ui ui) {
  const auto kind = mission(ui).document.selected().kind;
  return kind == ObjectRef::Kind::observer || kind == ObjectRef::Kind::vehicle;
}
bool isTaken(Ui ui) { return canTake(ui) && mission(ui).taken(mission(ui).document.selected().id); }

const std::array kActions{
    Action{"Camera", "Frame all", "F", [](Ui ui) { mission(ui).frameAll(); }, nullptr, nullptr, false, kMission},
    Action{"Camera", "Show the selected", "C", [](Ui ui) { mission(ui).showSelected(); }, hasObject, nullptr, false, kMission},
    Action{"Camera", "Free camera", "1", look<CameraKind::free>, nullptr, looks<CameraKind::free>, true, kMission},
    Action{"Camera", "Orbit camera", "2", look<CameraKind::orbit>, nullptr, looks<CameraKind::orbit>, false, kMission},
    Action{"Camera", "Follow the shell", "3", look<CameraKind::follow>, nullptr, looks<CameraKind::follow>, false, kMission},
    Action{"Camera", "At the gun", "4", look<CameraKind::gun>, nullptr, looks<CameraKind::gun>, false, kMission},
    Action{"Camera", "The observer's eye", "5", look<CameraKind::observer>, nullptr, looks<CameraKind::observer>, false, kMission},
    Action{"Camera", "Plan camera", "6", look<CameraKind::plan>, nullptr, looks<CameraKind::plan>, false, kMission},
    Action{"Mission", "Add observer", "", place<GroundClick::observer>, nullptr, nullptr, false, kMission},
    Action{"Mission", "Add gun", "", place<GroundClick::gun>, nullptr, nullptr, false, kMission},
    Action{"Mission", "Duplicate", "ctrl+D", [](Ui ui) { ui.session.took(mission(ui).document.duplicateSelected()); }, hasObject, nullptr, false, kMission},
    Action{"Mission", "Delete", "ctrl+Delete", [](Ui ui) { ui.session.took(mission(ui).document.removeSelected()); }, hasObject, nullptr, false, kMission},
    Action{"Mission", "Take over", "T", flipTaken, canTake, isTaken, true, kMission},
    Action{"View", "Ruler", "M", flipRuler, nullptr, [](Ui ui) { return mission(ui).ruler.active; }, true, kMission},
    Action{"Mission", "Cancel", "Escape", cancel, canCancel, nullptr, false, kMission},
    Action{"Time", "Play or pause", "Space", [](Ui ui) { mission(ui).clock.toggle(); }, nullptr, nullptr, false, kMission},
    Action{"Time", "Go to the start", "0", [](Ui ui) { mission(ui).clock.seek(0.0); }, nullptr, nullptr, false, kMission},
    Action{"Time", "Step back", "Comma", [](Ui ui) { mission(ui).clock.step(-1); }, nullptr, nullptr, false, kMission},
    Action{"Time", "Step on", "Period", [](Ui ui) { mission(ui).clock.step(1); }, nullptr, nullptr, false, kMission},
    Action{"Time", "Event before", "shift+Comma", [](Ui ui) { mission(ui).clock.seekEvent(-1, events(ui)); }, nullptr, nullptr, false, kMission},
    Action{"Time", "Next event", "shift+Period", [](Ui ui) { mission(ui).clock.seekEvent(1, events(ui)); }, nullptr, nullptr, false, kMission},
    Action{"Time", "Slower", "LeftBracket", [](Ui ui) { mission(ui).clock.changeSpeed(-1); }, nullptr, nullptr, false, kMission},
    Action{"Time", "Faster", "RightBracket", [](Ui ui) { mission(ui).clock.changeSpeed(1); }, nullptr, nullptr, false, kMission},
};

}  // namespace

std::span<const Action> missionActions() { return kActions; }

}  // namespace npsee::editor
