#include "editor/document/time_line.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {

void TimeLine::toggle() {
  playing = !playing;
  if (playing && time_s >= duration_s) time_s = 0.0;
}

void TimeLine::step(int steps) {
  playing = false;
  // From an integer count of steps, so that steps to and fro meet the same moments.
  seek((std::round(time_s / grid_s_) + steps) * grid_s_);
}

void TimeLine::seek(double to_s) { time_s = std::clamp(to_s, 0.0, std::max(0.0, duration_s)); }

void TimeLine::changeSpeed(int by) {
  const auto last = static_cast<std::ptrdiff_t>(speeds_.size()) - 1;
  const auto now = std::min(std::ranges::lower_bound(speeds_, speed) - speeds_.begin(), last);
  speed = speeds_[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(now + by, 0, last))];
}

void TimeLine::setDuration(double duration) {
  duration_s = std::max(0.0, duration);
  seek(time_s);
}

}  // namespace npsee::editor
