#include "editor/document/playback.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {

void Playback::beginRange(double at_s) {
  const double at = std::clamp(at_s, 0.0, duration_s);
  to_s = hasRange() && to_s > at ? to_s : duration_s;
  from_s = at;
  if (!hasRange()) clearRange();
}

void Playback::endRange(double at_s) {
  const double at = std::clamp(at_s, 0.0, duration_s);
  from_s = hasRange() && from_s < at ? from_s : 0.0;
  to_s = at;
  if (!hasRange()) clearRange();
}

void Playback::advance(double elapsed_s) {
  if (!playing) return;
  // Whoever went past the range plays on to the end.
  const bool within = hasRange() && time_s <= to_s && from_s < duration_s;
  const double end = within ? std::min(to_s, duration_s) : duration_s, begin = hasRange() && from_s < duration_s ? from_s : 0.0;
  time_s += elapsed_s * speed;
  if (time_s <= end) return;
  if (loop && end > begin) {
    time_s = begin + std::fmod(time_s - begin, end - begin);
  } else {
    time_s = end;
    playing = false;
  }
}

}  // namespace npsee::editor
