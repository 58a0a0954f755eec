#pragma once

#include "sim/explosion/kernels.h"
#include "sim/explosion/pieces.h"

#include "sim/core/arena.h"

#include <npsee/explosion.h>

#include <memory>
#include <string>
#include <vector>

namespace npsee::explosion {

/// All of a layer's particles, ready to be evaluated.
struct CompiledLayer {
  LayerConstants constants;
  std::unique_ptr<Arena> memory;  ///< holds the chunks' arrays
  std::vector<Chunk> chunks;
  std::size_t first = 0, count = 0;
  std::string name;
  Form form{};
  std::shared_ptr<const Fragments> fragments;  ///< form pieces
  std::vector<PiecePose> poses;                ///< form pieces: one per particle
};

/// What compiling a layer needs.
struct CompileJob {
  const Preset& preset;
  const Layer& layer;
  std::uint64_t seed;
  const Ground& ground;
  const CompiledLayer* parent;  ///< null for a layer of the burst itself
  const Kernels& kernels;
  int threads;
  std::size_t first;  ///< index of the layer's first particle in frames
  std::shared_ptr<const Fragments> fragments;  ///< form pieces
};

CompiledLayer compileLayer(const CompileJob& job);

/// Gives back the room that this thread keeps from one compilation to the next.
void releaseCompileScratch();

/// Exact state of one particle at an age (clamped to its life), from its arcs.
Motion<double> stateOf(const LayerConstants& constants, const Chunk& chunk, int particle, double age_s);

/// Arcs of one launch over any ground: `motion` is the absolute launch state. Contacts are looked for in steps that move at
/// most half of the ground's detail, then bisected to rounding.
void findArcsOnHeights(const LayerConstants& constants, const Ground& ground, const Motion<double>& motion, double lifetime_s, ArcRoom& room, int lane);

/// Arcs of a particle that follows the ground: its way over level ground, cut where the ground under it may turn, each piece leading to the
/// ground's height at the next cut plus its own height above it. Between two cuts (half of the ground's detail, or a 48th of the way where
/// that is longer) it may be off by what the ground bends there.
void findArcsAlongGround(const LayerConstants& constants, const Ground& ground, const Motion<double>& motion, double lifetime_s, ArcRoom& room, int lane);

}  // namespace npsee::explosion
