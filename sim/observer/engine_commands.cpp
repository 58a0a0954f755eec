#include "sim/observer/engine.h"

#include <algorithm>

namespace npsee {

using namespace observer;

void Mission::State::obeyCommands() {
  while (next_command < commands.size() && commands[next_command].t_s <= now_s + 1e-9) obey(commands[next_command++]);
}

void Mission::State::obey(const MissionCommand& command) {
  using enum MissionCommand::Kind;
  const auto refuse = [&](const std::string& text) { log(EventKind::warning, now_s).fields = {{"text", text}}; };
  const int vehicle = rec.findVehicle(command.who), observer = rec.findObserver(command.who);
  const auto v = static_cast<std::size_t>(std::max(vehicle, 0));
  FireMission* mission = command.mission >= 1 && command.mission <= static_cast<int>(missions.size()) ? &missionOf(command.mission) : nullptr;
  switch (command.kind) {
    case drive:
      if (vehicle < 0) return refuse("There is no vehicle \"" + printable(command.who) + "\" to drive.");
      if (!rec.vehicles[v].destroyedAt(now_s)) vehicles->drive(v, tick, command.speed_mps, command.turn_radps);
      return;
    case take:
    case release: {
      const bool person = command.kind == take;
      if (observer >= 0) posts[static_cast<std::size_t>(observer)].human = person;
      else if (vehicle >= 0) vehicles->hand(v, tick, person);
      else return refuse("There is no observer or vehicle \"" + printable(command.who) + "\" to take over.");
      log(EventKind::warning, now_s).fields = {{observer >= 0 ? "observer" : "target", command.who}, {"text", std::string(person ? "A person takes over " : "A person hands back ") + command.who + "."}};
      if (observer >= 0) posts[static_cast<std::size_t>(observer)].dirty = true;
      return;
    }
    case call_for_fire:
      if (observer < 0) return refuse("There is no observer \"" + printable(command.who) + "\" to call fire.");
      return humanCall(observer, command);
    case correct:
    case fire_for_effect: {
      if (!mission || mission->over) return refuse("Mission " + std::to_string(command.mission) + " is not open; the correction is dropped.");
      Decision decision{.kind = command.kind == correct ? Decision::Kind::correct : Decision::Kind::fire_for_effect, .mission = command.mission, .right_m = command.right_m, .add_m = command.add_m, .reason = {}, .rule = "person", .facts = {}};
      return this->correct(mission->post, decision);
    }
    case end_mission:
      if (mission && !mission->over) endMission(*mission, "ended", command.description.empty() ? "Ended by the observer." : command.description, nullptr);
      return;
    case shoot:
      if (vehicle < 0 || rec.vehicles[v].destroyedAt(now_s)) return refuse("There is no vehicle \"" + printable(command.who) + "\" that can shoot.");
      if (!rec.vehicles[v].type.weapon) return refuse("Vehicle " + command.who + " has no weapon.");
      return shootDirect(vehicle, {command.place.x_m, rec.terrain.surface(command.place.x_m, command.place.z_m) + 1.0, command.place.z_m}, rec.findVehicle(command.target));
  }
}

/// A person's call for fire, by place or by a target he names. The mission is against whatever he knows nearest to the place.
void Mission::State::humanCall(int p, const MissionCommand& command) {
  Post& post = posts[static_cast<std::size_t>(p)];
  int target = rec.findVehicle(command.target);
  const Vec3 place{command.place.x_m, rec.terrain.surface(command.place.x_m, command.place.z_m), command.place.z_m};
  if (target < 0) {
    double best = 500.0;
    for (std::size_t v = 0; v < rec.vehicles.size(); ++v) {
      const double distance = levelDistance(vehicleAt(static_cast<int>(v)), place);
      if (!post.knows[v].seen || rec.vehicles[v].type.side != Side::hostile || distance >= best) continue;
      best = distance;
      target = static_cast<int>(v);
    }
  }
  FireMission mission;
  mission.post = p;
  mission.target = target;
  mission.method = command.method == FireMethod::automatic ? FireMethod::adjust_fire : command.method;
  mission.target_m = place;
  if (target >= 0) {
    // Where he says it is, is his belief of it from now on.
    const Vec3 true_place = vehicleAt(target);
    if (command.target.empty()) post.knows[static_cast<std::size_t>(target)].error_m = {place.x - true_place.x, 0.0, place.z - true_place.z};
  }
  lookAlong(mission);
  follow(mission);
  open(std::move(mission), {.reason = command.description, .rule = "person", .facts = {}});
}

}  // namespace npsee
