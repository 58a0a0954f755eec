#pragma once

#include "sim/observer/fire_direction.h"

#include <npsee/recording.h>
#include <npsee/units.h>
#include <npsee/weapons.h>

#include <algorithm>
#include <stdexcept>

namespace npsee::test {

template <class T>
T must(Expected<T> value) {
  if (!value) throw std::runtime_error(value.error().text());
  return std::move(*value);
}

/// The mission that `recorded` plays, as a file would have it.
inline Scenario recordedScenario() {
  Scenario s;
  s.name = "recorded";
  s.title = "A battery, a column, a \"name\"";
  s.duration_s = 120.0;
  s.world.size_x_m = s.world.size_z_m = 12000.0;
  s.world.terrain.kind = TerrainKind::function;
  s.world.terrain.expression = "plane";
  s.world.terrain.params = {{"height", 50.0}, {"slope_x", 0.01}};
  s.world.weather.wind_mps = {4.0, 0.0, -2.0};
  BatterySetup battery;
  battery.id = "alpha";
  battery.pe_range_m = 15.0;
  battery.pe_deflection_m = 4.0;
  battery.guns = {{"gun1", {3000.0, 6000.0}}, {"gun2", {3000.0, 6100.0}}};
  s.batteries = {battery};
  VehicleSetup tank;
  tank.id = "t72-1";
  tank.type = 51;
  tank.at = {8000.0, 6000.0};
  VehicleSetup carrier = tank;
  carrier.id = "m577-1";
  carrier.type = 8;
  carrier.at = {9500.0, 6000.0};
  s.vehicles = {tank, carrier};
  return s;
}

/// A recording made by hand: shells flown by the real fire direction, a tank that drives, turns, stops and is destroyed, one direct
/// shot, beliefs, and events of several kinds.
inline Recording recorded() {
  Recording r;
  r.scenario = recordedScenario();
  const WorldSetup& w = r.scenario.world;
  r.terrain = must(Terrain::make(w.terrain, w.size_x_m, w.size_z_m, w.sea_level_m));
  for (const VehicleSetup& setup : r.scenario.vehicles) {
    VehicleRecord vehicle;
    vehicle.id = setup.id;
    for (const VehicleType& type : vehicleTypes(r.scenario))
      if (type.index == setup.type) vehicle.type = type;
    vehicle.track.add({0.0, setup.at.x_m, setup.at.z_m, 1.0, 0.0, 0.0, 0.0});
    r.vehicles.push_back(vehicle);
  }
  r.vehicles[0].track.add({5.0, 8000.0, 6000.0, 1.0, 0.0, 1.0, 0.0});
  const Pose turn = r.vehicles[0].track.at(11.25);
  r.vehicles[0].track.add({11.25, turn.x_m, turn.z_m, turn.heading_rad, turn.speed_mps, 0.0, 0.2});
  const Pose stop = r.vehicles[0].track.at(30.0);
  r.vehicles[0].track.add({30.0, stop.x_m, stop.z_m, stop.heading_rad, 0.0, 0.0, 0.0});
  r.vehicles[0].damage = {{31.7, 0.4, false, true}, {55.1, 1.0, false, false}};

  const Weapons weapons = must(parseWeapons("I 155mmM109Howitzer 110\nD 7300 297.0 100 150 200 1 1\n", "weapons"));
  const auto fdc = must(observer::FireDirection::make(r.scenario.batteries[0], weapons.list[0], r.terrain, w.weather, r.scenario.fdc));
  for (int g = 0; g < 2; ++g) {
    const Place at = r.scenario.batteries[0].guns[static_cast<std::size_t>(g)].at;
    GunRecord gun;
    gun.id = r.scenario.batteries[0].guns[static_cast<std::size_t>(g)].id;
    gun.muzzle_m = {at.x_m, r.terrain.surface(at.x_m, at.z_m) + 2.0, at.z_m};
    gun.lays = {{0.0, 0.0, 1.5, 0.0}};
    for (int k = 0; k < 3; ++k) {
      observer::FireRequest request;
      request.muzzle_m = gun.muzzle_m;
      request.target_m = {8000.0 + 40.0 * k, 0.0, 6000.0};
      request.trajectory = k == 2 ? TrajectoryChoice::high : TrajectoryChoice::automatic;
      const observer::FireSolution solution = fdc.solve(request);
      if (solution.refusal != observer::Refusal::none) throw std::runtime_error(solution.reason);
      ShellRecord shell;
      shell.gun = g;
      shell.weapon = 110;
      shell.mission = 1;
      shell.target = 0;
      shell.fired_s = 10.0 + 15.0 * k + 0.05 * g;
      shell.path = fdc.fly(solution, 0.7 * k - 0.3, 0.2 * g);
      shell.burst_s = shell.fired_s + shell.path.flight().time_of_flight_s;
      shell.burst_m = shell.path.inWorld(shell.path.flight().time_of_flight_s).position_m;
      shell.muzzle_m = gun.muzzle_m;
      shell.preset = "air_burst";
      shell.seed = 0xfedcba9876543210ull + static_cast<std::uint64_t>(k);
      shell.smoke = k == 1;
      gun.lays.push_back({shell.fired_s - 6.0, shell.fired_s - 1.0, solution.shot.azimuth_rad, solution.shot.elevation_rad});
      r.shells.push_back(shell);
    }
    r.guns.push_back(gun);
  }
  ShellRecord direct;
  direct.shooter = 0;
  direct.weapon = 112;
  direct.target = 1;
  direct.fired_s = 50.0;
  direct.burst_s = 51.5;
  direct.muzzle_m = r.vehiclePlace(0, 50.0);
  direct.burst_m = r.vehiclePlace(1, 50.0);
  r.shells.push_back(direct);
  std::ranges::stable_sort(r.shells, {}, &ShellRecord::fired_s);
  for (std::size_t i = 0; i < r.shells.size(); ++i) r.shells[i].number = static_cast<int>(i) + 1;

  r.observers.push_back({"fo1", 1, 2.5, {{3.0, 0, true, {8010.0, 130.0, 5990.0}, 0.8, 0.1, 0}, {12.0, 0, true, {8005.0, 130.0, 5995.0}, 0.9, 0.05, 1}}});
  r.events.push_back({3.0, EventKind::contact, {{"observer", std::string("fo1")}, {"target", std::string("t72-1")}, {"type", std::string("T-72, the \"tank\"")}, {"position", Vec3{8010.0, 130.0, 5990.0}}, {"range_m", 1490.123456789}, {"belief", 0.8}}});
  r.events.push_back({5.0, EventKind::call, {{"observer", std::string("fo1")}, {"mission", std::int64_t{1}}, {"target", std::string("t72-1")}, {"method", std::string("adjust_fire")}, {"facts", std::vector<std::string>{"(contact (id 0))", "(order)"}}, {"danger_close", false}}});
  r.events.push_back({9.0, EventKind::warning, {{"text", std::string("five ") + "and a half, too"}, {"figure", 5.0}, {"none", std::vector<std::string>{}}}});
  r.events.push_back({55.1, EventKind::destroyed, {{"target", std::string("t72-1")}, {"shell", std::int64_t{3}}, {"miss_m", 7.25}}});
  r.events.push_back({60.0, EventKind::end_of_mission, {{"observer", std::string("fo1")}, {"mission", std::int64_t{1}}, {"reason", std::string("destroyed, all of it")}}});
  r.events.push_back({120.0, EventKind::end, {{"hash", std::string("0123456789abcdef")}}});
  r.duration_s = 120.0;
  r.finished = true;
  r.hash = "0123456789abcdef";
  return r;
}

}  // namespace npsee::test
