// The C interface to missions.

#include "sim/c/recorded.h"

#include <npsee/mission.h>

#include <algorithm>
#include <cmath>

using namespace npsee;

struct npsee_scenario {
  Scenario value;
};
struct npsee_mission {
  Mission value;
  std::size_t told = 0;     ///< events handed to a callback, or passed over because there was none
  bool advancing = false;   ///< a callback must not advance
};

namespace {

/// Sets a flag for as long as it lives.
class Holding {
 public:
  explicit Holding(bool& flag) : flag_(flag) { flag_ = true; }
  ~Holding() { flag_ = false; }
  Holding(const Holding&) = delete;
  Holding& operator=(const Holding&) = delete;

 private:
  bool& flag_;
};

void tell(npsee_mission& mission, npsee_event_function on_event, void* user) {
  const auto& events = mission.value.recording().events;
  if (on_event == nullptr) {
    mission.told = events.size();
    return;
  }
  while (mission.told < events.size()) {
    // A copy: an order that the callback gives may write to the log, and so move the events.
    const MissionEvent event = events[mission.told++];
    const std::string json = eventJson(event);
    on_event(user, event.t_s, eventKindNames()[static_cast<std::size_t>(event.kind)].data(), json.c_str());
  }
}

void advance(npsee_mission& mission, double until_s, npsee_event_function on_event, void* user) {
  if (on_event == nullptr) {
    mission.value.advance(until_s);
    return tell(mission, nullptr, nullptr);
  }
  tell(mission, on_event, user);
  // Tick by tick, so that an order given in answer to an event is obeyed in the next.
  for (double next_s = mission.value.now(); !mission.value.finished() && next_s < until_s;) {
    next_s = std::min(next_s + kMissionTick_s, until_s);
    mission.value.advance(next_s);
    tell(mission, on_event, user);
  }
  mission.value.advance(until_s);
  tell(mission, on_event, user);
}

MissionCommand commandOf(const npsee_order& order) {
  MissionCommand out;
  out.t_s = order.t_s;
  out.kind = static_cast<MissionCommand::Kind>(order.kind);
  out.who = c::orEmpty(order.who);
  out.speed_mps = order.speed_mps;
  out.turn_radps = order.turn_radps;
  out.place = {order.x_m, order.z_m};
  out.target = c::orEmpty(order.target);
  out.mission = order.mission;
  out.right_m = order.right_m;
  out.add_m = order.add_m;
  return out;
}

}  // namespace

extern "C" {

npsee_status npsee_scenario_load(const char* path, npsee_scenario** scenario) {
  NPSEE_MAKES(scenario);
  NPSEE_NEEDS(path);
  return c::guarded(__func__, [&] { return c::handOver(loadScenario(path), scenario); });
}

npsee_status npsee_scenario_parse(const char* text, size_t length, const char* name, const char* folder, npsee_scenario** scenario) {
  NPSEE_MAKES(scenario);
  NPSEE_NEEDS(text);
  return c::guarded(__func__, [&] { return c::handOver(parseScenario({text, length}, c::orEmpty(name), c::orEmpty(folder)), scenario); });
}

npsee_status npsee_scenario_set(npsee_scenario* scenario, const char* setting) {
  NPSEE_NEEDS(scenario);
  NPSEE_NEEDS(setting);
  return c::guarded(__func__, [&] { return c::settle(applySetting(scenario->value, setting)); });
}

void npsee_scenario_free(npsee_scenario* scenario) { delete scenario; }

npsee_status npsee_mission_start(const npsee_scenario* scenario, npsee_mission** mission) {
  NPSEE_MAKES(mission);
  NPSEE_NEEDS(scenario);
  return c::guarded(__func__, [&] {
    if (auto faults = validate(scenario->value); !faults.empty()) return c::refuse(Error{ErrorKind::input, std::move(faults)});
    return c::handOver(Mission::make(scenario->value), mission);
  });
}

npsee_status npsee_mission_advance(npsee_mission* mission, double until_s, npsee_event_function on_event, void* user) {
  NPSEE_NEEDS(mission);
  return c::guarded(__func__, [&] {
    if (std::isnan(until_s)) return c::refuse(NPSEE_USAGE, "the time is no number of seconds.");
    if (mission->advancing) return c::refuse(NPSEE_USAGE, "a callback must not advance its mission.");
    const Holding holding(mission->advancing);
    advance(*mission, until_s, on_event, user);
    return NPSEE_OK;
  });
}

npsee_status npsee_mission_order(npsee_mission* mission, const npsee_order* order) {
  NPSEE_NEEDS(mission);
  NPSEE_NEEDS(order);
  return c::guarded(__func__, [&] {
    if (order->kind < NPSEE_DRIVE || order->kind > NPSEE_SHOOT) return c::refuse(NPSEE_USAGE, "there is no such kind of order.");
    for (const double number : {order->t_s, order->speed_mps, order->turn_radps, order->x_m, order->z_m, order->right_m, order->add_m})
      if (!std::isfinite(number)) return c::refuse(NPSEE_USAGE, "a number of the order is not finite.");
    mission->value.command(commandOf(*order));
    return NPSEE_OK;
  });
}

double npsee_mission_time_s(const npsee_mission* mission) { return mission != nullptr ? mission->value.now() : 0.0; }
int npsee_mission_finished(const npsee_mission* mission) { return mission != nullptr && mission->value.finished() ? 1 : 0; }
size_t npsee_mission_events(const npsee_mission* mission) { return mission != nullptr ? mission->value.recording().events.size() : 0; }

npsee_status npsee_mission_event(const npsee_mission* mission, size_t index, char* buffer, size_t capacity, size_t* length) {
  NPSEE_NEEDS(mission);
  return c::guarded(__func__, [&] { return c::event(mission->value.recording(), index, buffer, capacity, length); });
}

size_t npsee_mission_vehicles(const npsee_mission* mission) { return mission != nullptr ? mission->value.recording().vehicles.size() : 0; }

npsee_status npsee_mission_vehicle(const npsee_mission* mission, size_t index, double t_s, npsee_vehicle* vehicle) {
  NPSEE_NEEDS(mission);
  NPSEE_NEEDS(vehicle);
  return c::guarded(__func__, [&] { return c::vehicle(mission->value.recording(), index, t_s, vehicle); });
}

size_t npsee_mission_shells(const npsee_mission* mission) { return mission != nullptr ? mission->value.recording().shells.size() : 0; }

npsee_status npsee_mission_shell(const npsee_mission* mission, size_t index, double t_s, npsee_shell* shell) {
  NPSEE_NEEDS(mission);
  NPSEE_NEEDS(shell);
  return c::guarded(__func__, [&] { return c::shell(mission->value.recording(), index, t_s, shell); });
}

npsee_status npsee_mission_unmet(const npsee_mission* mission, char* buffer, size_t capacity, size_t* length) {
  NPSEE_NEEDS(mission);
  return c::guarded(__func__, [&] { return c::unmet(mission->value.recording(), buffer, capacity, length); });
}

npsee_status npsee_mission_save(const npsee_mission* mission, const char* path) {
  NPSEE_NEEDS(mission);
  NPSEE_NEEDS(path);
  return c::guarded(__func__, [&] {
    if (!mission->value.finished()) return c::refuse(NPSEE_USAGE, "the mission is not at its end.");
    return c::settle(saveRecording(mission->value.recording(), path));
  });
}

void npsee_mission_free(npsee_mission* mission) { delete mission; }

}
