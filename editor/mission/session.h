#pragma once

#include "app/render/mission_scene.h"
#include "editor/mission/clock.h"
#include "editor/mission/document.h"
#include "editor/mission/fire_form.h"
#include "editor/mission/person.h"
#include "editor/mission/ruler.h"
#include "editor/mission/runner.h"
#include "editor/mission/shots.h"
#include "editor/mission/words.h"

#include <npsee/weapons.h>

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace npsee::editor {

struct Notices;

struct MissionSessionOptions {
  bool wait_for_simulation = false;  ///< scripts: every frame shows the finished simulation
};

/// A mission at work without a picture: document, simulation, time line, camera, and the person in the loop. No ImGui, no GL.
///
/// Who shows something reads recording(), a copy that nobody changes; the simulation goes on elsewhere. After an edit or a command the
/// old one stays until the new one has come as far as the moment shown.
class MissionSession {
 public:
  explicit MissionSession(MissionSessionOptions options);

  MissionDocument document;
  MissionClock clock;
  render::MissionView view;
  bool own_burst = false;  ///< bursts show the preset of the explosion mode instead of their own
  EventFilter filter;
  Ruler ruler;
  CallForm call;
  std::map<int, CorrectionForm> corrections;  ///< by the mission they are for; what was said is taken out

  /// Lets time pass, hands changes to the simulation and takes what it has finished. Messages go to `notices`.
  void update(double elapsed_s, Notices& notices);

  /// What is shown; null before the first simulation has begun.
  const Recording* recording() const { return recording_.get(); }
  std::shared_ptr<const Recording> sharedRecording() const { return recording_; }
  /// Differs when the recording is another one.
  std::uint64_t recordingNumber() const { return recording_number_; }
  const std::vector<Shot>& shots() const { return shots_; }
  /// By what a vehicle of the recording is selected.
  const ObjectRef& owner(int vehicle) const { return owners_[static_cast<std::size_t>(vehicle)]; }
  /// Reach of each battery's weapon as its weapons.dat gives it, m; 0 = unknown.
  const std::vector<double>& reach() const { return reach_; }
  /// What batteries can be armed with, from the mission's weapons.dat; empty before there is a recording.
  const std::vector<Weapon>& weapons() const { return weapons_; }
  bool simulating() const { return runner_.busy() || requested_ != wanted(); }
  /// Share of the mission that the running simulation has covered, 0..1.
  double progress() const;
  /// True while a person is in the loop at the moment shown: the mission is simulated as time passes, and no further.
  bool live() const;

  /// File matters; errors leave everything as it was.
  Expected<void> load(const std::filesystem::path& path);
  void startNew();
  /// Differs after every mission opened or begun.
  std::uint64_t missionNumber() const { return mission_number_; }

  // Time.
  void seekEvent(std::size_t event);
  std::optional<std::size_t> lastEvent() const;  ///< the newest one at the moment shown

  // Camera. Each kind keeps what it was; `look` changes to another and back.
  void look(render::MissionCamera::Kind kind, int subject = -1);
  void frameAll();
  /// Puts the selected object in the middle, as near as the present camera allows.
  void showSelected();
  void setAspect(double aspect) { aspect_ = aspect; }
  double aspect() const { return aspect_; }

  // The selected object in the recording; -1 if it is not of that kind.
  int selectedVehicle() const;
  int selectedGun() const;
  int selectedObserver() const;
  /// Selects a vehicle, gun or observer of the recording.
  void selectVehicle(int index);
  /// The scenario with what a facts file brings: that of the recording, else the document's.
  const Scenario& shownScenario() const;
  /// What of the scenario is edited where something is selected (see editor::editable).
  ObjectRef editable(const ObjectRef& ref) const { return editor::editable(shownScenario(), ref); }
  /// True if the selected thing comes from a facts file and is not in the mission itself.
  bool selectedFromFacts() const;
  /// Makes what the facts file brings part of the mission, so that it can be edited; nothing if there is none.
  Expected<void> adopt();
  /// Where something stands at the moment shown.
  std::optional<Place> placeNow(const ObjectRef& ref) const;

  // The person in the loop. Errors are of kind usage.
  bool taken(const std::string& who) const { return takenOver(*document.commands(), who, commandTime(clock.time_s)); }
  Expected<void> take(const std::string& who);
  Expected<void> release(const std::string& who);
  /// Calls fire as `call` says, for the observer.
  Expected<void> callForFire(const std::string& observer);
  /// Corrects the observer's mission as `corrections` says; then adjusts on, or fires for effect.
  Expected<void> correct(const std::string& observer, int mission, bool for_effect);
  /// A burst is seen along `direction` from the observer's eye: its deviation from the target of his newest mission, in mils right of it,
  /// fills in the lateral correction. Nothing if he has no mission under way.
  std::optional<double> measure(const std::string& observer, const Vec3& direction);
  Expected<void> endMission(const std::string& observer, int mission);
  /// Drives a vehicle that was taken over: wished speed (m/s) and turn rate (rad/s).
  Expected<void> drive(const std::string& vehicle, double speed_mps, double turn_radps);
  Expected<void> shoot(const std::string& vehicle, const Place& at, const std::string& target);

 private:
  struct Wanted {
    std::uint64_t revision = 0;
    double until_s = 0.0;
    friend bool operator==(const Wanted&, const Wanted&) = default;
  };
  Wanted wanted() const;
  double limit(bool in_the_loop) const;
  void beginAnew();
  void ask();
  void takeResults(Notices& notices);
  void prepareCall(int observer);
  void accept(std::shared_ptr<const Recording> recording);
  Expected<void> command(std::string_view label, std::string_view merge_key, MissionCommand command);

  MissionSessionOptions options_;
  MissionRunner runner_;
  Wanted requested_;
  std::uint64_t request_number_ = 0;
  std::shared_ptr<const Recording> recording_;
  std::uint64_t recording_number_ = 0, mission_number_ = 0;
  std::string simulation_error_;  ///< shown while the recording is not that of the mission
  std::vector<Shot> shots_;
  std::vector<ObjectRef> owners_;
  std::vector<double> reach_;
  std::vector<Weapon> weapons_;
  std::array<std::optional<render::MissionCamera>, 6> cameras_;
  bool frame_on_arrival_ = true;  ///< a new mission is put into view, an edit is not
  double aspect_ = 1.6;
  double horizon_s_ = 0.0;        ///< how far a live mission has been asked for
  std::uint64_t horizon_revision_ = 0;
};

}  // namespace npsee::editor
