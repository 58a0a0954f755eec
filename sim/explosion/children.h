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

/// When and with what motion child `index` of `count` starts from an event; birth times are in the explosion's time.
struct ChildStart {
  double time_s = 0.0;
  Motion<double> motion;
};
ChildStart childStart(const CompiledLayer& parent, const ParentEvent& event, Trigger trigger, double path_part);

}  // namespace npsee::explosion
