#include "sim/c/recorded.h"

#include <npsee/mission.h>

#include <algorithm>
#include <cmath>

namespace npsee::c {

npsee_status refuseIndex(const char* what, std::size_t count) { return refuse(NPSEE_USAGE, "there are " + std::to_string(count) + " " + what + ", counted from 0."); }

npsee_status refuseTime() { return refuse(NPSEE_USAGE, "the time is no finite number of seconds."); }

npsee_status event(const Recording& recording, std::size_t index, char* buffer, std::size_t capacity, std::size_t* length) {
  if (index >= recording.events.size()) return refuseIndex("events", recording.events.size());
  return copyText(eventJson(recording.events[index]), buffer, capacity, length);
}

npsee_status vehicle(const Recording& recording, std::size_t index, double t_s, npsee_vehicle* out) {
  if (index >= recording.vehicles.size()) return refuseIndex("vehicles", recording.vehicles.size());
  if (!std::isfinite(t_s)) return refuseTime();
  const double at_s = std::clamp(t_s, 0.0, recording.duration_s);
  const VehicleRecord& record = recording.vehicles[index];
  const Pose pose = record.track.at(at_s);
  *out = {record.id.c_str(), record.type.name.c_str(), {}, pose.heading_rad, pose.speed_mps, record.destroyedAt(at_s) ? 1 : 0};
  put(recording.vehiclePlace(index, at_s), out->position_m);
  return NPSEE_OK;
}

npsee_status shell(const Recording& recording, std::size_t index, double t_s, npsee_shell* out) {
  if (index >= recording.shells.size()) return refuseIndex("shells", recording.shells.size());
  if (!std::isfinite(t_s)) return refuseTime();
  const ShellRecord& record = recording.shells[index];
  const double at_s = std::clamp(t_s, record.fired_s, std::max(record.fired_s, record.burst_s));
  *out = {};
  out->number = record.number;
  out->fired_s = record.fired_s;
  out->burst_s = record.burst_s;
  put(record.burst_m, out->burst_m);
  put(record.at(at_s), out->position_m);
  put(record.velocityAt(at_s), out->velocity_mps);
  out->in_air = t_s >= record.fired_s && t_s < record.burst_s ? 1 : 0;
  return NPSEE_OK;
}

npsee_status unmet(const Recording& recording, char* buffer, std::size_t capacity, std::size_t* length) {
  std::string text;
  for (const std::string& sentence : unmetExpectations(recording)) text += sentence + '\n';
  return copyText(text, buffer, capacity, length);
}

}  // namespace npsee::c
