#include "editor/document/playback.h"

#include <algorithm>
#include <cmath>

namespace npsee::editor {

void Playback::advance(double elapsed_s) {
  if (!playing) return;
  time_s += elapsed_s * speed;
  if (time_s <= duration_s) return;
  if (loop && duration_s > 0.0) {
    time_s = std::fmod(time_s, duration_s);
  } else {
    time_s = duration_s;
    playing = false;
  }
}

void Playback::toggle() {
  playing = !playing;
  if (playing && time_s >= duration_s) time_s = 0.0;
}

void Playback::step(int frames) {
  playing = false;
  // From an integer count of frames, so that steps to and fro meet the same moments.
  const double now = std::round(time_s / kFrame_s);
  seek((now + frames) * kFrame_s);
}

void Playback::seek(double to_s) { time_s = std::clamp(to_s, 0.0, std::max(0.0, duration_s)); }

void Playback::setDuration(double duration) {
  duration_s = std::max(0.0, duration);
  seek(time_s);
}

}  // namespace npsee::editor
