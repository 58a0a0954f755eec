// The C interface to recorded missions.

#include "sim/c/recorded.h"

#include <algorithm>
#include <cmath>

using namespace npsee;

struct npsee_recording {
  Recording value;
};

extern "C" {

npsee_status npsee_recording_open(const char* path, npsee_recording** recording) {
  NPSEE_MAKES(recording);
  NPSEE_NEEDS(path);
  return c::guarded(__func__, [&] { return c::handOver(loadRecording(path), recording); });
}

double npsee_recording_duration_s(const npsee_recording* recording) { return recording != nullptr ? recording->value.duration_s : 0.0; }
const char* npsee_recording_hash(const npsee_recording* recording) { return recording != nullptr ? recording->value.hash.c_str() : ""; }
size_t npsee_recording_events(const npsee_recording* recording) { return recording != nullptr ? recording->value.events.size() : 0; }

npsee_status npsee_recording_event(const npsee_recording* recording, size_t index, char* buffer, size_t capacity, size_t* length) {
  NPSEE_NEEDS(recording);
  return c::guarded(__func__, [&] { return c::event(recording->value, index, buffer, capacity, length); });
}

npsee_status npsee_recording_event_kind(const npsee_recording* recording, size_t index, double* t_s, const char** kind) {
  NPSEE_NEEDS(recording);
  return c::guarded(__func__, [&] {
    const auto& events = recording->value.events;
    if (index >= events.size()) return c::refuseIndex("events", events.size());
    if (t_s != nullptr) *t_s = events[index].t_s;
    if (kind != nullptr) *kind = eventKindNames()[static_cast<std::size_t>(events[index].kind)].data();
    return NPSEE_OK;
  });
}

npsee_status npsee_recording_seek(const npsee_recording* recording, double t_s, size_t* index) {
  NPSEE_NEEDS(recording);
  NPSEE_NEEDS(index);
  return c::guarded(__func__, [&] {
    if (std::isnan(t_s)) return c::refuseTime();
    const auto& events = recording->value.events;
    const auto first = std::partition_point(events.begin(), events.end(), [&](const MissionEvent& event) { return event.t_s < t_s; });
    *index = static_cast<std::size_t>(first - events.begin());
    return NPSEE_OK;
  });
}

size_t npsee_recording_vehicles(const npsee_recording* recording) { return recording != nullptr ? recording->value.vehicles.size() : 0; }

npsee_status npsee_recording_vehicle(const npsee_recording* recording, size_t index, double t_s, npsee_vehicle* vehicle) {
  NPSEE_NEEDS(recording);
  NPSEE_NEEDS(vehicle);
  return c::guarded(__func__, [&] { return c::vehicle(recording->value, index, t_s, vehicle); });
}

size_t npsee_recording_shells(const npsee_recording* recording) { return recording != nullptr ? recording->value.shells.size() : 0; }

npsee_status npsee_recording_shell(const npsee_recording* recording, size_t index, double t_s, npsee_shell* shell) {
  NPSEE_NEEDS(recording);
  NPSEE_NEEDS(shell);
  return c::guarded(__func__, [&] { return c::shell(recording->value, index, t_s, shell); });
}

npsee_status npsee_recording_burst(const npsee_recording* recording, size_t index, const char** preset, uint64_t* seed) {
  NPSEE_NEEDS(recording);
  return c::guarded(__func__, [&] {
    const auto& shells = recording->value.shells;
    if (index >= shells.size()) return c::refuseIndex("shells", shells.size());
    if (preset != nullptr) *preset = shells[index].preset.c_str();
    if (seed != nullptr) *seed = shells[index].seed;
    return NPSEE_OK;
  });
}

npsee_status npsee_recording_height(const npsee_recording* recording, double x_m, double z_m, double* height_m) {
  NPSEE_NEEDS(recording);
  NPSEE_NEEDS(height_m);
  return c::guarded(__func__, [&] {
    if (!std::isfinite(x_m) || !std::isfinite(z_m)) return c::refuse(NPSEE_USAGE, "the place is not finite.");
    *height_m = recording->value.terrain.height(x_m, z_m);
    return NPSEE_OK;
  });
}

npsee_status npsee_recording_unmet(const npsee_recording* recording, char* buffer, size_t capacity, size_t* length) {
  NPSEE_NEEDS(recording);
  return c::guarded(__func__, [&] { return c::unmet(recording->value, buffer, capacity, length); });
}

void npsee_recording_free(npsee_recording* recording) { delete recording; }

}
