#pragma once

#include <npsee/ballistics.h>
#include <npsee/recording.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace npsee::test {

inline Terrain terrainOf(const TerrainSource& source, double size_m, double sea_m = 0.0) {
  auto terrain = Terrain::make(source, size_m, size_m, sea_m, 1);
  EXPECT_TRUE(terrain) << (terrain ? "" : terrain.error().text());
  return terrain ? *terrain : Terrain();
}

/// A recording made by hand, so that tests of drawing need no simulated mission.
struct HandRecording {
  Recording recording;

  explicit HandRecording(const Terrain& terrain) {
    recording.terrain = terrain;
    recording.duration_s = 120.0;
    recording.scenario.world.weather.visibility_m = 30000.0;
  }

  int vehicle(double x, double z, Side side, TargetClass target_class = TargetClass::heavy_armor, double heading_rad = 0.0, double speed_mps = 0.0) {
    VehicleRecord record;
    record.id = "v" + std::to_string(recording.vehicles.size());
    record.type.side = side;
    record.type.target_class = target_class;
    Leg leg;
    leg.x_m = x;
    leg.z_m = z;
    leg.heading_rad = heading_rad;
    leg.speed_mps = speed_mps;
    record.track.legs.push_back(leg);
    record.track.index.assign(64, 0);
    recording.vehicles.push_back(record);
    return static_cast<int>(recording.vehicles.size()) - 1;
  }

  int observer(double x, double z) {
    const int carrier = vehicle(x, z, Side::friendly, TargetClass::light_armor);
    recording.vehicles[static_cast<std::size_t>(carrier)].type.model = "m577";
    ObserverRecord record;
    record.id = "fo" + std::to_string(recording.observers.size() + 1);
    record.vehicle = carrier;
    recording.observers.push_back(record);
    return static_cast<int>(recording.observers.size()) - 1;
  }

  /// A gun and `shots` shells from it, `every_s` apart, that fly a parabola to the place.
  int gun(double x, double z, double azimuth_rad, double elevation_rad) {
    GunRecord record;
    record.id = "gun" + std::to_string(recording.guns.size() + 1);
    record.muzzle_m = {x, recording.terrain.surface(x, z) + 2.0, z};
    record.lays.push_back({0.0, 0.0, azimuth_rad, elevation_rad});
    recording.guns.push_back(record);
    return static_cast<int>(recording.guns.size()) - 1;
  }

  /// Flown in vacuum, which is enough to look at.
  void fire(int gun, double at_s, double speed_mps, const std::string& preset) {
    const GunRecord& from = recording.guns[static_cast<std::size_t>(gun)];
    const auto [azimuth, elevation] = from.lineAt(at_s);
    Conditions conditions;
    conditions.ground = std::make_shared<const Terrain>(recording.terrain);
    const auto projectile = findProjectile("m107");
    auto ballistics = Ballistics::make(projectile ? *projectile : Projectile{}, conditions, FlightModel::vacuum);
    ShellRecord shell;
    shell.number = static_cast<int>(recording.shells.size()) + 1;
    shell.gun = gun;
    shell.fired_s = at_s;
    shell.muzzle_m = from.muzzle_m;
    shell.preset = preset;
    shell.seed = static_cast<std::uint64_t>(shell.number) * 77u;
    Shot shot;
    shot.speed_mps = speed_mps;
    shot.azimuth_rad = azimuth;
    shot.elevation_rad = elevation;
    shot.muzzle_m = from.muzzle_m;
    if (ballistics) {
      shell.path = ballistics->path(shot);
      shell.burst_s = at_s + shell.path.flight().time_of_flight_s;
      shell.burst_m = shell.path.inWorld(shell.path.flight().time_of_flight_s).position_m;
      shell.burst_m.y = recording.terrain.surface(shell.burst_m.x, shell.burst_m.z);
    } else {
      ADD_FAILURE() << ballistics.error().text();
    }
    add(shell);
  }

  /// In order of firing, as recordings keep them.
  void add(const ShellRecord& shell) {
    auto& shells = recording.shells;
    shells.insert(std::upper_bound(shells.begin(), shells.end(), shell, [](const ShellRecord& a, const ShellRecord& b) { return a.fired_s < b.fired_s; }), shell);
  }

  /// A burst without a flight.
  void burst(const Vec3& at, double at_s, const std::string& preset) {
    ShellRecord shell;
    shell.number = static_cast<int>(recording.shells.size()) + 1;
    shell.fired_s = at_s - 1.0;
    shell.burst_s = at_s;
    shell.burst_m = at;
    shell.muzzle_m = at + Vec3{0.0, 300.0, 300.0};
    shell.preset = preset;
    shell.seed = static_cast<std::uint64_t>(shell.number);
    add(shell);
  }
};

}  // namespace npsee::test
