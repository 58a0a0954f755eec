#pragma once

#include <npsee/preset.h>

#include <string>
#include <vector>

namespace npsee {

/// A fault of the preset as a whole; `fallback` is where to point if `pointer` was left at its default.
struct PresetFault {
  std::string pointer, fallback, what, remedy;
};

/// Rules between values: names, parents, cycles, directions, particle budget. Single values are checked by the table.
std::vector<PresetFault> relationFaults(const Preset& preset);

/// Particles over all layers, parents multiplied in with their largest number of events; saturates.
double particleBudget(const Preset& preset);

/// Bytes the compiled preset takes at most, every particle bouncing as often as it may.
double memoryBudget(const Preset& preset);

}  // namespace npsee
