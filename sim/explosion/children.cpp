#include "sim/explosion/children.h"

#include <algorithm>

namespace npsee::explosion {
namespace {

struct Particle {
  const Chunk& chunk;
  int index;
};

Particle locate(const CompiledLayer& layer, std::uint32_t number) {
  return {layer.chunks[number / kChunkParticles], static_cast<int>(number % kChunkParticles)};
}

double birthOf(const CompiledLayer& layer, const Particle& p) {
  return p.chunk.birth_s.empty() ? layer.constants.start_s : p.chunk.birth_s[static_cast<std::size_t>(p.index)];
}

const Arc& arcOf(const Particle& p, std::uint32_t number) { return p.chunk.arcs[p.chunk.first_arc[static_cast<std::size_t>(p.index)] + number]; }

}  // namespace

std::vector<ParentEvent> parentEvents(const CompiledLayer& parent, Trigger trigger) {
  std::vector<ParentEvent> out;
  for (std::uint32_t number = 0; number < parent.count; ++number) {
    if (trigger != Trigger::bounce) {
      out.push_back({number, 0});
      continue;
    }
    const Particle p = locate(parent, number);
    for (std::uint32_t contact = 1; contact <= p.chunk.last_arc[static_cast<std::size_t>(p.index)]; ++contact) out.push_back({number, contact});
  }
  return out;
}

ChildStart childStart(const CompiledLayer& parent, const ParentEvent& event, Trigger trigger, double path_part) {
  const Particle p = locate(parent, event.parent);
  const auto index = static_cast<std::size_t>(p.index);
  const double life = p.chunk.lifetime_s[index];
  double age = 0.0;
  switch (trigger) {
    case Trigger::none:
    case Trigger::birth: break;
    case Trigger::bounce: age = arcOf(p, event.event).start_s; break;
    case Trigger::death: age = life; break;
    case Trigger::path: {
      // A piece that lies still draws no path.
      const double end = p.chunk.rest_arc[index] != kNoRest ? arcOf(p, p.chunk.rest_arc[index]).start_s : life;
      age = path_part * end;
      break;
    }
  }
  return {birthOf(parent, p) + age, stateOf(parent.constants, p.chunk, p.index, age)};
}

}  // namespace npsee::explosion
