#include "sim/explosion/children.h"

#include "sim/core/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>

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

/// Age at which a particle's path ends: a piece that lies still draws none.
double pathEnd(const Particle& p) {
  const auto index = static_cast<std::size_t>(p.index);
  return p.chunk.rest_arc[index] != kNoRest ? arcOf(p, p.chunk.rest_arc[index]).start_s : p.chunk.lifetime_s[index];
}

/// Ages in the middle of `count` parts of equal length of a particle's path.
void evenlyByDistance(const CompiledLayer& parent, const Particle& p, std::size_t count, double* ages) {
  constexpr std::size_t kPieces = 64;
  const double end = pathEnd(p);
  std::array<double, kPieces + 1> age{}, way{};
  Motion<double> before = stateOf(parent.constants, p.chunk, p.index, 0.0);
  for (std::size_t i = 1; i <= kPieces; ++i) {
    // Closer together at first, where drag changes the speed most.
    const double part = static_cast<double>(i) / kPieces;
    age[i] = end * part * part;
    const Motion<double> here = stateOf(parent.constants, p.chunk, p.index, age[i]);
    way[i] = way[i - 1] + length({here.x - before.x, here.y - before.y, here.z - before.z});
    before = here;
  }
  std::size_t piece = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(count), wanted = part * way[kPieces];
    while (piece < kPieces && way[piece] < wanted) ++piece;
    const double span = way[piece] - way[piece - 1];
    ages[i] = way[kPieces] > 0.0 && span > 0.0 ? age[piece - 1] + (age[piece] - age[piece - 1]) * ((wanted - way[piece - 1]) / span) : part * end;
  }
}

}  // namespace

std::vector<double> pathAges(const CompiledLayer& parent, const std::vector<ParentEvent>& events, std::size_t per_event, PathSpacing spacing, int threads) {
  std::vector<double> out(events.size() * per_event);
  parallelFor(threads, events.size(), [&](std::size_t number) {
    const Particle p = locate(parent, events[number].parent);
    double* ages = out.data() + number * per_event;
    if (spacing == PathSpacing::distance) return evenlyByDistance(parent, p, per_event, ages);
    for (std::size_t i = 0; i < per_event; ++i) ages[i] = (static_cast<double>(i) + 0.5) / static_cast<double>(per_event) * pathEnd(p);
  });
  return out;
}

std::vector<ParentEvent> parentEvents(const CompiledLayer& parent, Trigger trigger) {
  std::vector<ParentEvent> out;
  for (std::uint32_t number = 0; number < parent.count; ++number) {
    if (trigger != Trigger::bounce) {
      out.push_back({number, 0});
      continue;
    }
    if (parent.constants.follow) continue;
    const Particle p = locate(parent, number);
    for (std::uint32_t contact = 1; contact <= p.chunk.last_arc[static_cast<std::size_t>(p.index)]; ++contact) out.push_back({number, contact});
  }
  return out;
}

ChildStart childStart(const CompiledLayer& parent, const ParentEvent& event, Trigger trigger, double path_age) {
  const Particle p = locate(parent, event.parent);
  const auto index = static_cast<std::size_t>(p.index);
  const double life = p.chunk.lifetime_s[index];
  double age = 0.0;
  switch (trigger) {
    case Trigger::none:
    case Trigger::birth: break;
    case Trigger::bounce: age = arcOf(p, event.event).start_s; break;
    case Trigger::death: age = life; break;
    case Trigger::path: age = path_age; break;
  }
  ChildStart out{birthOf(parent, p) + age, stateOf(parent.constants, p.chunk, p.index, age)};
  if (!parent.poses.empty()) out.motion.y += static_cast<double>(parent.poses[event.parent].rise_m);
  return out;
}

}  // namespace npsee::explosion
