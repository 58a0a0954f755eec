#pragma once

#include "sim/world/vehicles.h"
#include "tests/world/terrain_support.h"

#include <cmath>
#include <string>
#include <vector>

namespace npsee::test {

/// Heading towards the east, rad.
inline constexpr double kEast = 0.5 * kPi;

/// Vehicles on a terrain, without guns or observers.
class Convoy {
 public:
  Convoy(Scenario scenario, Terrain terrain) : scenario_(std::move(scenario)), terrain_(std::move(terrain)), vehicles_(made()) {}
  Convoy(const Convoy&) = delete;
  Convoy& operator=(const Convoy&) = delete;

  /// On to a time; calls `each` after every whole second.
  template <class Each>
  void runTo(double until_s, const Each& each) {
    for (const auto end = static_cast<std::int64_t>(until_s / kMissionTick_s + 0.5); next_ <= end; ++next_) {
      vehicles_.step(next_);
      if (next_ % 20 == 0) each(static_cast<double>(next_) * kMissionTick_s);
    }
  }
  void runTo(double until_s) {
    runTo(until_s, [](double) {});
  }

  world::Vehicles& vehicles() { return vehicles_; }
  const Terrain& terrain() const { return terrain_; }
  const std::vector<VehicleRecord>& records() const { return records_; }
  std::int64_t nextTick() const { return next_; }
  double now() const { return static_cast<double>(next_ - 1) * kMissionTick_s; }
  Pose pose(std::size_t v) const { return records_[v].track.at(now()); }
  double distanceTo(std::size_t v, const Place& place) const { return std::hypot(pose(v).x_m - place.x_m, pose(v).z_m - place.z_m); }

 private:
  world::Vehicles made() {
    auto vehicles = world::Vehicles::make(scenario_, terrain_, records_);
    EXPECT_TRUE(vehicles) << (vehicles ? "" : vehicles.error().text());
    if (!vehicles) std::abort();
    return std::move(*vehicles);
  }
  Scenario scenario_;
  Terrain terrain_;
  std::vector<VehicleRecord> records_;
  world::Vehicles vehicles_;
  std::int64_t next_ = 0;
};

inline VehicleSetup vehicle(const std::string& id, const Place& at, Behaviour behaviour, double speed_mps = 8.0, double heading_rad = 0.0) {
  VehicleSetup setup;
  setup.id = id;
  setup.type = 51;
  setup.at = at;
  setup.behaviour = behaviour;
  setup.speed_mps = speed_mps;
  setup.heading_rad = heading_rad;
  return setup;
}

inline Scenario scenarioOf(std::vector<VehicleSetup> vehicles, double size_m = 10000.0) {
  Scenario scenario;
  scenario.world.size_x_m = scenario.world.size_z_m = size_m;
  scenario.vehicles = std::move(vehicles);
  return scenario;
}

inline Terrain flatTerrain(double size_m = 10000.0, double height_m = 10.0) {
  TerrainSource source;
  source.height_m = height_m;
  return terrain(source, size_m, size_m);
}

}  // namespace npsee::test
