#include "editor/mission/clock.h"

#include <npsee/scenario.h>

#include <algorithm>
#include <cmath>

namespace npsee::editor {

std::optional<std::size_t> MissionClock::advance(double elapsed_s, double limit_s, const std::vector<MissionEvent>& events) {
  if (!playing) return std::nullopt;
  const double end = std::min(duration_s, std::max(limit_s, time_s));
  const double to = std::min(time_s + elapsed_s * speed, end);
  for (std::size_t i = eventsUntil(events, time_s); i < events.size() && events[i].t_s <= to; ++i) {
    if (!pause_at[static_cast<std::size_t>(events[i].kind)]) continue;
    time_s = events[i].t_s;
    playing = false;
    return i;
  }
  time_s = to;
  if (time_s >= duration_s) playing = false;
  return std::nullopt;
}

void MissionClock::toggle() {
  playing = !playing;
  if (playing && time_s >= duration_s) time_s = 0.0;
}

void MissionClock::step(int ticks) {
  playing = false;
  // From an integer count of ticks, so that steps to and fro meet the same moments.
  seek((std::round(time_s / kMissionTick_s) + ticks) * kMissionTick_s);
}

void MissionClock::seek(double to_s) { time_s = std::clamp(to_s, 0.0, std::max(0.0, duration_s)); }

bool MissionClock::seekEvent(int direction, const std::vector<MissionEvent>& events) {
  const auto to = [&](const MissionEvent& event) {
    playing = false;
    seek(event.t_s);
    return true;
  };
  if (direction > 0) {
    for (const MissionEvent& event : events)
      if (event.t_s > time_s && marked(event.kind)) return to(event);
    return false;
  }
  for (auto event = events.rbegin(); event != events.rend(); ++event)
    if (event->t_s < time_s && marked(event->kind)) return to(*event);
  return false;
}

void MissionClock::changeSpeed(int by) {
  const auto at = std::ranges::lower_bound(kSpeeds, speed);
  const auto index = std::clamp<std::ptrdiff_t>((at == kSpeeds.end() ? static_cast<std::ptrdiff_t>(kSpeeds.size()) - 1 : at - kSpeeds.begin()) + by, 0, static_cast<std::ptrdiff_t>(kSpeeds.size()) - 1);
  speed = kSpeeds[static_cast<std::size_t>(index)];
}

void MissionClock::setDuration(double duration) {
  duration_s = std::max(0.0, duration);
  seek(time_s);
}

}  // namespace npsee::editor
