#pragma once

#include <npsee/recording.h>
#include <npsee/scenario.h>

#include <vector>

namespace npsee::test {

/// A small mission on flat ground: one observer, a battery of two guns, a hostile tank that stands in his sight.
inline Scenario smallMission() {
  Scenario out;
  out.name = out.title = "small";
  out.duration_s = 120.0;
  out.world.size_x_m = out.world.size_z_m = 10000.0;
  VehicleSetup tank;
  tank.id = "t72-1";
  tank.type = 51;
  tank.at = {7000.0, 5000.0};
  out.vehicles.push_back(tank);
  BatterySetup battery;
  battery.id = "battery";
  battery.charges = {"3W"};
  battery.guns = {{"gun1", {2000.0, 4990.0}}, {"gun2", {2000.0, 5010.0}}};
  out.batteries.push_back(battery);
  ObserverSetup observer;
  observer.id = "fo1";
  observer.at = {5500.0, 5200.0};
  observer.missions = {{MissionAction::destroy, 51}};
  out.observers.push_back(observer);
  return out;
}

/// Events of a kind, in order.
inline std::vector<const MissionEvent*> eventsOf(const Recording& recording, EventKind kind) {
  std::vector<const MissionEvent*> out;
  for (const MissionEvent& event : recording.events)
    if (event.kind == kind) out.push_back(&event);
  return out;
}

}  // namespace npsee::test
