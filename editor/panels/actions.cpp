#include "editor/panels/actions.h"

#include "editor/document/camera_moves.h"
#include "editor/panels/design_actions.h"
#include "editor/panels/desk/view_tools.h"
#include "editor/panels/mission/panels.h"
#include "editor/panels/panels.h"
#include "editor/script/parser.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace npsee::editor {
namespace {

using Ui = const PanelContext&;

bool hasLayer(Ui ui) { return ui.session.document.hasLayer(); }
bool canUndo(Ui ui) { return ui.session.file().canUndo(); }
bool canRedo(Ui ui) { return ui.session.file().canRedo(); }

template <render::TemplateView view>
void showView(Ui ui) {
  ui.session.template_view = view;
}
template <render::TemplateView view>
bool showsView(Ui ui) {
  return ui.session.template_view == view;
}

using enum render::TemplateView;
using Mode = FilePanel::Mode;
constexpr auto kExplosion = WorkMode::explosion;

void changeMode(Ui ui) {
  ui.session.setMode(ui.session.inMission() ? WorkMode::explosion : WorkMode::mission);
}

const std::array kCommon{
    Action{"File", "New", "ctrl+N", [](Ui ui) { ui.session.startNew(); }},
    Action{"File", "Open", "ctrl+O", [](Ui ui) { ui.session.showFiles(Mode::open); }},
    Action{"File", "Save", "ctrl+S", [](Ui ui) { ui.session.save(); }, nullptr, nullptr, true},
    Action{"File", "Save as", "ctrl+shift+S", [](Ui ui) { ui.session.showFiles(Mode::save_as); }},
    Action{"File", "Quit", "ctrl+Q", [](Ui ui) { ui.session.quit(); }, nullptr, nullptr, true},
    Action{"Edit", "Undo", "ctrl+Z", [](Ui ui) { ui.session.undo(); }, canUndo},
    Action{"Edit", "Redo", "ctrl+shift+Z", [](Ui ui) { ui.session.redo(); }, canRedo},
    Action{"Camera", "Frame all", "F", [](Ui ui) { ui.session.frameAll(); }, nullptr, nullptr, false, kExplosion},
    Action{"Camera", "From the front", "1", [](Ui ui) { lookAlong(ui, "front"); }, nullptr, nullptr, false, kExplosion},
    Action{"Camera", "From the side", "2", [](Ui ui) { lookAlong(ui, "side"); }, nullptr, nullptr, false, kExplosion},
    Action{"Camera", "From above", "3", [](Ui ui) { lookAlong(ui, "top"); }, nullptr, nullptr, false, kExplosion},
    Action{"View", "Template as splines", "", showView<splines>, nullptr, showsView<splines>, true, kExplosion},
    Action{"View", "Template as polygons", "", showView<polygons>, nullptr, showsView<polygons>, false, kExplosion},
    Action{"View", "Template as surface", "", showView<surface>, nullptr, showsView<surface>, false, kExplosion},
    Action{"View", "Left panels", "F2", [](Ui ui) { ui.state.show_left = !ui.state.show_left; }, nullptr, [](Ui ui) { return ui.state.show_left; }, true},
    Action{"View", "Right panels", "F5", [](Ui ui) { ui.state.show_right = !ui.state.show_right; }, nullptr, [](Ui ui) { return ui.state.show_right; }},
    Action{"View", "Light theme", "", [](Ui ui) { ui.state.light = !ui.state.light; }, nullptr, [](Ui ui) { return ui.state.light; }},
    Action{"Layer", "Add layer", "ctrl+shift+N", [](Ui ui) { ui.session.took(ui.session.document.addLayer()); }, nullptr, nullptr, false, kExplosion},
    Action{"Layer", "Duplicate layer", "ctrl+D", [](Ui ui) { ui.session.took(ui.session.document.duplicateLayer()); }, hasLayer, nullptr, false, kExplosion},
    Action{"Layer", "Rename layer", "", [](Ui ui) { ui.state.rename_layer = true; }, hasLayer, nullptr, false, kExplosion},
    Action{"Layer", "Move layer up", "alt+Up", [](Ui ui) { ui.session.took(ui.session.document.moveLayer(-1)); }, hasLayer, nullptr, false, kExplosion},
    Action{"Layer", "Move layer down", "alt+Down", [](Ui ui) { ui.session.took(ui.session.document.moveLayer(1)); }, hasLayer, nullptr, false, kExplosion},
    Action{"Layer", "Delete layer", "ctrl+Delete", [](Ui ui) { ui.session.took(ui.session.document.deleteLayer()); }, hasLayer, nullptr, true, kExplosion},
    Action{"Time", "Play or pause", "Space", [](Ui ui) { ui.session.playback.toggle(); }, nullptr, nullptr, false, kExplosion},
    Action{"Time", "Go to the burst", "0", [](Ui ui) { ui.session.playback.seek(0.0); }, nullptr, nullptr, false, kExplosion},
    Action{"Time", "Step back", "Comma", [](Ui ui) { ui.session.playback.step(-1); }, nullptr, nullptr, false, kExplosion},
    Action{"Time", "Step on", "Period", [](Ui ui) { ui.session.playback.step(1); }, nullptr, nullptr, false, kExplosion},
    Action{"Time", "Slower", "LeftBracket", [](Ui ui) { ui.session.playback.changeSpeed(-1); }, nullptr, nullptr, false, kExplosion},
    Action{"Time", "Faster", "RightBracket", [](Ui ui) { ui.session.playback.changeSpeed(1); }, nullptr, nullptr, false, kExplosion},
    Action{"Time", "Loop", "L", [](Ui ui) { ui.session.playback.loop = !ui.session.playback.loop; }, nullptr, [](Ui ui) { return ui.session.playback.loop; }, false, kExplosion},
    Action{"View", "Mission mode", "F6", changeMode, nullptr, [](Ui ui) { return ui.session.inMission(); }},
    Action{"Help", "Keys and mouse", "F1", [](Ui ui) { ui.state.show_help = !ui.state.show_help; }, nullptr, [](Ui ui) { return ui.state.show_help; }},
};

/// The common actions, then those of designing and of the mission mode.
const std::vector<Action>& allActions() {
  static const std::vector<Action> kAll = [] {
    std::vector<Action> out(kCommon.begin(), kCommon.end());
    const auto design = designActions(), desk = deskActions(), mission = missionActions();
    out.insert(out.end(), design.begin(), design.end());
    out.insert(out.end(), desk.begin(), desk.end());
    out.insert(out.end(), mission.begin(), mission.end());
    return out;
  }();
  return kAll;
}

constexpr int number(CameraKey key) { return static_cast<int>(key); }

// Left is x+ and right x- in the thesis: the picture, not the viewpoint, follows the arrow.
constexpr std::array kCameraKeys{
    CameraKeyInfo{"Up", "viewpoint z-", number(CameraKey::viewpoint_z_minus)},
    CameraKeyInfo{"Down", "viewpoint z+", number(CameraKey::viewpoint_z_plus)},
    CameraKeyInfo{"Left", "viewpoint x+", number(CameraKey::viewpoint_x_plus)},
    CameraKeyInfo{"Right", "viewpoint x-", number(CameraKey::viewpoint_x_minus)},
    CameraKeyInfo{"Home", "viewpoint y+", number(CameraKey::viewpoint_y_plus)},
    CameraKeyInfo{"End", "viewpoint y-", number(CameraKey::viewpoint_y_minus)},
    CameraKeyInfo{"KP8", "reference point y+", number(CameraKey::reference_y_plus)},
    CameraKeyInfo{"KP2", "reference point y-", number(CameraKey::reference_y_minus)},
    CameraKeyInfo{"KP4", "reference point x-", number(CameraKey::reference_x_minus)},
    CameraKeyInfo{"KP6", "reference point x+", number(CameraKey::reference_x_plus)},
};

/// What the tables' shortcuts mean, read once.
struct Strokes {
  std::vector<std::optional<KeyStroke>> actions, camera;
  std::vector<std::string> texts;  ///< of the actions'
};
const Strokes& strokes() {
  static const Strokes kStrokes = [] {
    Strokes out;
    const auto read = [](std::string_view text) { return text.empty() ? std::nullopt : std::optional(parseKeyStroke(text).value()); };
    for (const Action& action : allActions()) out.actions.push_back(read(action.shortcut));
    for (const auto& stroke : out.actions) out.texts.push_back(stroke ? keyText(*stroke) : std::string());
    for (const CameraKeyInfo& info : kCameraKeys) out.camera.push_back(read(info.key));
    return out;
  }();
  return kStrokes;
}

bool pressed(const std::optional<KeyStroke>& wanted, bool repeat) {
  if (!wanted) return false;
  const KeyStroke& stroke = *wanted;
  const ImGuiIO& io = ImGui::GetIO();
  return io.KeyCtrl == stroke.ctrl && io.KeyShift == stroke.shift && io.KeyAlt == stroke.alt && ImGui::IsKeyPressed(stroke.code, repeat);
}

}  // namespace

std::span<const Action> actions() { return allActions(); }
const std::string& shortcutText(const Action& action) { return strokes().texts[static_cast<std::size_t>(&action - allActions().data())]; }
std::span<const CameraKeyInfo> cameraKeys() { return kCameraKeys; }

void handleKeys(const PanelContext& ui) {
  const bool typing = ImGui::GetIO().WantTextInput;
  // ImGui closes menus on Escape only in its keyboard navigation, whose arrow keys belong to the camera here.
  if (!typing && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false) && ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) ImGui::ClosePopupToLevel(0, true);
  for (std::size_t i = 0; i < allActions().size(); ++i) {
    const Action& action = allActions()[i];
    if (!action.here(ui)) continue;
    if (action.enabled != nullptr && !action.enabled(ui)) continue;
    // A text field keeps its own keys; files can be saved and the editor left from within it.
    if (typing && (action.menu != "File" || !strokes().actions[i] || !strokes().actions[i]->ctrl)) continue;
    if (pressed(strokes().actions[i], action.label.starts_with("Step"))) action.run(ui);
  }
  if (ui.session.inMission()) return handleMissionKeys(ui);
  for (std::size_t i = 0; i < kCameraKeys.size() && !typing; ++i)
    if (pressed(strokes().camera[i], true)) ui.session.camera = moved(ui.session.camera, static_cast<CameraKey>(kCameraKeys[i].move), keyStep_m(ui.session.radius_m()));
}

}  // namespace npsee::editor
