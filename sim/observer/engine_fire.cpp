#include "sim/observer/engine.h"

#include <algorithm>
#include <cmath>

namespace npsee {

using namespace observer;

namespace {

std::string_view trajectoryName(bool high) { return high ? "high" : "low"; }

/// Angle T between the observer-target and the gun-target line, 0..3200 mil.
double angleT(const Vec3& observer, const Vec3& gun, const Vec3& target) {
  const double a = std::fabs(bearing(observer, target) - bearing(gun, target));
  return std::min(a, kTwoPi - a) * kMilsPerRadian;
}

}  // namespace

/// The fire direction centre: every mission that waits gets a battery, solutions and orders to its guns.
void Mission::State::direct() {
  for (std::size_t m = 0; m < missions.size(); ++m) {
    if (missions[m].waiting && !missions[m].over) prepare(missions[m]);
    if (!missions[m].burning || missions[m].over || now_s < missions[m].until_s) continue;
    missions[m].burning = false;
    tellMission(missions[m], MissionFact::State::effect_over);
  }
}

/// The observer-target line, in whose frame he corrects.
void Mission::State::lookAlong(FireMission& mission) const {
  const Vec3& eye = posts[static_cast<std::size_t>(mission.post)].eye_m;
  const double distance = levelDistance(eye, mission.target_m);
  if (distance <= 1.0) return;
  mission.ot_distance_m = distance;
  mission.ot = {(mission.target_m.x - eye.x) / distance, 0.0, (mission.target_m.z - eye.z) / distance};
}

/// Moves the aim with the target as the observer believes it; the thesis lays again on its absolute place and forgets corrections.
void Mission::State::follow(FireMission& mission) {
  const Post& post = posts[static_cast<std::size_t>(mission.post)];
  if (mission.target >= 0) {
    const Acquaintance& a = post.knows[static_cast<std::size_t>(mission.target)];
    if (a.seen) {
      mission.target_m = vehicleAt(mission.target) + a.error_m;
      lookAlong(mission);
    }
  }
  mission.aim_m = rec.scenario.fdc.absolute_relay ? mission.target_m : mission.target_m + mission.correction_m;
  const double edge_x = rec.scenario.world.size_x_m, edge_z = rec.scenario.world.size_z_m;
  mission.aim_m.x = std::clamp(mission.aim_m.x, 0.0, edge_x);
  mission.aim_m.z = std::clamp(mission.aim_m.z, 0.0, edge_z);
  mission.aim_m.y = rec.terrain.surface(mission.aim_m.x, mission.aim_m.z);
}

void Mission::State::prepare(FireMission& mission) {
  follow(mission);
  if (mission.battery < 0) {
    if (!assign(mission)) return;
  } else if (solveAll(mission, batteries[static_cast<std::size_t>(mission.battery)]) == 0) {
    mission.waiting = false;
    release(mission);
    tellMission(mission, MissionFact::State::refused, "no gun can reach the place any more");
    return;
  }
  mission.waiting = false;
  if (mission.effect) tellMission(mission, MissionFact::State::effect);
}

/// Gives the mission to the first free battery with a solution. False: it waits for a busy one, or all have refused.
bool Mission::State::assign(FireMission& mission) {
  const Post& post = posts[static_cast<std::size_t>(mission.post)];
  bool busy = false;
  for (const int b : post.batteries) busy = busy || batteries[static_cast<std::size_t>(b)].mission != 0;
  for (const int b : post.batteries) {
    Battery& battery = batteries[static_cast<std::size_t>(b)];
    if (battery.mission != 0) continue;
    mission.battery = b;
    if (solveAll(mission, battery) > 0) {
      battery.mission = mission.number;
      return true;
    }
    mission.battery = -1;
  }
  if (busy) return false;
  mission.waiting = false;
  tellMission(mission, MissionFact::State::refused, post.batteries.empty() ? "there is no battery" : "no battery can fire at the place");
  if (post.human) endMission(mission, "refused", "No battery can fire at the place.", nullptr);
  return false;
}

/// Solutions for the guns that take part: one while adjusting, all for effect. Returns how many there are.
int Mission::State::solveAll(FireMission& mission, Battery& battery) {
  int solved = 0;
  for (int piece = 0; piece < static_cast<int>(battery.pieces.size()); ++piece) {
    if (solveFor(mission, battery, piece)) ++solved;
    if (solved > 0 && !mission.effect) break;
  }
  return solved;
}

bool Mission::State::solveFor(FireMission& mission, Battery& battery, int piece) {
  Piece& p = battery.pieces[static_cast<std::size_t>(piece)];
  const auto told = std::find(mission.refused_guns.begin(), mission.refused_guns.end(), p.index) != mission.refused_guns.end();
  if (p.gun.empty()) {
    if (!told) {
      mission.refused_guns.push_back(p.index);
      log(EventKind::refuse, now_s).fields = {{"mission", std::int64_t{mission.number}}, {"battery", battery.setup->id}, {"gun", rec.guns[static_cast<std::size_t>(p.index)].id}, {"target", vehicleId(mission.target)},
                                              {"reason", std::string("no_ammunition")}, {"text", "Gun " + rec.guns[static_cast<std::size_t>(p.index)].id + " has no rounds left."}};
    }
    return false;
  }
  FireRequest request;
  request.muzzle_m = p.gun.muzzle();
  request.target_m = mission.aim_m;
  request.trajectory = rec.scenario.fdc.trajectory;
  if (mission.target >= 0 && !rec.vehicles[static_cast<std::size_t>(mission.target)].destroyedAt(now_s) && posts[static_cast<std::size_t>(mission.post)].knows[static_cast<std::size_t>(mission.target)].seen)
    request.target_velocity_mps = vehicles->velocity(static_cast<std::size_t>(mission.target));
  request.delay_s = std::max(battery.setup->lay_time_s, p.gun.readyAt(now_s) - now_s);
  request.illumination = mission.method == FireMethod::illuminate;
  request.burst_height_m = request.illumination ? kLightHeight_m : 0.0;
  const FireSolution solution = battery.fdc ? battery.fdc->solve(request) : solveLine(battery, request);
  // Each gun tells once in a mission what it tried in vain; every solution repeats it under `rejected`.
  const bool tried = std::find(mission.tried_guns.begin(), mission.tried_guns.end(), p.index) != mission.tried_guns.end();
  if (!solution.rejected.empty() && !tried) mission.tried_guns.push_back(p.index);
  if (!told && !tried)
    for (const FireSolution::Rejected& rejected : solution.rejected) logRefusal(mission, battery, piece, rejected.high, rejected.refusal, rejected.elevation_rad, rejected.reason);
  if (solution.refusal != Refusal::none) {
    if (!told) {
      mission.refused_guns.push_back(p.index);
      // A trajectory tried in vain has been told; the gun's own refusal is told where nothing was tried.
      if (solution.rejected.empty()) logRefusal(mission, battery, piece, solution.high, solution.refusal, solution.shot.elevation_rad, solution.reason);
    }
    return false;
  }
  layGun(mission, battery, piece, solution);
  return true;
}

void Mission::State::logRefusal(const FireMission& mission, const Battery& battery, int piece, bool high, Refusal refusal, double elevation_rad, const std::string& reason) {
  MissionEvent& event = log(EventKind::refuse, now_s);
  event.fields = {{"mission", std::int64_t{mission.number}}, {"battery", battery.setup->id}, {"gun", rec.guns[static_cast<std::size_t>(battery.pieces[static_cast<std::size_t>(piece)].index)].id}, {"target", vehicleId(mission.target)}};
  if (elevation_rad > 0.0) {
    event.fields.push_back({"trajectory", std::string(trajectoryName(high))});
    event.fields.push_back({"qe_mil", elevation_rad * kMilsPerRadian});
  }
  event.fields.push_back({"reason", std::string(refusalWord(refusal))});
  event.fields.push_back({"text", reason});
}

void Mission::State::logSolution(const FireMission& mission, const Battery& battery, int piece, const FireSolution& solution) {
  const GunRecord& gun = rec.guns[static_cast<std::size_t>(battery.pieces[static_cast<std::size_t>(piece)].index)];
  const double angle_t = angleT(posts[static_cast<std::size_t>(mission.post)].eye_m, gun.muzzle_m, mission.target_m);
  MissionEvent& event = log(EventKind::solution, now_s);
  event.fields = {{"mission", std::int64_t{mission.number}}, {"battery", battery.setup->id}, {"gun", gun.id}, {"target", vehicleId(mission.target)},
                  {"trajectory", std::string(battery.fdc ? trajectoryName(solution.high) : "direct")}, {"charge", battery.fdc ? battery.fdc->charges()[static_cast<std::size_t>(solution.charge)].name : std::string("-")},
                  {"qe_mil", solution.elevation_mil()}, {"azimuth_mil", solution.azimuth_mil()}, {"tof_s", solution.time_of_flight_s}, {"apex_m", solution.apex_m},
                  {"range_m", levelDistance(gun.muzzle_m, solution.aim_m)}, {"aim", solution.aim_m}, {"angle_t_mil", angle_t}};
  if (angle_t >= 500.0) event.fields.push_back({"large_angle_t", true});
  if (solution.masked) event.fields.push_back({"masked", true});
  if (solution.doubts != doubt_none) {
    std::vector<std::string> doubts;
    if (solution.doubts & doubt_elevation) doubts.push_back("elevation beyond the trajectory model's validity");
    if (solution.doubts & doubt_yaw) doubts.push_back("yaw of repose clamped");
    if (solution.doubts & doubt_mach) doubts.push_back("faster than the drag table reaches");
    event.fields.push_back({"doubt", std::move(doubts)});
  }
  if (!solution.rejected.empty()) {
    std::vector<std::string> rejected;
    for (const FireSolution::Rejected& one : solution.rejected) rejected.push_back(one.reason);
    event.fields.push_back({"rejected", std::move(rejected)});
  }
}

void Mission::State::layGun(FireMission& mission, Battery& battery, int piece, const FireSolution& solution) {
  Piece& p = battery.pieces[static_cast<std::size_t>(piece)];
  logSolution(mission, battery, piece, solution);
  if (solution.masked)
    log(EventKind::warning, now_s).fields = {{"mission", std::int64_t{mission.number}}, {"gun", rec.guns[static_cast<std::size_t>(p.index)].id}, {"text", solution.reason}};
  Task task{.piece = piece, .solution = solution};
  const auto draws = uniforms(rec.scenario.seed, static_cast<std::uint32_t>(p.index), Purpose::lay_error, battery.lays++);
  if (draws[0] < rec.scenario.fdc.lay_error) task.lay_error_rad = (draws[1] < 0.5 ? -1.0 : 1.0) * (draws[2] < 0.8 ? 10.0 : 100.0) / kMilsPerRadian;
  const double laid = p.gun.lay(now_s, solution.shot.azimuth_rad + task.lay_error_rad, solution.shot.elevation_rad, rec.guns[static_cast<std::size_t>(p.index)].lays);
  task.fire_s = p.gun.readyAt(laid);
  task.rounds = mission.effect && mission.method != FireMethod::illuminate ? std::max(1, battery.setup->volley_rounds) : 1;
  mission.tasks.push_back(std::move(task));
}

void Mission::State::fireGuns() {
  for (std::size_t m = 0; m < missions.size(); ++m) {
    FireMission& mission = missions[m];
    if (mission.over || mission.tasks.empty()) continue;
    Battery& battery = batteries[static_cast<std::size_t>(mission.battery)];
    for (Task& task : mission.tasks)
      if (task.rounds > 0 && now_s + 1e-9 >= task.fire_s) fire(mission, battery, task);
    std::erase_if(mission.tasks, [](const Task& task) { return task.rounds == 0; });
  }
}

void Mission::State::fire(FireMission& mission, Battery& battery, Task& task) {
  Piece& p = battery.pieces[static_cast<std::size_t>(task.piece)];
  const GunRecord& gun = rec.guns[static_cast<std::size_t>(p.index)];
  const Normals off = normals(rec.scenario.seed, static_cast<std::uint32_t>(p.index), Purpose::dispersion, battery.shots++);
  ShellRecord shell;
  if (battery.fdc) {
    shell.path = battery.fdc->fly(task.solution, off.a, off.b, task.lay_error_rad);
    const Flight& flight = shell.path.flight();
    shell.muzzle_m = gun.muzzle_m;
    // Light bursts where its flight passes over the place, not where it would come down.
    const double fused_s = mission.method == FireMethod::illuminate ? std::min(task.solution.time_of_flight_s, flight.time_of_flight_s) : flight.time_of_flight_s;
    shell.burst_s = now_s + fused_s;
    shell.burst_m = shell.path.inWorld(fused_s).position_m;
  } else {
    shell = flyLine(battery, task.solution, off.a, off.b);
  }
  p.gun.fired(now_s);
  --task.rounds;
  task.fire_s = p.gun.readyAt(now_s);
  if (battery.fdc && shell.path.flight().end != FlightEnd::impact) {
    log(EventKind::warning, now_s).fields = {{"mission", std::int64_t{mission.number}}, {"gun", gun.id}, {"text", "The shell of gun " + gun.id + " never comes down in this world; it is not followed."}};
    return;
  }
  shell.gun = p.index;
  launch(mission, battery, task, std::move(shell));
}

/// A shell is on its way: it gets its number, its line in the log, and is followed until it bursts.
void Mission::State::launch(FireMission& mission, Battery& battery, const Task& task, ShellRecord shell) {
  const GunRecord& gun = rec.guns[static_cast<std::size_t>(shell.gun)];
  shell.number = static_cast<int>(rec.shells.size()) + 1;
  shell.weapon = battery.weapon->id;
  shell.mission = mission.number;
  shell.target = mission.target;
  shell.fired_s = now_s;
  shell.preset = battery.setup->preset;
  shell.seed = (static_cast<std::uint64_t>(rec.scenario.seed) * 1000003u + static_cast<std::uint64_t>(shell.number)) & ((1ull << 53) - 1);
  shell.illumination = mission.method == FireMethod::illuminate;
  shell.smoke = mission.method == FireMethod::smoke;
  ++mission.fired;
  ++mission.in_air;
  log(EventKind::fire, now_s).fields = {{"shell", std::int64_t{shell.number}}, {"gun", gun.id}, {"mission", std::int64_t{mission.number}}, {"target", vehicleId(mission.target)},
                                        {"trajectory", std::string(battery.fdc ? trajectoryName(task.solution.high) : "direct")}, {"weapon", std::int64_t{shell.weapon}}, {"position", shell.muzzle_m},
                                        {"qe_mil", task.solution.elevation_mil()}, {"azimuth_mil", (task.solution.shot.azimuth_rad + task.lay_error_rad) * kMilsPerRadian},
                                        {"rounds_left", std::int64_t{battery.pieces[static_cast<std::size_t>(task.piece)].gun.rounds()}}};
  if (task.lay_error_rad != 0.0) rec.events.back().fields.push_back({"lay_error_mil", task.lay_error_rad * kMilsPerRadian});
  const double apex_s = shell.path.nodes().empty() ? now_s : now_s + shell.path.flight().apex_time_s;
  flying.push_back({static_cast<int>(rec.shells.size()), apex_s, shell.path.nodes().empty(), mission.number});
  rec.shells.push_back(std::move(shell));
}

void Mission::State::release(FireMission& mission) {
  mission.tasks.clear();
  mission.waiting = false;
  if (mission.battery < 0) return;
  Battery& battery = batteries[static_cast<std::size_t>(mission.battery)];
  if (battery.mission == mission.number) battery.mission = 0;
}

}  // namespace npsee
