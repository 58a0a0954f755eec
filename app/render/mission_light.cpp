#include "app/render/mission_light.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace npsee::render {

double extinctionOf(double visibility_m) { return visibility_m > 0.0 ? 3.912 / visibility_m : 0.0; }

double extinctionBetween(const MissionLight& light, const Vec3& eye, const Vec3& at) {
  const auto density = [&](double y) { return std::exp(-(y - light.sea_m) / kHazeHeight_m); };
  const double rise = at.y - eye.y;
  const double mean = std::abs(rise) < 2.0 ? density(at.y) : (density(eye.y) - density(at.y)) * kHazeHeight_m / rise;
  return extinctionOf(light.visibility_m) * mean;
}

void setLight(const gl::Program& program, const MissionLight& light, const Vec3& eye) {
  const auto f = [](double v) { return static_cast<float>(v); };
  program.set("u_night", light.night ? 1.0f : 0.0f);
  program.set("u_extinction", f(extinctionOf(light.visibility_m)));
  program.set("u_eye_over_sea", f(eye.y - light.sea_m));
  program.set("u_eye_haze", f(std::exp(-(eye.y - light.sea_m) / kHazeHeight_m)));
  const std::size_t count = std::min(light.flares.size(), kMostFlares);
  program.set("u_flare_count", static_cast<int>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const Flare& flare = light.flares[i];
    const Vec3 at = flare.at_m - eye;
    program.set(("u_flare[" + std::to_string(i) + "]").c_str(), f(at.x), f(at.y), f(at.z), f(flare.radius_m));
    program.set(("u_flare_strength[" + std::to_string(i) + "]").c_str(), f(flare.strength));
  }
}

}  // namespace npsee::render
