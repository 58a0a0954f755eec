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

}  // namespace npsee::editor
