#include "app/render/mission_overlays.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

/// Height at which a target stands for the fan, m, and the clearance from which sight counts as free.
constexpr double kTarget_m = 1.8, kFree_m = 12.0;
constexpr int kRays = 420, kRings = 72;

std::array<float, 4> fanColour(double clearance_m) {
  const auto mixed = [](const std::array<float, 4>& a, const std::array<float, 4>& b, double t) {
    std::array<float, 4> out{};
    for (std::size_t k = 0; k < 4; ++k) out[k] = static_cast<float>(static_cast<double>(a[k]) + t * static_cast<double>(b[k] - a[k]));
    return out;
  };
  constexpr std::array<float, 4> kClear{0.25f, 0.85f, 0.45f, 0.34f}, kBarely{0.95f, 0.82f, 0.25f, 0.38f}, kHidden{0.85f, 0.20f, 0.16f, 0.38f}, kDeep{0.45f, 0.06f, 0.10f, 0.30f};
  if (clearance_m >= 0.0) return mixed(kBarely, kClear, std::min(clearance_m / kFree_m, 1.0));
  return mixed(kHidden, kDeep, std::min(-clearance_m / 60.0, 1.0));
}

/// Clearances along one ray at the rings: how far a man there stands over the sight line past the highest crest before him.
void walkRay(const Terrain& terrain, const Vec3& eye, double azimuth_rad, double range_m, double* clearances) {
  const double dx = std::sin(azimuth_rad), dz = -std::cos(azimuth_rad);
  const double step = range_m / kRings;
  const int fine = std::clamp(static_cast<int>(std::ceil(step / std::max(0.5 * terrain.detail(), 2.0))), 1, 64);
  double steepest = -1e9;
  for (int k = 1; k <= kRings; ++k) {
    double seen = steepest;
    for (int f = 1; f <= fine; ++f) {
      const double d = step * (k - 1) + step * f / fine;
      const double ground = terrain.surface(eye.x + d * dx, eye.z + d * dz) - eye.y;
      if (f == fine) clearances[k - 1] = std::min(ground + kTarget_m - seen * d, 1e6);
      seen = std::max(seen, ground / d);
    }
    steepest = seen;
  }
}

}  // namespace

std::vector<GroundCorner> sightFan(const Terrain& terrain, const Vec3& eye, double range_m) {
  std::vector<double> clearances(static_cast<std::size_t>(kRays) * kRings);
  for (int ray = 0; ray < kRays; ++ray) walkRay(terrain, eye, kTwoPi * ray / kRays, range_m, &clearances[static_cast<std::size_t>(ray) * kRings]);
  const auto corner = [&](int ray, int ring) {
    const double turn = kTwoPi * ray / kRays, d = range_m * ring / kRings;
    const double x = eye.x + d * std::sin(turn), z = eye.z - d * std::cos(turn);
    const double clearance = ring == 0 ? kFree_m : clearances[static_cast<std::size_t>(ray % kRays) * kRings + static_cast<std::size_t>(ring - 1)];
    return GroundCorner{{x, terrain.surface(x, z) + 0.8, z}, fanColour(clearance)};
  };
  std::vector<GroundCorner> out;
  out.reserve(6u * kRays * kRings);
  for (int ray = 0; ray < kRays; ++ray)
    for (int ring = 0; ring < kRings; ++ring) {
      const GroundCorner a = corner(ray, ring), b = corner(ray + 1, ring), c = corner(ray + 1, ring + 1), d = corner(ray, ring + 1);
      for (const GroundCorner* g : {&a, &b, &c, &a, &c, &d}) out.push_back(*g);
    }
  return out;
}

std::vector<GroundCorner> scorchMarks(const Recording& recording, double time_s, const MissionEye& eye) {
  constexpr int kMost = 400, kSides = 14;
  constexpr double kInner_m = 2.2, kOuter_m = 6.5, kFarthest_px = 0.4;
  std::vector<GroundCorner> out;
  int count = 0;
  for (std::size_t i = recording.shells.size(); i-- > 0 && count < kMost;) {
    const ShellRecord& shell = recording.shells[i];
    if (shell.burst_s > time_s || shell.illumination) continue;
    const double ground = recording.terrain.surface(shell.burst_m.x, shell.burst_m.z);
    if (shell.burst_m.y > ground + 3.0 || recording.terrain.sea(shell.burst_m.x, shell.burst_m.z)) continue;
    const auto pixel = eye.project(shell.burst_m);
    if (!pixel || kOuter_m / pixel->depth_m / (2.0 * std::tan(0.5 * eye.lens.fov_y_rad) / eye.height) < kFarthest_px) continue;
    ++count;
    const float dark = static_cast<float>(0.78 * std::clamp((time_s - shell.burst_s) / 0.25, 0.0, 1.0));
    const auto at = [&](double radius, int side, float alpha) {
      // Ragged, and each mark in its own way.
      const double salt = 0.6180339887498949 * static_cast<double>((side % kSides) * 7 + shell.number * 13);
      const double ragged = radius * (0.72 + 0.5 * (salt - std::floor(salt)));
      const double turn = kTwoPi * side / kSides, x = shell.burst_m.x + ragged * std::sin(turn), z = shell.burst_m.z - ragged * std::cos(turn);
      return GroundCorner{{x, recording.terrain.surface(x, z) + 0.05, z}, {0.07f, 0.06f, 0.05f, alpha}};
    };
    const GroundCorner middle{{shell.burst_m.x, ground + 0.05, shell.burst_m.z}, {0.05f, 0.045f, 0.04f, dark}};
    for (int side = 0; side < kSides; ++side) {
      const GroundCorner a = at(kInner_m, side, dark), b = at(kInner_m, side + 1, dark), c = at(kOuter_m, side + 1, 0.0f), d = at(kOuter_m, side, 0.0f);
      for (const GroundCorner* g : {&middle, &a, &b, &a, &b, &c, &a, &c, &d}) out.push_back(*g);
    }
  }
  return out;
}

double pixelsOfMil(const MissionEye& eye, double mil) { return 0.5 * eye.height / std::tan(0.5 * eye.lens.fov_y_rad) * std::tan(toSi(Unit::mil, mil)); }

std::vector<ScreenStroke> reticleOf(const MissionEye& eye, double field_mil, bool night) {
  const double cx = 0.5 * eye.width, cy = 0.5 * eye.height;
  const double scale = std::max(1.0, std::min(eye.width, eye.height) / 720.0);
  const StrokeStyle fine{night ? Colour{0.95, 0.42, 0.20} : Colour{0.02, 0.03, 0.03}, 1.4 * scale, night ? 0.75 : 0.88, 1.0, 0.0};
  std::vector<ScreenStroke> out;
  // Wide fields have coarser scales, so that ticks stay apart.
  const int step = field_mil <= 60.0 ? 1 : field_mil <= 300.0 ? 5 : field_mil <= 700.0 ? 25 : 50;
  const int reach = static_cast<int>(0.40 * field_mil / step) * step;
  // Numbers keep apart in a small picture.
  int numbered = 2 * step;
  while (pixelsOfMil(eye, numbered) < 26.0 * scale && numbered < reach) numbered *= 2;
  // Free in the middle, where the target is.
  const double gap = std::max(pixelsOfMil(eye, 0.4 * step), 4.0 * scale);
  const auto tick = [&](int mil, bool across) {
    const double at = pixelsOfMil(eye, mil);
    const bool major = mil % (2 * step) == 0;
    const double size = (major ? 9.0 : 5.0) * scale;
    if (across) out.push_back({{{cx + at, cy - size}, {cx + at, cy}}, fine});
    else out.push_back({{{cx - 0.5 * size, cy - at}, {cx + 0.5 * size, cy - at}}, fine});
    if (mil % numbered != 0 || mil == 0) return;
    const int shown = mil < 0 ? -mil : mil;
    if (across) addText(std::to_string(shown), cx + at, cy + 14.0 * scale, 7.5 * scale, true, fine, out);
    else addText(std::to_string(shown), cx + 10.0 * scale, cy - at + 3.5 * scale, 7.0 * scale, false, fine, out);
  };
  for (int mil = step; mil <= reach; mil += step) {
    tick(mil, true);
    tick(-mil, true);
    if (mil <= reach / 2 + step) tick(mil, false);
  }
  const int highest = (reach / 2 / step + 1) * step;
  const double far = pixelsOfMil(eye, reach), high = pixelsOfMil(eye, highest);
  out.push_back({{{cx - far, cy}, {cx - gap, cy}}, fine});
  out.push_back({{{cx + gap, cy}, {cx + far, cy}}, fine});
  out.push_back({{{cx, cy - high}, {cx, cy - gap}}, fine});
  out.push_back({{{cx, cy + gap}, {cx, cy + gap + 14.0 * scale}}, fine});
  // The azimuth looked along, in whole mils, below.
  const Vec3 ahead = -1.0 * eye.lens.back;
  int azimuth = static_cast<int>(std::lround(toUnit(Unit::mil, std::atan2(ahead.x, -ahead.z))));
  azimuth = ((azimuth % 6400) + 6400) % 6400;
  std::string digits = std::to_string(azimuth);
  digits.insert(0, 4 - std::min<std::size_t>(digits.size(), 4), '0');
  addText(digits, cx, cy + 0.36 * std::min(eye.width, eye.height), 12.0 * scale, true, {fine.colour, 1.8 * scale, fine.opacity, 1.0, 0.0}, out);
  return out;
}

}  // namespace npsee::render
