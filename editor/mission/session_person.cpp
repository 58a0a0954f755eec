// The person in the loop: what the forms say becomes commands of the mission.

#include "editor/mission/session.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace npsee::editor {
namespace {

MissionCommand commandOf(MissionCommand::Kind kind, const std::string& who) {
  MissionCommand out;
  out.kind = kind;
  out.who = who;
  return out;
}

}  // namespace

Expected<void> MissionSession::command(std::string_view label, std::string_view merge_key, MissionCommand command) {
  if (!recording_) return fail(ErrorKind::usage, "The mission has not been simulated yet.", "Wait a moment.");
  command.t_s = commandTime(clock.time_s);
  if (command.t_s > document.scenario().duration_s) return fail(ErrorKind::usage, "The mission is over.", "Go back in time, or raise its duration.");
  document.command(label, merge_key, withCommand(*document.commands(), std::move(command)));
  return {};
}

/// The form begins at what the observer saw last, or a kilometre before him.
void MissionSession::prepareCall(int observer) {
  if (observer < 0 || call.grid != Place{}) return;
  const Vec3 eye = recording_->observerEye(static_cast<std::size_t>(observer), clock.time_s);
  Place at{eye.x, eye.z - 1000.0};
  const auto known = knownPoints(*recording_, observer, clock.time_s);
  if (!known.empty()) {
    at = known.front().at;
    call.known = known.front().name;
  }
  const WorldSetup& world = recording_->scenario.world;
  call.grid = {std::round(std::clamp(at.x_m, 0.0, world.size_x_m)), std::round(std::clamp(at.z_m, 0.0, world.size_z_m))};
  const auto [azimuth, distance] = polarTo(*recording_, observer, clock.time_s, call.grid);
  call.azimuth_mil = std::round(azimuth);
  call.distance_m = std::round(distance);
}

Expected<void> MissionSession::take(const std::string& who) {
  if (taken(who)) return {};
  if (recording_) prepareCall(recording_->findObserver(who));
  return command("Take over " + who, {}, commandOf(MissionCommand::Kind::take, who));
}

Expected<void> MissionSession::release(const std::string& who) {
  if (!taken(who)) return {};
  return command("Hand back " + who, {}, commandOf(MissionCommand::Kind::release, who));
}

Expected<void> MissionSession::callForFire(const std::string& observer) {
  if (!recording_) return fail(ErrorKind::usage, "The mission has not been simulated yet.", "Wait a moment.");
  const auto place = placeOfCall(call, *recording_, recording_->findObserver(observer), clock.time_s);
  if (!place) return tl::unexpected<Error>(place.error());
  MissionCommand out = commandOf(MissionCommand::Kind::call_for_fire, observer);
  out.place = *place;
  out.method = call.method;
  out.description = call.description;
  return command("Call for fire", {}, std::move(out));
}

Expected<void> MissionSession::correct(const std::string& observer, int mission, bool for_effect) {
  MissionCommand out = commandOf(for_effect ? MissionCommand::Kind::fire_for_effect : MissionCommand::Kind::correct, observer);
  out.mission = mission;
  const CorrectionForm& said = corrections[mission];
  out.right_m = said.right_m;
  out.add_m = said.add_m;
  auto done = command(for_effect ? "Fire for effect" : "Correction", {}, std::move(out));
  if (done) corrections.erase(mission);
  return done;
}

std::optional<double> MissionSession::measure(const std::string& observer, const Vec3& direction) {
  const int index = recording_ ? recording_->findObserver(observer) : -1;
  if (index < 0) return std::nullopt;
  const auto open = openMissions(*recording_, observer, clock.time_s);
  if (open.empty()) return std::nullopt;
  const auto [azimuth, distance] = polarTo(*recording_, index, clock.time_s, open.back().at);
  const double right = std::remainder(std::atan2(direction.x, -direction.z) * kMilPerRad - azimuth, 6400.0);
  corrections[open.back().number].right_m = lateralCorrection(right, distance);
  return right;
}

Expected<void> MissionSession::endMission(const std::string& observer, int mission) {
  MissionCommand out = commandOf(MissionCommand::Kind::end_mission, observer);
  out.mission = mission;
  return command("End of mission", {}, std::move(out));
}

Expected<void> MissionSession::drive(const std::string& vehicle, double speed_mps, double turn_radps) {
  MissionCommand out = commandOf(MissionCommand::Kind::drive, vehicle);
  out.speed_mps = speed_mps;
  out.turn_radps = turn_radps;
  return command("Drive " + vehicle, "drive " + vehicle, std::move(out));
}

Expected<void> MissionSession::shoot(const std::string& vehicle, const Place& at, const std::string& target) {
  MissionCommand out = commandOf(MissionCommand::Kind::shoot, vehicle);
  out.place = at;
  out.target = target;
  return command("Shoot", {}, std::move(out));
}

}  // namespace npsee::editor
