#pragma once

#include "app/render/glow.h"
#include "app/render/hour_light.h"
#include "app/render/view.h"

namespace npsee::render {

/// The ground around a burst, and light and air over it, as passes see them.
struct GroundLevel {
  double height_m = 0.0;
  bool solid = true;    ///< hides what is on its other side; false over plain and transparent backgrounds
  bool fades = true;    ///< soft forms fade towards it; where it is solid
  double slope_x = 0.0, slope_z = 0.0;  ///< rise per metre: on a terrain the ground is a plane through the burst
  double shadow_nearer = 0.0;  ///< share of the distance by which shadows are drawn before the ground; above 0 they are hidden by what is nearer
  bool land = true;     ///< can be scorched
  HourLight hour;       ///< of an explosion
  double dimmed = 0.0;  ///< share of the daylight that is missing
  double extinction_per_m = 0.0;
  Vec3 haze;            ///< linear colour of the air
  Vec3 colour{0.46, 0.44, 0.38};  ///< of the ground, sRGB-coded
  Glow glow;            ///< of the effect
};

/// For what lies on the ground, such as shadows: takes the program into use with view and ground, sets u_nearer, and has it blended under the
/// caller's glBlendFunc. A plane drawn before everything else needs no depth; a terrain's hills hide what is behind them.
void layOnGround(const gl::Program& program, const View& view, const GroundLevel& ground);

/// Sets u_ground, u_slope, u_clip and u_fade, light, glow and air, and the clipping itself.
void setGround(const gl::Program& program, const View& view, const GroundLevel& ground);

}  // namespace npsee::render
