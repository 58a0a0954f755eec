#include "editor/mission/session.h"

#include "editor/document/session.h"
#include "sim/world/scenario_files.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace npsee::editor {
namespace {

using CameraKind = render::MissionCamera::Kind;
using std::chrono::milliseconds;

/// Patience with the simulation in a window; a script waits as long as it takes.
constexpr milliseconds kPatience{3}, kForever{600'000};

}  // namespace

MissionSession::MissionSession(MissionSessionOptions options) : options_(options) {}

bool MissionSession::live() const { return !allTaken(*document.commands(), commandTime(clock.time_s)).empty(); }

MissionSession::Wanted MissionSession::wanted() const {
  const double end = document.scenario().duration_s;
  if (!live()) return {document.revision(), end};
  // Nobody knows what a person will do: simulated is what has been played, in whole ticks.
  const double now = std::ceil(clock.time_s / kMissionTick_s - 1e-6) * kMissionTick_s;
  const double before = horizon_revision_ == document.revision() ? horizon_s_ : 0.0;
  const double last = document.commands()->empty() ? 0.0 : document.commands()->back().t_s;
  return {document.revision(), std::min(end, std::max({now, before, last}))};
}

void MissionSession::ask() {
  const Wanted now = wanted();
  if (now == requested_) return;
  requested_ = now;
  horizon_revision_ = now.revision;
  horizon_s_ = now.until_s;
  runner_.request({++request_number_, document.snapshot(), document.commands(), now.until_s});
}

void MissionSession::update(double elapsed_s, Notices& notices) {
  clock.setDuration(document.scenario().duration_s);
  ask();
  takeResults(notices);
  const bool was_live = live();
  static const std::vector<MissionEvent> kNone;
  const auto stopped = clock.advance(elapsed_s, limit(was_live), recording_ ? recording_->events : kNone);
  if (stopped) notices.note = "Paused: " + eventSentence(recording_->events[*stopped]);
  if (!was_live || clock.time_s <= requested_.until_s) return;
  // In a live mission the moment that is shown next is simulated now.
  ask();
  takeResults(notices);
}

/// How far playing may go: to where something is simulated; with a person in the loop beyond, unless the simulation lags behind.
double MissionSession::limit(bool in_the_loop) const {
  constexpr double kLag_s = 0.25;
  if (!recording_) return 0.0;
  return in_the_loop && recording_->duration_s >= clock.time_s - kLag_s ? document.scenario().duration_s : recording_->duration_s;
}

void MissionSession::takeResults(Notices& notices) {
  auto result = runner_.poll(options_.wait_for_simulation ? kForever : kPatience);
  if (!result || result->number != request_number_) return;
  if (!result->recording) {
    notices.error = simulation_error_ = result->recording.error().text() + (recording_ ? "\n  The picture still shows the last good mission." : "");
    return;
  }
  // A simulation on its way replaces the last one when it has come to the moment shown.
  if (!result->complete && recording_ && (*result->recording)->duration_s < std::min(clock.time_s, recording_->duration_s)) return;
  if (notices.error == simulation_error_) notices.error.clear();
  simulation_error_.clear();
  accept(std::move(*result->recording));
}

void MissionSession::accept(std::shared_ptr<const Recording> recording) {
  recording_ = std::move(recording);
  ++recording_number_;
  shots_ = shotsOf(*recording_);
  owners_ = ownersOf(*recording_);
  reach_.assign(recording_->scenario.batteries.size(), 0.0);
  if (auto weapons = world::missionWeapons(recording_->scenario)) {
    for (std::size_t i = 0; i < reach_.size(); ++i)
      if (const Weapon* weapon = weapons->find(std::to_string(recording_->scenario.batteries[i].weapon))) reach_[i] = static_cast<double>(weapon->range_m);
    weapons_ = std::move(weapons->list);
  }
  const ObjectRef& selected = document.selected();
  if (!exists(document.scenario(), selected) && !exists(recording_->scenario, selected) && (selected.kind != ObjectRef::Kind::vehicle || recording_->findVehicle(selected.id) < 0)) document.select({});
  if (std::exchange(frame_on_arrival_, false)) {
    cameras_ = {};
    view.camera.kind = view.camera.kind == CameraKind::plan ? CameraKind::plan : CameraKind::orbit;
    frameAll();
  }
}

double MissionSession::progress() const {
  const double end = std::max(document.scenario().duration_s, kMissionTick_s);
  return simulating() ? std::clamp(runner_.reached() / end, 0.0, 1.0) : recording_ ? std::clamp(recording_->duration_s / end, 0.0, 1.0) : 0.0;
}

Expected<void> MissionSession::load(const std::filesystem::path& path) {
  auto done = document.load(path);
  if (done) beginAnew();
  return done;
}

void MissionSession::startNew() {
  document.startNew();
  beginAnew();
}

/// Nothing of the mission before is kept.
void MissionSession::beginAnew() {
  ++mission_number_;
  clock = MissionClock{};
  frame_on_arrival_ = true;
  recording_.reset();
  shots_.clear();
  ruler = {};
  call = {};
  corrections.clear();
  view.presets.clear();
}

void MissionSession::seekEvent(std::size_t event) {
  if (!recording_ || event >= recording_->events.size()) return;
  clock.playing = false;
  clock.seek(recording_->events[event].t_s);
}

std::optional<std::size_t> MissionSession::lastEvent() const {
  if (!recording_) return std::nullopt;
  const std::size_t until = eventsUntil(recording_->events, clock.time_s);
  return until == 0 ? std::nullopt : std::optional(until - 1);
}

void MissionSession::look(CameraKind kind, int subject) {
  cameras_[static_cast<std::size_t>(view.camera.kind)] = view.camera;
  auto& kept = cameras_[static_cast<std::size_t>(kind)];
  if (kept) {
    view.camera = *kept;
  } else if (recording_ && (kind == CameraKind::orbit || kind == CameraKind::plan)) {
    view.camera = render::overviewCamera(*recording_, kind, aspect_);
  } else {
    // A free camera starts where the last one stood; one bound to a thing starts near it.
    if (kind == CameraKind::free && recording_) {
      const render::MissionEye eye = render::missionEye(*recording_, clock.time_s, view.camera, 16, 9);
      view.camera.eye = eye.lens.eye;
      view.camera.target = eye.lens.eye - std::clamp(view.camera.distance_m, 50.0, 2000.0) * eye.lens.back;
    }
    view.camera.kind = kind;
    if (kind == CameraKind::gun) view.camera.distance_m = 60.0;
    if (kind == CameraKind::follow) view.camera.distance_m = 80.0;
  }
  view.camera.subject = subject;
}

void MissionSession::frameAll() {
  if (!recording_) return;
  const CameraKind kind = view.camera.kind == CameraKind::plan ? CameraKind::plan : CameraKind::orbit;
  view.camera = render::overviewCamera(*recording_, kind, aspect_);
}

void MissionSession::showSelected() {
  const auto place = placeNow(document.selected());
  if (!place || !recording_) return frameAll();
  if (view.camera.kind != CameraKind::plan && view.camera.kind != CameraKind::orbit && view.camera.kind != CameraKind::free) look(CameraKind::orbit);
  const Vec3 target{place->x_m, recording_->terrain.surface(place->x_m, place->z_m), place->z_m};
  if (view.camera.kind == CameraKind::free) view.camera.eye = view.camera.eye + (target - view.camera.target);
  view.camera.target = target;
  if (view.camera.kind == CameraKind::orbit) view.camera.distance_m = std::min(view.camera.distance_m, 250.0);
  if (view.camera.kind == CameraKind::plan) view.camera.span_m = std::min(view.camera.span_m, 2000.0);
}

int MissionSession::selectedVehicle() const { return recording_ ? vehicleOf(*recording_, document.selected()) : -1; }
int MissionSession::selectedGun() const { return recording_ && document.selected().kind == ObjectRef::Kind::gun ? recording_->findGun(document.selected().id) : -1; }
int MissionSession::selectedObserver() const { return recording_ && document.selected().kind == ObjectRef::Kind::observer ? recording_->findObserver(document.selected().id) : -1; }

void MissionSession::selectVehicle(int index) {
  if (recording_ && index >= 0 && index < static_cast<int>(owners_.size())) document.select(owners_[static_cast<std::size_t>(index)]);
}

const Scenario& MissionSession::shownScenario() const {
  const Scenario& own = document.scenario();
  const bool from_facts = recording_ && !own.facts.empty() && (own.observers.empty() || own.batteries.empty());
  return from_facts ? recording_->scenario : own;
}

bool MissionSession::selectedFromFacts() const { return recording_ && !exists(document.scenario(), document.selected()) && exists(recording_->scenario, document.selected()); }

Expected<void> MissionSession::adopt() {
  if (!recording_) return {};
  return document.edit("Write the facts into the mission", {}, [this](Scenario& scenario) { adoptFacts(scenario, *recording_); });
}

std::optional<Place> MissionSession::placeNow(const ObjectRef& ref) const {
  if (recording_) {
    if (const int vehicle = vehicleOf(*recording_, ref); vehicle >= 0) {
      const Pose pose = recording_->vehicles[static_cast<std::size_t>(vehicle)].track.at(clock.time_s);
      return Place{pose.x_m, pose.z_m};
    }
  }
  return placeOf(shownScenario(), ref);
}

}  // namespace npsee::editor
