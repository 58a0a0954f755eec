#include "app/render/hour_light.h"

#include "app/render/view.h"

namespace npsee::render {

HourLight hourLight(Sky sky) {
  HourLight out;
  switch (sky) {
    case Sky::day:
      // As kHorizon and kZenith of shaders/common.glsl.
      out.horizon = {0.450, 0.510, 0.560};
      out.zenith = {0.110, 0.200, 0.345};
      break;
    case Sky::dusk:
      // Eleven degrees over the horizon, where the day's sun goes down: shadows five times as long as what throws them.
      out.towards_key = {-0.7341, 0.1908, 0.6516};
      out.key = {4.30, 2.35, 1.02};
      out.daylight = {0.390, 0.345, 0.375};
      out.horizon = {0.300, 0.205, 0.175};
      out.zenith = {0.028, 0.048, 0.105};
      out.afterglow = {0.62, 0.24, 0.07};
      out.exposure = 1.4;
      out.stars = 0.10;
      break;
    case Sky::night:
      // The moon, 37 degrees high in the south-east; the ground is still told from the sky.
      out.towards_key = {0.5150, 0.6018, 0.6104};
      out.key = {2.30, 2.20, 2.05};
      out.daylight = {0.034, 0.043, 0.064};
      out.horizon = {0.0130, 0.0180, 0.0300};
      out.zenith = {0.0035, 0.0055, 0.0125};
      out.exposure = 2.2;
      out.stars = 0.55;
      break;
  }
  return out;
}

double HourLight::keyShare() const {
  // The sky's light as kSkyAmbient of shaders/common.glsl, all in the green, where eyes are.
  constexpr double kSky = 0.35;
  const double lit = key.y * towards_key.y;
  return lit / (lit + kSky);
}

void setKey(const gl::Program& program, const Vec3& towards_key, const Vec3& key) {
  setVec3(program, "u_towards_key", towards_key);
  setVec3(program, "u_key_light", key);
}

void setHour(const gl::Program& program, Sky sky) {
  const HourLight light = hourLight(sky);
  setVec3(program, "u_horizon", light.horizon);
  setVec3(program, "u_zenith", light.zenith);
  setVec3(program, "u_afterglow", light.afterglow);
  program.set("u_stars", static_cast<float>(light.stars));
  setVec3(program, "u_daylight", light.daylight);
  setKey(program, light.towards_key, light.key);
}

}  // namespace npsee::render
