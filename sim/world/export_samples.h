#pragma once

#include <npsee/exports.h>

#include <string>
#include <string_view>

namespace npsee::world {

/// What all exports share: when which thing is sampled, and where it is then.

/// A thing at a moment.
struct Sample {
  enum class Kind { vehicle, gun, shell, burst };
  double t_s = 0.0;
  Kind kind = Kind::vehicle;
  int index = 0;          ///< in its list of the recording
  bool first = false;     ///< the thing appears
  bool last = false;      ///< it is gone after this: a shell bursts
  Vec3 position_m, velocity_mps;
  double heading_rad = 0.0;
};

/// Samples of everything by time, then by kind and index. A vehicle is sampled where a leg begins, where its damage changes and at
/// every step while it moves; `heartbeat_s` > 0 samples it, and the guns, at least that often. Error kind usage.
Expected<std::vector<Sample>> samplesOf(const Recording& recording, const ExportSetup& setup, double heartbeat_s = 0.0);

/// Side of who fired a shell.
Side sideOf(const Recording& recording, const ShellRecord& shell);
std::string_view sideWord(Side side);

/// Rounded to `decimals`, without closing zeros, never "-0".
std::string rounded(double value, int decimals);

}  // namespace npsee::world
