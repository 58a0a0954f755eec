#pragma once

#include "app/gl/program.h"

#include <npsee/explosion.h>

#include <span>

namespace npsee::render {

/// Light below this adds nothing that eight bits could show, even on bright ground.
inline constexpr double kLeastGlow = 0.01;

/// The light that flashes and fire throw on what is around them: one lamp that stands for them all.
struct Glow {
  Vec3 place;              ///< world m, the middle of what shines
  double radius_m = 0.0;   ///< of what shines; nearer than this its light grows no more
  Vec3 light_m2;           ///< linear: a surface that faces it at a distance d gets light_m2 / (d^2 + radius^2)

  bool shines() const { return light_m2.x + light_m2.y + light_m2.z > 0.0; }
  /// Distance beyond which its light is below what eight bits can show, m.
  double reach() const;
  friend bool operator==(const Glow&, const Glow&) = default;
};

/// The lamp of a frame; one that does not shine where no flash or fire is alive.
Glow glowOf(const Frame& frame, std::span<const LayerSpan> layers);

/// Sets u_glow_place (with the squared radius) and u_glow.
void setGlow(const gl::Program& program, const Glow& glow);

}  // namespace npsee::render
