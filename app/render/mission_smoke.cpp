#include "app/render/mission_smoke.h"

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

constexpr std::size_t kMostWrecks = 40, kMostMuzzles = 48, kMostClouds = 16;
/// A column of smoke is that many puffs, each this long in the air, s.
constexpr int kPuffs = 20;
constexpr double kPuffLife_s = 26.0, kBurning_s = 180.0;
constexpr double kMuzzleFlash_s = 0.12, kMuzzleSmoke_s = 5.0;

/// A number of its own for anything counted: the golden ratio's multiples spread evenly.
double own(std::size_t index, double salt) {
  const double x = 0.6180339887498949 * static_cast<double>(index + 1) + salt;
  return x - std::floor(x);
}

class Maker {
 public:
  explicit Maker(const Vec3& origin) { smoke_.origin = origin; }

  void add(Form form, const Vec3& at, double size, const Colour& colour, double opacity) {
    if (opacity <= 0.0 || size <= 0.0) return;
    Frame& frame = smoke_.frame;
    if (smoke_.layers.empty() || smoke_.layers.back().form != form) smoke_.layers.push_back({"", frame.count, 0, form});
    ++smoke_.layers.back().count;
    ++frame.count;
    const auto put = [](std::vector<float>& array, double value) { array.push_back(static_cast<float>(value)); };
    put(frame.x, at.x), put(frame.y, at.y), put(frame.z, at.z), put(frame.size, size);
    put(frame.r, colour.r), put(frame.g, colour.g), put(frame.b, colour.b), put(frame.a, opacity);
    put(frame.vx, 0.0), put(frame.vy, 0.0), put(frame.vz, 0.0);
    put(frame.qx, 0.0), put(frame.qy, 0.0), put(frame.qz, 0.0), put(frame.qw, 1.0);
    frame.alive.push_back(1);
    frame.bounces.push_back(0);
  }
  Smoke take() { return std::move(smoke_); }
  bool empty() const { return smoke_.frame.count == 0; }

 private:
  Smoke smoke_;
};

/// A column that drifts with the wind; dense and black at first, thin and grey later.
Smoke wreck(const Vec3& at, std::size_t index, double since_s, const Vec3& wind) {
  Maker maker(at);
  const double strength = std::clamp(1.0 - 0.65 * (since_s - 20.0) / kBurning_s, 0.35, 1.0);
  for (int i = 0; i < kPuffs; ++i) {
    // Puff after puff, evenly, each beginning anew when its life is over.
    const double phase = since_s / kPuffLife_s - static_cast<double>(i) / kPuffs;
    if (phase < 0.0) continue;
    const double age = phase - std::floor(phase);
    const double turn = own(static_cast<std::size_t>(i) + 31 * index + 977 * static_cast<std::size_t>(std::floor(phase)), 0.13) * 6.283185307179586;
    const double rise = 34.0 * age * (1.3 - 0.3 * age) * (0.6 + 0.4 * strength);
    const Vec3 place{0.9 * std::cos(turn) * (0.6 + 3.0 * age) + wind.x * age * kPuffLife_s * 0.8, 1.6 + rise, 0.9 * std::sin(turn) * (0.6 + 3.0 * age) + wind.z * age * kPuffLife_s * 0.8};
    const double grey = 0.10 + 0.26 * age + 0.15 * (1.0 - strength);
    const double opacity = 0.85 * strength * std::min(age * 12.0, 1.0) * (1.0 - age) * (1.0 - age);
    maker.add(Form::smoke, place, 2.6 + 13.0 * age, {grey, grey * 0.98, grey * 0.95}, opacity);
  }
  if (since_s < kBurning_s) {
    const double left = std::min(1.0, (kBurning_s - since_s) / 60.0);
    for (int i = 0; i < 7; ++i) {
      const double phase = since_s / 0.9 + own(static_cast<std::size_t>(i) + 7 * index, 0.4), age = phase - std::floor(phase);
      const double turn = own(static_cast<std::size_t>(i) + 13 * static_cast<std::size_t>(std::floor(phase)), 0.77) * 6.283185307179586;
      maker.add(Form::fire, {0.8 * std::cos(turn), 1.2 + 2.6 * age, 0.8 * std::sin(turn)}, (1.9 - 1.0 * age) * (0.5 + 0.5 * left), {1.0, 0.55, 0.16}, 0.8 * left * (1.0 - age));
    }
  }
  return maker.take();
}

/// Flash and smoke before a muzzle.
Smoke muzzle(const ShellRecord& shell, double since_s, const Vec3& wind) {
  Maker maker(shell.muzzle_m);
  Vec3 line = shell.velocityAt(shell.fired_s);
  const double speed = length(line);
  line = speed > 1.0 ? (1.0 / speed) * line : Vec3{0.0, 1.0, 0.0};
  for (int i = 0; i < 6; ++i) {
    const double k = own(static_cast<std::size_t>(i) + 5 * static_cast<std::size_t>(std::max(shell.number, 0)), 0.2), age = since_s / kMuzzleSmoke_s;
    const double reach = (2.0 + 9.0 * k) * (1.0 - std::exp(-3.0 * since_s));
    const Vec3 place = (4.5 + reach) * line + since_s * wind + Vec3{1.4 * (own(static_cast<std::size_t>(i), 0.5) - 0.5) * (1.0 + 2.0 * since_s), 0.7 * since_s * k, 1.4 * (k - 0.5) * (1.0 + 2.0 * since_s)};
    maker.add(Form::smoke, place, 1.8 + 5.5 * age, {0.72, 0.71, 0.68}, 0.55 * (1.0 - age) * (1.0 - age));
  }
  if (since_s < kMuzzleFlash_s) {
    const double left = 1.0 - since_s / kMuzzleFlash_s;
    maker.add(Form::fire, 5.5 * line, 3.4 * left + 0.6, {1.0, 0.72, 0.30}, left);
    maker.add(Form::flash, 5.0 * line, 14.0 * left, {1.0, 0.86, 0.55}, left);
  }
  return maker.take();
}

/// A smoke shell's cloud: it stands over its place and churns.
Smoke cloud(const ShellRecord& shell, double since_s) {
  constexpr std::size_t kClouds = 44;
  Maker maker(shell.burst_m);
  const double grown = 1.0 - std::exp(-since_s / 4.0), left = std::clamp((kCloud_s - since_s) / 12.0, 0.0, 1.0);
  for (std::size_t i = 0; i < kClouds; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / kClouds, turn = 6.283185307179586 * own(i, 0.3) + 0.05 * since_s * (own(i, 0.9) - 0.5);
    const double reach = kCloudRadius_m * std::sqrt(share) * grown, height = kCloudHeight_m * own(i, 0.61) * (1.0 - 0.6 * share) * grown;
    maker.add(Form::smoke, {reach * std::cos(turn), 2.5 + height + 0.8 * std::sin(0.4 * since_s + 9.0 * share), reach * std::sin(turn)}, (7.0 + 9.0 * own(i, 0.17)) * (0.35 + 0.65 * grown), {0.80, 0.80, 0.79}, 0.62 * left);
  }
  return maker.take();
}

/// A candle under its parachute, with the smoke it leaves.
Smoke candle(const Flare& flare, double since_s, const Vec3& wind, double least_m) {
  Maker maker(flare.at_m);
  for (int i = 9; i >= 1; --i) {
    const double ago = 0.9 * i;
    if (ago > since_s) continue;
    maker.add(Form::smoke, Vec3{0.0, kFlareSink_mps * ago + 1.0, 0.0} - ago * wind, 1.2 + 0.35 * ago, {0.80, 0.78, 0.72}, 0.30 * (1.0 - ago / 9.0) * flare.strength);
  }
  const double flicker = 0.93 + 0.07 * std::sin(37.0 * since_s);
  maker.add(Form::flash, {}, std::max(26.0, least_m) * flicker, {1.0, 0.93, 0.74}, flare.strength);
  return maker.take();
}

/// Whether an effect of some metres at a place can be seen at all from the eye.
bool near(const MissionEye& eye, const Vec3& at) {
  const Vec3 from = at - eye.lens.eye;
  const double depth = -dot(eye.lens.back, from);
  return depth > -30.0 && 25.0 * eye.height > 2.0 * std::tan(0.5 * eye.lens.fov_y_rad) * depth;
}

double flareStrength(double since_s) { return std::clamp(since_s / 1.5, 0.0, 1.0) * std::clamp((kFlareBurn_s - since_s) / 6.0, 0.0, 1.0); }

Flare flareOf(const Recording& recording, const ShellRecord& shell, double since_s) {
  Flare flare;
  flare.at_m = shell.burst_m + since_s * recording.scenario.world.weather.wind_mps;
  const double ground = recording.terrain.surface(flare.at_m.x, flare.at_m.z);
  flare.at_m.y = std::max(shell.burst_m.y - kFlareSink_mps * since_s, ground + 3.0);
  flare.radius_m = kFlareRadius_m;
  flare.strength = flareStrength(since_s);
  return flare;
}

}  // namespace

std::vector<Smoke> missionSmoke(const Recording& recording, double time_s, const MissionEye& eye) {
  std::vector<Smoke> out;
  const Vec3 wind = recording.scenario.world.weather.wind_mps;
  std::size_t wrecks = 0;
  for (std::size_t i = 0; i < recording.vehicles.size() && wrecks < kMostWrecks; ++i) {
    if (!recording.vehicles[i].destroyedAt(time_s)) continue;
    double since = time_s;
    for (const DamageStep& step : recording.vehicles[i].damage)
      if (step.hull >= 1.0) {
        since = time_s - step.t_s;
        break;
      }
    out.push_back(wreck(recording.vehiclePlace(i, time_s), i, std::max(since, 0.0), wind));
    ++wrecks;
  }
  const std::size_t before = out.size();
  std::size_t muzzles = 0, clouds = 0;
  // The latest first, as far as there is room.
  for (std::size_t i = recording.shells.size(); i-- > 0;) {
    const ShellRecord& shell = recording.shells[i];
    if (shell.fired_s > time_s) continue;
    const double fired = time_s - shell.fired_s, burst = time_s - shell.burst_s;
    if (fired < kMuzzleSmoke_s && muzzles < kMostMuzzles && near(eye, shell.muzzle_m)) {
      out.push_back(muzzle(shell, fired, wind));
      ++muzzles;
    }
    if (shell.smoke && burst >= 0.0 && burst < kCloud_s && clouds < kMostClouds) {
      out.push_back(cloud(shell, burst));
      ++clouds;
    }
    if (shell.illumination && burst >= 0.0 && burst < kFlareBurn_s) {
      const Flare flare = flareOf(recording, shell, burst);
      const double metre_per_pixel = 2.0 * std::tan(0.5 * eye.lens.fov_y_rad) / eye.height * length(flare.at_m - eye.lens.eye);
      out.push_back(candle(flare, burst, wind, 14.0 * metre_per_pixel));
    }
  }
  std::reverse(out.begin() + static_cast<std::ptrdiff_t>(before), out.end());
  std::erase_if(out, [](const Smoke& smoke) { return smoke.frame.count == 0; });
  return out;
}

MissionLight lightAt(const Recording& recording, double time_s) {
  const Weather& weather = recording.scenario.world.weather;
  MissionLight light;
  light.night = weather.night;
  light.sea_m = recording.terrain.seaLevel();
  light.visibility_m = std::max(weather.visibility_m, 50.0);
  for (const ShellRecord& shell : recording.shells) {
    if (shell.fired_s > time_s) break;
    const double since = time_s - shell.burst_s;
    if (shell.illumination && since >= 0.0 && since < kFlareBurn_s) light.flares.push_back(flareOf(recording, shell, since));
  }
  std::ranges::stable_sort(light.flares, [](const Flare& a, const Flare& b) { return a.strength > b.strength; });
  return light;
}

GroundLevel groundAt(const Terrain& terrain, const Vec3& at, const Vec3& eye, const MissionLight& light) {
  GroundLevel ground;
  ground.height_m = terrain.surface(at.x, at.z) - at.y;
  ground.solid = false;
  ground.fades = true;
  ground.shadow_nearer = 0.004;
  if (!terrain.sea(at.x, at.z)) {
    const Vec3 normal = terrain.normal(at.x, at.z);
    ground.slope_x = -normal.x / normal.y;
    ground.slope_z = -normal.z / normal.y;
  } else {
    ground.land = false;
  }
  double lit = 0.0;
  for (const Flare& flare : light.flares) {
    const Vec3 to = flare.at_m - at;
    const double square = dot(to, to) / (flare.radius_m * flare.radius_m);
    lit += 0.7 * flare.strength / (1.0 + 1.5 * square * (1.0 + square));
  }
  ground.dimmed = light.night ? std::clamp(0.94 - lit, 0.0, 0.94) : 0.0;
  ground.extinction_per_m = extinctionBetween(light, eye, at);
  // The air's colour at the horizon, as in shaders/common.glsl and mission_light.glsl.
  ground.haze = light.night ? Vec3{0.022, 0.029, 0.045} : Vec3{0.450, 0.510, 0.560};
  return ground;
}

}  // namespace npsee::render
