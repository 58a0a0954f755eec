// What scripts can ask for by name.

#include "editor/document/statistics.h"
#include "editor/editor.h"
#include "editor/mission/session.h"

#include <npsee/units.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace npsee::editor {
namespace {

using Facts = std::vector<std::pair<std::string, std::string>>;

std::string yes(bool b) { return b ? "yes" : "no"; }

void addExplosion(const Session& session, Facts& out) {
  const Document& document = session.document;
  const render::Camera& camera = session.camera;
  const FrameFigures figures = figuresOf(session.frame(), session.explosion() != nullptr ? session.explosion()->layers() : std::span<const LayerSpan>());
  constexpr const char* kComparing[] = {"off", "split", "flip"};
  constexpr const char* kViews[] = {"splines", "polygons", "surface"};
  out.insert(out.end(), {
      {"eye.x", shortest(camera.eye.x)}, {"eye.y", shortest(camera.eye.y)}, {"eye.z", shortest(camera.eye.z)},
      {"target.x", shortest(camera.target.x)}, {"target.y", shortest(camera.target.y)}, {"target.z", shortest(camera.target.z)},
      {"distance", shortest(length(camera.eye - camera.target))},
      {"time", shortest(session.playback.time_s)}, {"duration", shortest(session.playback.duration_s)},
      {"playing", yes(session.playback.playing)}, {"loop", yes(session.playback.loop)}, {"speed", shortest(session.playback.speed)},
      {"alive", std::to_string(session.alive())},
      {"particles", std::to_string(session.explosion() != nullptr ? session.explosion()->particleCount() : 0)},
      {"layers", std::to_string(document.preset().layers.size())}, {"layer", document.hasLayer() ? document.layer().name : std::string()},
      {"undo", std::to_string(document.history().undoSteps())}, {"redo", std::to_string(document.history().redoSteps())},
      {"undo.label", std::string(document.history().undoLabel())},
      {"loop.from", shortest(session.playback.from_s)}, {"loop.to", shortest(session.playback.to_s)},
      {"mark.contact", session.design.moments.first_contact_s ? shortest(*session.design.moments.first_contact_s) : ""},
      {"mark.death", session.design.moments.last_death_s ? shortest(*session.design.moments.last_death_s) : ""},
      {"fastest", shortest(figures.fastest_mps)}, {"energy", shortest(figures.energy_Jpkg)}, {"energy.joules", shortest(figures.energy_J)},
      {"compare", kComparing[static_cast<int>(session.compare.mode)]}, {"compare.name", session.compare.name}, {"compare.split", shortest(session.compare.split)},
      {"compare.flipped", yes(session.compare.flipped)}, {"compare.alive", std::to_string(figuresOf(session.compare.frame).alive)},
      {"variations", yes(session.variations.open)},
      {"locked", std::to_string(session.design.locked.size())}, {"vary.amount", shortest(session.design.amount)}, {"solo", std::to_string(session.design.solo.size())},
      {"template.view", kViews[static_cast<int>(session.template_view)]},
      {"template.yaw", shortest(session.template_yaw_rad)}, {"template.pitch", shortest(session.template_pitch_rad)},
  });
}

void addMissionCamera(const render::MissionCamera& camera, Facts& out) {
  constexpr std::array kKinds{"free", "orbit", "follow", "gun", "observer", "plan"};
  out.insert(out.end(), {
      {"camera", kKinds[static_cast<std::size_t>(camera.kind)]}, {"camera.subject", std::to_string(camera.subject)},
      {"eye.x", shortest(camera.eye.x)}, {"eye.y", shortest(camera.eye.y)}, {"eye.z", shortest(camera.eye.z)},
      {"target.x", shortest(camera.target.x)}, {"target.y", shortest(camera.target.y)}, {"target.z", shortest(camera.target.z)},
      {"distance", shortest(camera.distance_m)}, {"yaw", shortest(camera.yaw_rad)}, {"pitch", shortest(camera.pitch_rad)}, {"field", shortest(camera.field_mil)}, {"span", shortest(camera.span_m)},
  });
}

void addMission(const MissionSession& mission, const UiState& state, Facts& out) {
  const MissionDocument& document = mission.document;
  addMissionCamera(mission.view.camera, out);
  const Recording* recording = mission.recording();
  const std::size_t events = recording != nullptr ? recording->events.size() : 0;
  const auto last = mission.lastEvent();
  out.insert(out.end(), {
      {"time", shortest(mission.clock.time_s)}, {"duration", shortest(mission.clock.duration_s)}, {"playing", yes(mission.clock.playing)}, {"speed", shortest(mission.clock.speed)},
      {"simulated", shortest(recording != nullptr ? recording->duration_s : 0.0)}, {"finished", yes(recording != nullptr && recording->finished)}, {"hash", recording != nullptr ? recording->hash : ""},
      {"live", yes(mission.live())}, {"commands", std::to_string(document.commands()->size())},
      {"events", std::to_string(events)}, {"events.listed", std::to_string(state.mission.events.shown.size())}, {"shots", std::to_string(mission.shots().size())},
      {"event", last ? eventSentence(recording->events[*last]) : ""}, {"event.number", last ? std::to_string(*last + 1) : "0"},
      {"vehicles", std::to_string(recording != nullptr ? recording->vehicles.size() : 0)}, {"guns", std::to_string(recording != nullptr ? recording->guns.size() : 0)}, {"observers", std::to_string(recording != nullptr ? recording->observers.size() : 0)},
      {"selected", document.selected().id}, {"selected.kind", std::string(kindName(document.selected().kind))},
      {"undo", std::to_string(document.history().undoSteps())}, {"redo", std::to_string(document.history().redoSteps())}, {"undo.label", std::string(document.history().undoLabel())},
      {"ruler", std::to_string(mission.ruler.points)},
  });
  if (mission.ruler.complete() && recording != nullptr) {
    const RulerReading reading = readRuler(mission.ruler, recording->terrain, 2);
    out.insert(out.end(), {{"ruler.distance", shortest(reading.level_m)}, {"ruler.azimuth", shortest(reading.azimuth_mil)}, {"ruler.clear", yes(reading.sight.clear)}});
  }
  if (const auto place = mission.placeNow(document.selected())) out.insert(out.end(), {{"selected.x", shortest(place->x_m)}, {"selected.z", shortest(place->z_m)}, {"selected.taken", yes(mission.taken(document.selected().id))}});
  if (const int vehicle = mission.selectedVehicle(); vehicle >= 0) out.emplace_back("selected.speed", shortest(recording->vehicles[static_cast<std::size_t>(vehicle)].track.at(mission.clock.time_s).speed_mps));
  if (recording == nullptr || document.selected().kind != ObjectRef::Kind::observer) return;
  const Grade grade = gradeOf(*recording, document.selected().id, mission.clock.time_s);
  const auto open = openMissions(*recording, document.selected().id, mission.clock.time_s);
  const auto form = open.empty() ? mission.corrections.end() : mission.corrections.find(open.back().number);
  const CorrectionForm said = form != mission.corrections.end() ? form->second : CorrectionForm{};
  out.insert(out.end(), {{"graded", std::to_string(grade.corrections)}, {"open missions", std::to_string(open.size())}, {"rounds", open.empty() ? "0" : std::to_string(open.back().rounds)},
                         {"call.x", shortest(mission.call.grid.x_m)}, {"call.z", shortest(mission.call.grid.z_m)}, {"call.azimuth", shortest(mission.call.azimuth_mil)}, {"call.distance", shortest(mission.call.distance_m)},
                         {"correct.right", shortest(said.right_m)}, {"correct.add", shortest(said.add_m)}});
}

bool ruling(const Editor& editor) { return editor.session().inMission() ? editor.session().mission().ruler.active : editor.state().desk.view.ruler; }

/// What is laid over the effect in time.
std::string overlays(const Design& design) {
  std::string out;
  for (const auto& [on, name] : {std::pair(design.show_onion, "onion"), std::pair(design.show_trails, "trails"), std::pair(design.show_speed, "speed"), std::pair(design.show_figures, "figures")})
    if (on) out += (out.empty() ? "" : " ") + std::string(name);
  return out;
}

/// What lies around the documents.
void addDesk(const Editor& editor, Facts& out) {
  constexpr const char* kSheets[] = {"none", "history", "find", "messages", "export"};
  const Recovery& recovery = editor.desk().recovery();
  const DeskUi::View& view = editor.state().desk.view;
  out.insert(out.end(), {
      {"autosaved", yes(recovery.safe(editor.session()))}, {"unsaved", std::to_string(recovery.found().size())}, {"outside", yes(editor.session().outside())},
      {"sheet", kSheets[static_cast<int>(editor.state().desk.sheet)]}, {"theme", editor.state().light ? "light" : "dark"},
      {"export", std::string(exportName(editor.state().desk.exports.choice.kind))}, {"overlays", overlays(editor.session().design)},
      {"exports", std::to_string(editor.desk().exports().jobs().size())}, {"exporting", std::to_string(editor.desk().exports().running())},
      {"grid", yes(view.grid)}, {"extent", yes(view.extent)}, {"background", view.background}, {"quality", view.quality}, {"drawn", qualityText(view.chooser.drawn())}, {"exposure", shortest(view.exposure_stops)},
      {"ruling", yes(ruling(editor))}, {"ruler.length", shortest(view.points == 2 ? length(view.ends[1] - view.ends[0]) : 0.0)}, {"tour", std::to_string(editor.state().desk.tour + 1)},
      {"favourites", std::to_string(editor.desk().settings.favourites.size())}, {"recent", editor.desk().settings.recent.empty() ? "" : editor.desk().settings.recent.front()},
  });
}

}  // namespace

Facts Editor::facts() const {
  const Session& session = this->session();
  constexpr const char* kModes[] = {"closed", "open", "save as"};
  Facts out;
  if (session.inMission()) addMission(session.mission(), state(), out);
  else addExplosion(session, out);
  out.insert(out.end(), {
      {"mode", session.inMission() ? "mission" : "explosion"},
      {"window.width", shortest(static_cast<double>(ImGui::GetIO().DisplaySize.x))}, {"window.height", shortest(static_cast<double>(ImGui::GetIO().DisplaySize.y))},
      {"dirty", yes(session.file().dirty())}, {"window.title", session.title()}, {"file", session.file().path().string()},
      {"question", yes(session.asking() != Intent::none)}, {"quitting", yes(session.quitting())},
      {"files", kModes[static_cast<int>(session.files.mode)]},
      {"error", session.notices.error}, {"note", session.notices.note}, {"hint", state().hint}, {"clipboard", ImGui::GetClipboardText() != nullptr ? ImGui::GetClipboardText() : ""}, {"typing", state().typing.name},
  });
  addDesk(*this, out);
  return out;
}

}  // namespace npsee::editor
