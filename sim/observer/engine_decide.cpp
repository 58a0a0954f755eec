#include "sim/observer/engine.h"

#include <algorithm>
#include <cmath>

namespace npsee {

using namespace observer;

namespace {

void explain(MissionEvent& event, const Decision& why) {
  event.fields.push_back({"rule", why.rule});
  event.fields.push_back({"facts", why.facts});
}

}  // namespace

void Mission::State::think() {
  for (std::size_t p = 0; p < posts.size(); ++p) {
    Post& post = posts[p];
    if (!post.alive || !post.dirty) continue;
    post.dirty = false;
    decisions.clear();
    if (auto done = post.mind->think(decisions); !done) {
      fail("The rules of observer " + post.setup->id + " failed: " + done.error().text());
      return;
    }
    // Deciding may tell the mind of missions, which asks for another round in the next tick; the list itself must not change here.
    const std::vector<Decision> list = decisions;
    for (const Decision& decision : list) decide(static_cast<int>(p), decision);
  }
}

void Mission::State::decide(int p, const Decision& decision) {
  Post& post = posts[static_cast<std::size_t>(p)];
  const bool known_mission = decision.mission >= 1 && decision.mission <= static_cast<int>(missions.size()) && missionOf(decision.mission).post == p;
  switch (decision.kind) {
    case Decision::Kind::call:
      if (!post.human) call(p, decision);
      break;
    case Decision::Kind::correct:
    case Decision::Kind::fire_for_effect:
      if (!known_mission || missionOf(decision.mission).over) break;
      if (post.human) missionOf(decision.mission).suggested = {decision.right_m, decision.add_m};
      else correct(p, decision);
      break;
    case Decision::Kind::end:
      if (known_mission && !missionOf(decision.mission).over && !post.human) {
        FireMission& mission = missionOf(decision.mission);
        const auto state = condition(mission.target);
        endMission(mission, state == Contact::Condition::destroyed ? "destroyed" : state == Contact::Condition::damaged ? "damaged" : "no_effect", decision.reason, &decision);
      }
      break;
    case Decision::Kind::withdraw: {
      if (post.human || !post.setup->self_preservation) break;
      MissionEvent& event = log(EventKind::warning, now_s);
      event.fields = {{"observer", post.setup->id}, {"position", vehicleAt(post.vehicle)}, {"text", "Observer " + post.setup->id + " withdraws: " + (decision.reason.empty() ? "fire or a hostile is near" : decision.reason) + "."}};
      explain(event, decision);
      vehicles->withdraw(static_cast<std::size_t>(post.vehicle), tick, post.incoming_from);
      break;
    }
    case Decision::Kind::warn: {
      MissionEvent& event = log(EventKind::warning, now_s);
      event.fields = {{"observer", post.setup->id}};
      if (decision.contact >= 0 && decision.contact < static_cast<int>(rec.vehicles.size())) event.fields.push_back({"target", vehicleId(decision.contact)});
      event.fields.push_back({"text", decision.reason});
      explain(event, decision);
      break;
    }
  }
}

/// The observer's call for fire opens a mission; the fire direction centre answers in this or a later tick.
void Mission::State::call(int p, const Decision& decision) {
  Post& post = posts[static_cast<std::size_t>(p)];
  if (decision.contact < 0 || decision.contact >= static_cast<int>(rec.vehicles.size())) return;
  const Acquaintance& a = post.knows[static_cast<std::size_t>(decision.contact)];
  if (!a.known) return;
  for (const FireMission& mission : missions)
    if (!mission.over && !mission.burning && mission.post == p && mission.target == decision.contact) return;

  FireMission mission;
  mission.post = p;
  mission.target = decision.contact;
  mission.method = decision.method == FireMethod::automatic ? FireMethod::adjust_fire : decision.method;
  mission.aim_m = mission.target_m = a.believed_m;
  lookAlong(mission);
  open(std::move(mission), decision);
}

void Mission::State::open(FireMission mission, const Decision& why) {
  const std::string& caller = posts[static_cast<std::size_t>(mission.post)].setup->id;
  mission.number = static_cast<int>(missions.size()) + 1;
  mission.effect = mission.method != FireMethod::adjust_fire;
  mission.opened_s = now_s;
  int friendly = -1;
  mission.friendly_m = nearestFriendly(mission.target_m, mission.target, &friendly);
  mission.danger_close = mission.friendly_m <= rec.scenario.fdc.danger_close_m;

  MissionEvent& event = log(EventKind::call, now_s);
  event.fields = {{"observer", caller}, {"mission", std::int64_t{mission.number}}, {"target", vehicleId(mission.target)}, {"method", std::string(methodName(mission.method))},
                  {"position", mission.aim_m}, {"range_m", mission.ot_distance_m}, {"danger_close", mission.danger_close}};
  if (!why.reason.empty()) event.fields.push_back({"text", why.reason});
  explain(event, why);
  if (mission.danger_close)
    log(EventKind::danger_close, now_s).fields = {{"observer", caller}, {"mission", std::int64_t{mission.number}}, {"target", vehicleId(mission.target)}, {"friendly", vehicleId(friendly)}, {"distance_m", mission.friendly_m}};
  missions.push_back(std::move(mission));
  tellMission(missions.back(), MissionFact::State::accepted);
}

/// Turns a correction from the observer-target frame into the world; the message may be misheard on its way.
void Mission::State::correct(int p, const Decision& decision) {
  Post& post = posts[static_cast<std::size_t>(p)];
  FireMission& mission = missionOf(decision.mission);
  const Misheard heard = mishear(rec.scenario.fdc, rec.scenario.seed, static_cast<std::uint32_t>(mission.number), static_cast<std::uint32_t>(mission.messages++), decision.right_m, decision.add_m);
  const Vec3 right{-mission.ot.z, 0.0, mission.ot.x};
  if (!heard.lost) mission.correction_m = mission.correction_m + heard.right_m * right + heard.add_m * mission.ot;
  follow(mission);
  const bool effect = decision.kind == Decision::Kind::fire_for_effect;
  mission.effect = effect;
  mission.waiting = true;
  mission.tasks.clear();

  MissionEvent& event = log(EventKind::correction, now_s);
  event.fields = {{"observer", post.setup->id}, {"mission", std::int64_t{mission.number}}, {"target", vehicleId(mission.target)}, {"round", std::int64_t{mission.adjusting}},
                  {"right_m", decision.right_m}, {"add_m", decision.add_m}, {"method", std::string(effect ? "fire_for_effect" : "adjust_fire")},
                  {"position", mission.aim_m}, {"aim_error_m", aimError(mission)}};
  if (heard.changed || heard.lost) event.fields.push_back({"misheard", heard.how});
  if (mission.suggested) {
    // A person corrected: what the rules would have said, for the grade.
    event.fields.push_back({"automatic_right_m", mission.suggested->first});
    event.fields.push_back({"automatic_add_m", mission.suggested->second});
    const double dr = decision.right_m - mission.suggested->first, da = decision.add_m - mission.suggested->second;
    event.fields.push_back({"grade_m", std::sqrt(dr * dr + da * da)});
    mission.suggested.reset();
  }
  explain(event, decision);
  tellMission(mission, MissionFact::State::accepted);
}

double Mission::State::aimError(const FireMission& mission) const {
  if (mission.target < 0) return levelDistance(mission.aim_m, mission.target_m);
  // The aim is the target where he believes it, with the corrections; how far it has driven since is the lead's business.
  const Vec3 off = posts[static_cast<std::size_t>(mission.post)].knows[static_cast<std::size_t>(mission.target)].error_m + (rec.scenario.fdc.absolute_relay ? Vec3{} : mission.correction_m);
  return std::sqrt(off.x * off.x + off.z * off.z);
}

void Mission::State::endMission(FireMission& mission, const std::string& result, const std::string& reason, const Decision* why) {
  if (mission.over) return;
  mission.over = true;
  release(mission);
  const double error = aimError(mission);
  // Standard of world.md: within 50 m in at most three adjusting rounds is good.
  const std::string grade = error <= 50.0 ? (mission.adjusting <= 3 ? "good" : "slow") : "off";
  MissionEvent& event = log(EventKind::end_of_mission, now_s);
  event.fields = {{"observer", posts[static_cast<std::size_t>(mission.post)].setup->id}, {"mission", std::int64_t{mission.number}}, {"target", vehicleId(mission.target)}, {"result", result}, {"reason", reason},
                  {"rounds", std::int64_t{mission.fired}}, {"adjusting", std::int64_t{mission.adjusting}}, {"volleys", std::int64_t{mission.effects}}, {"aim_error_m", error}, {"lasted_s", now_s - mission.opened_s}};
  if (mission.fired > 0) event.fields.push_back({"grade", grade});
  if (why) explain(event, *why);
  tellMission(mission, MissionFact::State::ended, reason);
}

void Mission::State::tellMission(const FireMission& mission, MissionFact::State state, const std::string& reason) {
  missionOf(mission.number).state = state;
  Post& post = posts[static_cast<std::size_t>(mission.post)];
  post.mind->mission({.mission = mission.number, .contact = mission.target, .state = state, .method = mission.method, .rounds = mission.adjusting, .danger_close = mission.danger_close,
                      .ot_distance_m = std::floor(mission.ot_distance_m / 10.0 + 0.5) * 10.0, .reason = reason});
  post.dirty = true;
}

}  // namespace npsee
