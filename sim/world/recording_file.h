#pragma once

#include <npsee/recording.h>
#include <npsee/weapons.h>

#include "sim/observer/fire_direction.h"

#include <optional>
#include <vector>

namespace npsee::world {

/// Version of the recording file, its first line's `npsee_recording`.
inline constexpr int kRecordingVersion = 1;

/// Most that is read, bytes: a day of a thousand vehicles is far below.
inline constexpr std::size_t kMaxRecordingFile = std::size_t{1} << 30;

/// Mark of the ground a mission was played on: a recording is worth nothing over another.
std::string terrainMark(const Terrain& terrain);

/// Flies recorded shells again, each by its battery's fire direction.
class Reflight {
 public:
  Reflight(const Recording& recording, const Weapons& weapons) : recording_(recording), weapons_(weapons), batteries_(recording.scenario.batteries.size()) {}
  /// Error kind input: the battery cannot fire any more, or the shell comes down elsewhere than it did.
  Expected<FlightPath> fly(const ShellRecord& shell, const Shot& shot);

 private:
  const Recording& recording_;
  const Weapons& weapons_;
  std::vector<std::optional<observer::FireDirection>> batteries_;
};

}  // namespace npsee::world
