#include "sim/observer/engine.h"

#include <algorithm>
#include <cmath>

namespace npsee {

using namespace observer;

namespace {

/// Seconds between two shots of a vehicle's own weapon, its rounds for one answer, and its accuracy.
constexpr double kDuelReload_s = 6.0;
constexpr int kDuelRounds = 5;
constexpr double kDuelError_rad = 1.0 / kMilsPerRadian;

/// The cloud of a burst stands some metres high, and is seen farther than a vehicle by this factor.
Vec3 cloudOf(const ShellRecord& shell) { return shell.burst_m + Vec3{0.0, 5.0, 0.0}; }
constexpr double kCloudSight = 1.25;

double spaceDistance(const Vec3& a, const Vec3& b) { return length(a - b); }

}  // namespace

/// Apexes and bursts of this tick, by their own times.
void Mission::State::flyShells(double from_s, double to_s) {
  const auto out = [from_s](const Cloud& cloud) { return cloud.until_s < from_s; };
  std::erase_if(lights, out);
  std::erase_if(smokes, out);
  if (flying.empty()) return;
  struct Moment {
    double t_s;
    int shell;
    bool apex;
  };
  std::vector<Moment> moments;
  for (Flying& f : flying) {
    const ShellRecord& shell = rec.shells[static_cast<std::size_t>(f.shell)];
    if (!f.apex_told && f.apex_s > from_s && f.apex_s <= to_s && f.apex_s < shell.burst_s && !shell.path.nodes().empty()) {
      moments.push_back({f.apex_s, f.shell, true});
      f.apex_told = true;
    }
    if (shell.burst_s <= to_s) moments.push_back({shell.burst_s, f.shell, false});
  }
  std::sort(moments.begin(), moments.end(), [](const Moment& a, const Moment& b) { return a.t_s != b.t_s ? a.t_s < b.t_s : a.shell < b.shell; });
  for (const Moment& moment : moments) {
    const ShellRecord& shell = rec.shells[static_cast<std::size_t>(moment.shell)];
    if (moment.apex) {
      log(EventKind::apex, moment.t_s).fields = {{"shell", std::int64_t{shell.number}}, {"mission", std::int64_t{shell.mission}}, {"position", shell.at(moment.t_s)}};
      continue;
    }
    const auto f = std::find_if(flying.begin(), flying.end(), [&](const Flying& one) { return one.shell == moment.shell; });
    const Flying gone = *f;
    flying.erase(f);
    burst(gone);
  }
}

void Mission::State::burst(const Flying& flown) {
  const ShellRecord& shell = rec.shells[static_cast<std::size_t>(flown.shell)];
  const Weapon* weapon = weaponOf(shell.weapon);
  MissionEvent& event = log(EventKind::detonation, shell.burst_s);
  event.fields = {{"shell", std::int64_t{shell.number}}, {"gun", shell.gun >= 0 ? rec.guns[static_cast<std::size_t>(shell.gun)].id : vehicleId(shell.shooter)}, {"mission", std::int64_t{shell.mission}},
                  {"target", vehicleId(shell.target)}, {"position", shell.burst_m}, {"weapon", std::int64_t{shell.weapon}}};
  Vec3 aimed = flown.mission > 0 ? missionOf(flown.mission).aim_m : shell.burst_m;
  if (shell.target >= 0) {
    const Pose pose = rec.vehicles[static_cast<std::size_t>(shell.target)].track.at(shell.burst_s);
    aimed = {pose.x_m, 0.0, pose.z_m};
  }
  event.fields.push_back({"miss_m", levelDistance(aimed, shell.burst_m)});
  if (shell.illumination) {
    lights.push_back({shell.burst_m, kLightRadius_m, shell.burst_s + kLight_s});
    event.fields.push_back({"illumination", true});
  } else if (shell.smoke) {
    smokes.push_back({shell.burst_m, kSmokeRadius_m, shell.burst_s + kSmoke_s});
    event.fields.push_back({"smoke", true});
  } else if (weapon) {
    applyBurst(shell, *weapon);
  }
  if (flown.mission <= 0) return;
  FireMission& mission = missionOf(flown.mission);
  --mission.in_air;
  if (!mission.over) landed(mission, shell);
}

void Mission::State::applyBurst(const ShellRecord& shell, const Weapon& weapon) {
  const double reach = std::max({weapon.kill_radius_m, weapon.damage_radius_m, weapon.knowledge_radius_m}) + 20.0;
  for (std::size_t v = 0; v < rec.vehicles.size(); ++v) {
    const double dx = vehicles->x()[v] - shell.burst_m.x, dz = vehicles->z()[v] - shell.burst_m.z;
    if (dx * dx + dz * dz > reach * reach) continue;
    const Pose pose = rec.vehicles[v].track.at(shell.burst_s);
    const double miss = spaceDistance({pose.x_m, rec.terrain.surface(pose.x_m, pose.z_m), pose.z_m}, shell.burst_m);
    if (miss <= std::max(weapon.kill_radius_m, weapon.damage_radius_m)) damage(static_cast<int>(v), shell, weapon, miss);
    if (miss <= weapon.knowledge_radius_m) noticed(static_cast<int>(v), shell);
  }
}

void Mission::State::damage(int vehicle, const ShellRecord& shell, const Weapon& weapon, double miss_m) {
  const auto v = static_cast<std::size_t>(vehicle);
  VehicleRecord& hit = rec.vehicles[v];
  const DamageStep earlier = hit.damage.empty() ? DamageStep{} : hit.damage.back();
  if (earlier.hull >= 1.0) return;
  const DamageStep now = world::harmed(weapon, hit.type.target_class, miss_m, earlier, rec.scenario.seed, static_cast<std::uint32_t>(vehicle), hits[v]++, shell.burst_s);
  if (now.hull == earlier.hull && now.mobility == earlier.mobility && now.firepower == earlier.firepower) return;
  hit.damage.push_back(now);
  log(EventKind::damage, shell.burst_s).fields = {{"target", hit.id}, {"shell", std::int64_t{shell.number}}, {"mission", std::int64_t{shell.mission}}, {"position", vehicleAt(vehicle)}, {"miss_m", miss_m},
                                                  {"hull", now.hull}, {"mobility", now.mobility}, {"firepower", now.firepower}};
  if (!now.mobility || now.hull >= 1.0) vehicles->immobilise(v, tick);
  if (now.hull >= 1.0)
    log(EventKind::destroyed, shell.burst_s).fields = {{"target", hit.id}, {"shell", std::int64_t{shell.number}}, {"mission", std::int64_t{shell.mission}}, {"position", vehicleAt(vehicle)}, {"miss_m", miss_m}};
}

/// Those near a burst notice it: they drive away or shoot back, and observers tell their rules of hostile fire.
void Mission::State::noticed(int vehicle, const ShellRecord& shell) {
  const auto v = static_cast<std::size_t>(vehicle);
  const Side mine = rec.vehicles[v].type.side;
  const bool ours = shell.gun >= 0 ? mine == Side::friendly : rec.vehicles[static_cast<std::size_t>(shell.shooter)].type.side == mine;
  for (Post& post : posts)
    if (post.vehicle == vehicle && !ours) {
      post.incoming_from = {shell.burst_m.x, shell.burst_m.z};
      post.mind->incoming(std::floor(levelDistance(shell.burst_m, vehicleAt(vehicle)) + 0.5));
      post.dirty = true;
    }
  if (rec.vehicles[v].destroyedAt(shell.burst_s)) return;
  const bool wants = vehicles->noticesFire(v, tick, {shell.burst_m.x, shell.burst_m.z});
  if (!wants || !rec.vehicles[v].type.weapon) return;
  for (Duel& duel : duels)
    if (duel.vehicle == vehicle) {
      duel.rounds = kDuelRounds;
      return;
    }
  duels.push_back({vehicle, -1, tick + static_cast<std::int64_t>(1.0 / kMissionTick_s), kDuelRounds});
}

/// What the observer sees of an adjusting round, along his line to the target and across it.
void Mission::State::spot(FireMission& mission, const ShellRecord& shell) {
  Post& post = posts[static_cast<std::size_t>(mission.post)];
  const Sensing& sensing = post.setup->sensing;
  Spot seen{.mission = mission.number, .round = mission.adjusting, .observed = sees(post, cloudOf(shell), kCloudSight * post.setup->max_range_m)};
  Vec3 target = mission.target_m;
  if (mission.target >= 0 && post.knows[static_cast<std::size_t>(mission.target)].seen) {
    const Pose pose = rec.vehicles[static_cast<std::size_t>(mission.target)].track.at(shell.burst_s);
    target = {pose.x_m, 0.0, pose.z_m};
  }
  const double distance = std::max(1.0, levelDistance(post.eye_m, target));
  const Vec3 u{(target.x - post.eye_m.x) / distance, 0.0, (target.z - post.eye_m.z) / distance};
  double angle = bearing(post.eye_m, shell.burst_m) - bearing(post.eye_m, target);
  if (angle > 0.5 * kTwoPi) angle -= kTwoPi;
  if (angle < -0.5 * kTwoPi) angle += kTwoPi;
  const Normals n = normals(rec.scenario.seed, static_cast<std::uint32_t>(mission.post), Purpose::spotting, static_cast<std::uint32_t>(shell.number));
  seen.lateral_mil = angle * kMilsPerRadian + sensing.bearing_error_mil * n.a;
  const Vec3 d = shell.burst_m - target;
  seen.range_m = d.x * u.x + d.z * u.z + sensing.range_error * distance * n.b;
  MissionEvent& event = log(EventKind::spot, shell.burst_s);
  event.fields = {{"observer", post.setup->id}, {"mission", std::int64_t{mission.number}}, {"round", std::int64_t{seen.round}}, {"shell", std::int64_t{shell.number}}, {"target", vehicleId(mission.target)}, {"observed", seen.observed}};
  if (seen.observed) {
    event.fields.push_back({"lateral_mil", seen.lateral_mil});
    event.fields.push_back({"range_m", seen.range_m});
  }
  post.mind->spot(seen);
  post.dirty = true;
}

/// A round of the mission is down: when it was the last one, the observer takes the next step.
void Mission::State::landed(FireMission& mission, const ShellRecord& shell) {
  // Of a volley he senses the middle of what he sees.
  if (sees(posts[static_cast<std::size_t>(mission.post)], cloudOf(shell), kCloudSight * posts[static_cast<std::size_t>(mission.post)].setup->max_range_m)) {
    mission.bursts_m = mission.bursts_m + shell.burst_m;
    ++mission.bursts;
  }
  if (mission.in_air > 0 || !mission.tasks.empty()) return;
  Post& post = posts[static_cast<std::size_t>(mission.post)];
  if (mission.target >= 0 && post.knows[static_cast<std::size_t>(mission.target)].seen) tell(mission.post, mission.target, levelDistance(post.eye_m, vehicleAt(mission.target)));
  ShellRecord middle = shell;
  if (mission.bursts > 0) middle.burst_m = (1.0 / mission.bursts) * mission.bursts_m;
  mission.bursts_m = {};
  mission.bursts = 0;
  if (!mission.effect) {
    ++mission.adjusting;
    tellMission(mission, MissionFact::State::splash);
    spot(mission, middle);
    return;
  }
  ++mission.effects;
  if (mission.method == FireMethod::illuminate) {
    // The mission lasts as long as its light, and its guns serve others meanwhile.
    this->release(mission);
    mission.until_s = shell.burst_s + kLight_s;
    mission.burning = true;
    return;
  }
  const bool lasting = mission.method == FireMethod::suppress || mission.method == FireMethod::immediate_suppression || mission.method == FireMethod::smoke;
  if (mission.until_s == 0.0) mission.until_s = mission.opened_s + post.setup->suppress_s;
  const bool gone = mission.target >= 0 && condition(mission.target) == Contact::Condition::destroyed;
  if (lasting && now_s < mission.until_s && !gone) {
    mission.waiting = true;
    return;
  }
  tellMission(mission, MissionFact::State::effect_over);
  if (!lasting && !gone) spot(mission, middle);
}

int Mission::State::enemyInSight(int vehicle, double range_m) const {
  const auto v = static_cast<std::size_t>(vehicle);
  const Vec3 eye = vehicleAt(vehicle) + Vec3{0.0, rec.vehicles[v].type.height_m, 0.0};
  double best = range_m;
  int enemy = -1;
  for (std::size_t other = 0; other < rec.vehicles.size(); ++other) {
    if (!enemies(rec.vehicles[v].type.side, rec.vehicles[other].type.side) || rec.vehicles[other].destroyedAt(now_s)) continue;
    const Vec3 place = vehicleAt(static_cast<int>(other)) + Vec3{0.0, 0.7 * rec.vehicles[other].type.height_m, 0.0};
    const double distance = levelDistance(eye, place);
    if (distance >= best || !rec.terrain.sees(eye, place)) continue;
    best = distance;
    enemy = static_cast<int>(other);
  }
  return enemy;
}

void Mission::State::shootBack() {
  for (Duel& duel : duels) {
    const VehicleRecord& vehicle = rec.vehicles[static_cast<std::size_t>(duel.vehicle)];
    if (tick < duel.next_tick || duel.rounds <= 0) continue;
    const DamageStep* harm = vehicle.damageAt(now_s);
    const Weapon* weapon = weaponOf(vehicle.type.weapon);
    if ((harm && (!harm->firepower || harm->hull >= 1.0)) || !weapon) {
      duel.rounds = 0;
      continue;
    }
    duel.next_tick = tick + static_cast<std::int64_t>(kDuelReload_s / kMissionTick_s);
    --duel.rounds;
    const int enemy = enemyInSight(duel.vehicle, weapon->range_m);
    if (enemy < 0) continue;
    shootDirect(duel.vehicle, vehicleAt(enemy) + Vec3{0.0, 0.5 * rec.vehicles[static_cast<std::size_t>(enemy)].type.height_m, 0.0}, enemy);
  }
  std::erase_if(duels, [](const Duel& duel) { return duel.rounds <= 0; });
}

/// Direct fire is a straight line (thesis); whatever ground is in the way stops it.
void Mission::State::shootDirect(int vehicle, const Vec3& at, int enemy) {
  const VehicleRecord& shooter = rec.vehicles[static_cast<std::size_t>(vehicle)];
  const Weapon* weapon = weaponOf(shooter.type.weapon);
  if (!weapon) return;
  ShellRecord shell;
  shell.number = static_cast<int>(rec.shells.size()) + 1;
  shell.shooter = vehicle;
  shell.weapon = weapon->id;
  shell.target = enemy;
  shell.muzzle_m = vehicleAt(vehicle) + Vec3{0.0, 0.8 * shooter.type.height_m, 0.0};
  const Normals n = normals(rec.scenario.seed, static_cast<std::uint32_t>(vehicle), Purpose::shot, static_cast<std::uint32_t>(shell.number));
  const double distance = std::max(1.0, length(at - shell.muzzle_m));
  const Vec3 ahead = (1.0 / distance) * (at - shell.muzzle_m), side{-ahead.z, 0.0, ahead.x};
  shell.burst_m = at + (kDuelError_rad * distance * n.a) * side + Vec3{0.0, kDuelError_rad * distance * n.b, 0.0};
  const double reach = length(shell.burst_m - shell.muzzle_m);
  if (const auto hit = rec.terrain.raycast(shell.muzzle_m, (1.0 / reach) * (shell.burst_m - shell.muzzle_m), reach)) shell.burst_m = *hit;
  shell.fired_s = now_s;
  shell.burst_s = now_s + length(shell.burst_m - shell.muzzle_m) / std::max(1.0, weapon->muzzle_velocity_mps);
  shell.seed = static_cast<std::uint64_t>(shell.number);
  log(EventKind::fire, now_s).fields = {{"shell", std::int64_t{shell.number}}, {"gun", shooter.id}, {"mission", std::int64_t{0}}, {"target", vehicleId(enemy)}, {"trajectory", std::string("direct")},
                                        {"weapon", std::int64_t{weapon->id}}, {"position", shell.muzzle_m}, {"azimuth_mil", bearing(shell.muzzle_m, shell.burst_m) * kMilsPerRadian}};
  flying.push_back({static_cast<int>(rec.shells.size()), now_s, true, 0});
  rec.shells.push_back(std::move(shell));
}

}  // namespace npsee
