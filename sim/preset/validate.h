#pragma once

#include <npsee/preset.h>

#include <string>
#include <vector>

namespace npsee {

/// A fault of the preset as a whole; `fallback` is where to point if `pointer` was left at its default.
struct PresetFault {
  std::string pointer, fallback, what, remedy;
};

/// Memory a compiled preset may take, bytes.
inline constexpr double kMaxMemory = 4.0 * 1024 * 1024 * 1024;

/// Rules between values: names, parents, cycles, directions, particle budget. Single values are checked by the table.
std::vector<PresetFault> relationFaults(const Preset& preset);

/// Particles over all layers, parents multiplied in with their largest number of events; saturates.
double particleBudget(const Preset& preset);

/// Most arcs of a particle that follows uneven ground.
inline constexpr int kMostArcsAlongGround = 48;

/// Most arcs that a particle of the layer flies, over flat ground or not.
double mostArcs(const Layer& layer, bool flat);

/// Bytes the compiled preset takes at most, every particle bouncing as often as it may, over flat ground or not.
double memoryBudget(const Preset& preset, bool flat = true);

}  // namespace npsee
