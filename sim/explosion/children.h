#pragma once

#include "sim/explosion/compile.h"

namespace npsee::explosion {

/// One event of a parent particle that starts children.
struct ParentEvent {
  std::uint32_t parent = 0;  ///< particle number within the parent layer
  std::uint32_t event = 0;   ///< number of the bounce; 0 for other triggers
};

/// The events of a whole parent layer in particle order, one entry each.
std::vector<ParentEvent> parentEvents(const CompiledLayer& parent, Trigger trigger);

/// Ages of the parents at which their children along the path start, `per_event` for each event: in the middle of as many parts of the way,
/// even in time or in distance, up to the parent's death or rest. Distances are of a polygon of 64 pieces.
std::vector<double> pathAges(const CompiledLayer& parent, const std::vector<ParentEvent>& events, std::size_t per_event, PathSpacing spacing, int threads);

/// When and with what motion a child starts from an event; birth times are in the explosion's time. `path_age` counts along a path.
struct ChildStart {
  double time_s = 0.0;
  Motion<double> motion;
};
ChildStart childStart(const CompiledLayer& parent, const ParentEvent& event, Trigger trigger, double path_age);

}  // namespace npsee::explosion
