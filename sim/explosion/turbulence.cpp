#include "sim/explosion/turbulence.h"

#include <npsee/vec3.h>

#include <cmath>

namespace npsee::explosion {
namespace {

/// Stream of the waves' phases; layers' streams are hashes, and none of theirs is used with so high a block.
constexpr std::uint32_t kStream = 0x7372766eu;

/// Where the waves run: directions spread over the sphere (a spiral of golden angles), written down so that they have equal bits everywhere.
constexpr double kDirections[Turbulence::kWaves][3] = {{0.484, 0.875, 0.0}, {-0.576, 0.625, 0.527}, {0.081, 0.375, -0.924}, {0.603, 0.125, 0.788},
                                                       {-0.977, -0.125, -0.173}, {0.782, -0.375, -0.498}, {-0.203, -0.625, 0.754}, {-0.218, -0.875, -0.432}};
/// Wavelengths as parts of the eddies' size, the first five large; no ratio is simple, so that the pattern does not repeat.
constexpr double kWavelengths[Turbulence::kWaves] = {1.00, 1.17, 0.91, 1.07, 0.84, 0.47, 0.41, 0.53};

Vec3 unitOf(const Vec3& v) { return (1.0 / std::sqrt(dot(v, v))) * v; }

}  // namespace

Turbulence makeTurbulence(double amplitude_m, double size_m, double floor_y, std::uint64_t seed) {
  Turbulence out;
  out.amplitude_m = amplitude_m;
  out.floor_y = floor_y;
  double whole = 0.0;
  for (int i = 0; i < Turbulence::kWaves; ++i) {
    const auto& d = kDirections[i];
    const Vec3 along = unitOf({d[0], d[1], d[2]});
    const auto drawn = uniformBlock({seed, kStream, static_cast<std::uint32_t>(i), 0, 0}, 0xff);
    // Any direction normal to the wave's, by the seed.
    const Vec3 east = unitOf(cross(along, std::fabs(along.y) < 0.7 ? Vec3{0.0, 1.0, 0.0} : Vec3{1.0, 0.0, 0.0})), south = cross(along, east);
    const double turn = 4.0 * drawn[2] - 2.0, flat = turn < 0.0 ? -1.0 - turn : 1.0 - turn;
    const Vec3 across = unitOf(flat * east + (turn < 0.0 ? -1.0 : 1.0) * (1.0 - std::fabs(flat)) * south);
    // Kolmogorov's spectrum: what an eddy moves grows with its size to the power 4/3 in a given time; small ones fade a little slower here,
    // by the first power, because few waves stand for all.
    const double share = kWavelengths[i], k = 1.0 / (kWavelengths[i] * size_m);
    out.waves[i] = {k * along.x, k * along.y, k * along.z, share * across.x, share * across.y, share * across.z, drawn[0], (drawn[1] < 0.5 ? -1.0 : 1.0) * (0.35 + 0.5 * drawn[3])};
    whole += share;
  }
  for (Turbulence::Wave& w : out.waves) {
    w.ax /= whole;
    w.ay /= whole;
    w.az /= whole;
  }
  return out;
}

}  // namespace npsee::explosion
