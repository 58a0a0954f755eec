#pragma once

#include "app/render/ground_level.h"
#include "app/render/mission_camera.h"
#include "app/render/mission_light.h"

#include <npsee/explosion.h>
#include <npsee/recording.h>

#include <vector>

namespace npsee::render {

/// An illumination shell's candle: how long it burns, what it lights (as in sim/observer/engine.h) and how fast it sinks on its parachute.
inline constexpr double kFlareBurn_s = 60.0, kFlareRadius_m = 1000.0, kFlareSink_mps = 5.0;
/// A smoke shell's cloud, likewise.
inline constexpr double kCloud_s = 60.0, kCloudRadius_m = 40.0, kCloudHeight_m = 25.0;

/// Particles around a place of the world, as a formula of the time: nothing is remembered from picture to picture.
struct Smoke {
  Vec3 origin;
  Frame frame;
  std::vector<LayerSpan> layers;
};

/// Burning wrecks, muzzle flash and smoke of guns and vehicles that fire, flares in the air.
std::vector<Smoke> missionSmoke(const Recording& recording, double time_s, const MissionEye& eye);

/// Light and air of a mission at a moment, flares included.
MissionLight lightAt(const Recording& recording, double time_s);

/// The ground around a place as the particle passes see it: a plane through it, the hour's light, the air.
GroundLevel groundAt(const Terrain& terrain, const Vec3& at, const Vec3& eye, const MissionLight& light);

}  // namespace npsee::render
