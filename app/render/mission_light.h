#pragma once

#include "app/gl/program.h"

#include <npsee/scenario.h>

#include <vector>

namespace npsee::render {

/// An illumination shell burning in the air.
struct Flare {
  Vec3 at_m;              ///< in the world
  double radius_m = 0.0;  ///< lit on the ground
  double strength = 1.0;  ///< 0..1
  friend bool operator==(const Flare&, const Flare&) = default;
};

/// Light and air of a mission at a moment.
struct MissionLight {
  bool night = false;
  double visibility_m = 20000.0;  ///< contrast falls to 2 % over this; 0 = clear
  double sea_m = 0.0;             ///< level at which the haze is as dense as the visibility says
  std::vector<Flare> flares;      ///< the strongest kMostFlares count
  friend bool operator==(const MissionLight&, const MissionLight&) = default;
};
inline constexpr std::size_t kMostFlares = 6;

/// Sets the uniforms of shaders/mission_light.glsl; places become relative to `eye`.
void setLight(const gl::Program& program, const MissionLight& light, const Vec3& eye);

/// Height over which the haze thins to 1 / e, m, as in shaders/mission_light.glsl.
inline constexpr double kHazeHeight_m = 1500.0;

/// Mean extinction per metre between two places of the world.
double extinctionBetween(const MissionLight& light, const Vec3& eye, const Vec3& at);

/// Extinction per metre at the sea for a meteorological visibility: exp(-3.912) = 2 % (Koschmieder).
double extinctionOf(double visibility_m);

}  // namespace npsee::render
