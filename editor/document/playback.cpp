#include "editor/document/playback.h"

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

}  // namespace npsee::editor
