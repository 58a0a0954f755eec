#pragma once

#include <npsee/explosion.h>

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace npsee::commands {

/// csv and json hold every particle, exactly; ply holds those that are alive, in single precision, for other graphics programs.
enum class ParticleFormat { csv, json, ply };

/// What the formats need of a frame.
inline constexpr unsigned kParticleFields = kVelocity | kLook | kBounces | kAge | kOrientation;

/// Gets text piece by piece, so that millions of particles need no second copy; false stops.
using TextSink = std::function<bool(std::string_view)>;

/// Writes a frame; false if the sink stopped. `title` and `seed` go into the comments of a PLY.
struct ParticleDump {
  const ExactFrame& frame;
  std::span<const LayerSpan> layers;
  std::string title;
  std::int64_t seed = 0;
};
bool writeParticles(ParticleFormat format, const ParticleDump& dump, const TextSink& sink);

/// ".csv"
std::string endingOf(ParticleFormat format);

/// Names of the CSV columns, with commas between.
std::string particleColumns();

}  // namespace npsee::commands
