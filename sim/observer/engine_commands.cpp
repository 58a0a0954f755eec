#include "sim/observer/engine.h"

#include <algorithm>

namespace npsee {

using namespace observer;

void Mission::State::obeyCommands() {
  while (next_command < commands.size() && commands[next_command].t_s <= now_s + 1e-9) obey(commands[next_command++]);
}

void Mission::State::refuseOrder(const std::string& text) { log(EventKind::warning, now_s).fields = {{"text", text}}; }

void Mission::State::obey(const MissionCommand& command) {
  using enum MissionCommand::Kind;
  const int vehicle = rec.findVehicle(command.who);
  const auto v = static_cast<std::size_t>(std::max(vehicle, 0));
  switch (command.kind) {
    case drive:
      if (vehicle < 0) return refuseOrder("There is no vehicle \"" + printable(command.who) + "\" to drive.");
      if (rec.vehicles[v].destroyedAt(now_s)) return refuseOrder("Vehicle " + command.who + " is destroyed and does not drive.");
      return vehicles->drive(v, tick, command.speed_mps, command.turn_radps);
    case take:
    case release: return handOver(command);
    case call_for_fire: return humanCall(command);
    case correct:
    case fire_for_effect:
    case end_mission: return humanWord(command);
    case shoot:
      if (vehicle < 0 || rec.vehicles[v].destroyedAt(now_s)) return refuseOrder("There is no vehicle \"" + printable(command.who) + "\" that can shoot.");
      if (!rec.vehicles[v].type.weapon) return refuseOrder("Vehicle " + command.who + " has no weapon.");
      return shootDirect(vehicle, {command.place.x_m, rec.terrain.surface(command.place.x_m, command.place.z_m) + 1.0, command.place.z_m}, rec.findVehicle(command.target));
  }
}

void Mission::State::handOver(const MissionCommand& command) {
  const bool person = command.kind == MissionCommand::Kind::take;
  const int vehicle = rec.findVehicle(command.who), observer = rec.findObserver(command.who);
  if (observer >= 0) posts[static_cast<std::size_t>(observer)].human = person;
  else if (vehicle >= 0) vehicles->hand(static_cast<std::size_t>(vehicle), tick, person);
  else return refuseOrder("There is no observer or vehicle \"" + printable(command.who) + "\" to take over.");
  log(EventKind::warning, now_s).fields = {{observer >= 0 ? "observer" : "target", command.who}, {"text", std::string(person ? "A person takes over " : "A person hands back ") + command.who + "."}};
  if (observer >= 0) posts[static_cast<std::size_t>(observer)].dirty = true;
}

/// What a person says to a mission that is open, if it is his.
void Mission::State::humanWord(const MissionCommand& command) {
  using enum MissionCommand::Kind;
  const std::string number = "Mission " + std::to_string(command.mission);
  FireMission* mission = command.mission >= 1 && command.mission <= static_cast<int>(missions.size()) ? &missionOf(command.mission) : nullptr;
  if (!mission || mission->over) return refuseOrder(number + (command.kind == end_mission ? " is not open; there is nothing to end." : " is not open; the correction is dropped."));
  if (rec.findObserver(command.who) != mission->post)
    return refuseOrder(number + " is not that of \"" + printable(command.who) + "\", but of " + posts[static_cast<std::size_t>(mission->post)].setup->id + "; the order is dropped.");
  if (command.kind == end_mission) return endMission(*mission, "ended", command.description.empty() ? "Ended by the observer." : command.description, nullptr);
  this->correct(mission->post, {.kind = command.kind == MissionCommand::Kind::correct ? Decision::Kind::correct : Decision::Kind::fire_for_effect, .mission = command.mission,
                          .right_m = command.right_m, .add_m = command.add_m, .reason = {}, .rule = "person", .facts = {}});
}

/// The hostile that an observer sees nearest to a place, within 500 m; -1 if there is none.
int Mission::State::seenNear(const Post& post, const Vec3& place) const {
  int found = -1;
  double best = 500.0;
  for (std::size_t v = 0; v < rec.vehicles.size(); ++v) {
    const double distance = levelDistance(vehicleAt(static_cast<int>(v)), place);
    if (!post.knows[v].seen || rec.vehicles[v].type.side != Side::hostile || distance >= best) continue;
    best = distance;
    found = static_cast<int>(v);
  }
  return found;
}

/// A person's call for fire, by place or by a target he names and knows. A mission by place is against whatever he sees nearest to it.
void Mission::State::humanCall(const MissionCommand& command) {
  const int p = rec.findObserver(command.who);
  if (p < 0) return refuseOrder("There is no observer \"" + printable(command.who) + "\" to call fire.");
  Post& post = posts[static_cast<std::size_t>(p)];
  if (!post.alive) return refuseOrder("Observer " + command.who + " is destroyed and calls no fire.");
  FireMission mission;
  mission.post = p;
  mission.method = command.method == FireMethod::automatic ? FireMethod::adjust_fire : command.method;
  if (command.target.empty()) {
    mission.target_m = {command.place.x_m, rec.terrain.surface(command.place.x_m, command.place.z_m), command.place.z_m};
    mission.target = seenNear(post, mission.target_m);
    if (mission.target >= 0) {
      // Where he says it is, is his belief of it from now on.
      const Vec3 true_place = vehicleAt(mission.target);
      post.knows[static_cast<std::size_t>(mission.target)].error_m = {mission.target_m.x - true_place.x, 0.0, mission.target_m.z - true_place.z};
    }
  } else {
    mission.target = rec.findVehicle(command.target);
    if (mission.target < 0) return refuseOrder("There is no vehicle \"" + printable(command.target) + "\" to call fire on.");
    const Acquaintance& known = post.knows[static_cast<std::size_t>(mission.target)];
    if (!known.known) return refuseOrder("Observer " + command.who + " has not seen " + command.target + "; a call for fire on it needs a place.");
    mission.target_m = known.believed_m;
  }
  lookAlong(mission);
  follow(mission);
  open(std::move(mission), {.reason = command.description, .rule = "person", .facts = {}});
}

}  // namespace npsee
