#include "app/render/surface_map.h"

#include "sim/core/parallel.h"

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

/// Texels a side: as many as samples, but on coarse grids enough for what grows there.
constexpr int kLeastSide = 256, kCoarseSide = 1024, kMostSide = 2048;
constexpr double kPlants_m = 40.0;
/// Side of the coarse grid that says what is valley and what is crest.
constexpr int kCoarse = 192;

std::uint8_t byteOf(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0)); }

int sideOf(int samples, double size_m) {
  const int plants = std::clamp(static_cast<int>(std::min(size_m / kPlants_m, 1e6)), kLeastSide, kCoarseSide);
  return std::clamp(samples, plants, kMostSide);
}

/// A quantity that changes slowly over the land, on a coarse grid; heights averaged widely tell valleys from crests.
class Broad {
 public:
  /// `source` gives the value at a place in cells.
  template <class Source>
  Broad(const HeightGrid& grid, int reach, const Source& source) : values_(static_cast<std::size_t>(kCoarse) * kCoarse) {
    for (int j = 0; j < kCoarse; ++j)
      for (int i = 0; i < kCoarse; ++i) values_[index(i, j)] = source((grid.columns - 1.0) * i / (kCoarse - 1), (grid.rows - 1.0) * j / (kCoarse - 1));
    for (int pass = 0; reach > 0 && pass < 2; ++pass) {
      blur(reach, true);
      blur(reach, false);
    }
  }
  /// u, v: 0..1 over the terrain.
  double at(double u, double v) const {
    const double x = std::clamp(u, 0.0, 1.0) * (kCoarse - 1), z = std::clamp(v, 0.0, 1.0) * (kCoarse - 1);
    const int i = std::min(static_cast<int>(x), kCoarse - 2), j = std::min(static_cast<int>(z), kCoarse - 2);
    const double a = values_[index(i, j)] + (x - i) * (values_[index(i + 1, j)] - values_[index(i, j)]);
    const double b = values_[index(i, j + 1)] + (x - i) * (values_[index(i + 1, j + 1)] - values_[index(i, j + 1)]);
    return a + (z - j) * (b - a);
  }

 private:
  static std::size_t index(int i, int j) { return static_cast<std::size_t>(j) * kCoarse + static_cast<std::size_t>(i); }
  void blur(int reach, bool along_x) {
    std::vector<double> out(values_.size());
    for (int j = 0; j < kCoarse; ++j)
      for (int i = 0; i < kCoarse; ++i) {
        double sum = 0.0;
        for (int k = -reach; k <= reach; ++k) {
          const int a = std::clamp((along_x ? i : j) + k, 0, kCoarse - 1);
          sum += values_[along_x ? index(a, j) : index(i, a)];
        }
        out[index(i, j)] = sum / (2 * reach + 1);
      }
    values_.swap(out);
  }
  std::vector<double> values_;
};

/// Integer hash of a lattice point; only its look matters.
std::uint32_t hashed(std::uint32_t x, std::uint32_t y, std::uint32_t octave) {
  std::uint32_t h = x * 0x9E3779B1u ^ y * 0x85EBCA77u ^ (octave + 7u) * 0xC2B2AE3Du;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return h ^ (h >> 15);
}

/// What the look of a place follows from.
struct Place {
  double x_m, z_m;
  double height_m;      ///< over the sea
  double east, south;   ///< rise per metre
  double moisture, open;
};
struct Look {
  Vec3 light;           ///< linear, by day
  double rough;
};

double smooth(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}
Vec3 mixed(const Vec3& a, const Vec3& b, double t) { return a + t * (b - a); }

/// Noise over the land, 0..1: `cell_m` from one swell to the next.
double landNoise(double x_m, double z_m, double cell_m, std::uint32_t salt) {
  const double u = x_m / cell_m, v = z_m / cell_m;
  const double i = std::floor(u), j = std::floor(v);
  const auto at = [&](double a, double b) { return hashed(static_cast<std::uint32_t>(static_cast<std::int64_t>(a)), static_cast<std::uint32_t>(static_cast<std::int64_t>(b)), salt) / 4294967295.0; };
  const auto ease = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double fx = ease(u - i), fz = ease(v - j);
  const double low = at(i, j) + (at(i + 1, j) - at(i, j)) * fx, high = at(i, j + 1) + (at(i + 1, j + 1) - at(i, j + 1)) * fx;
  return low + (high - low) * fz;
}

Look lookOf(const Place& place, bool coast) {
  constexpr Vec3 kGrass{0.128, 0.160, 0.056}, kMeadow{0.215, 0.222, 0.088}, kDry{0.270, 0.238, 0.128}, kForest{0.046, 0.076, 0.032}, kRock{0.225, 0.210, 0.190}, kSand{0.420, 0.365, 0.250};
  // The sun, the sky and the ground's own light: as in shaders/common.glsl.
  constexpr Vec3 kSun{-0.5263, 0.7105, 0.4671}, kSunLight{1.42, 1.32, 1.16}, kSkyLight{0.30, 0.35, 0.42}, kGroundLight{0.21, 0.19, 0.165};
  const double fine = 0.6 * landNoise(place.x_m, place.z_m, 170.0, 3) + 0.4 * landNoise(place.x_m, place.z_m, 62.0, 4);
  const double steep = 1.0 - 1.0 / std::sqrt(1.0 + place.east * place.east + place.south * place.south);
  const double wet = std::clamp(place.moisture + 0.20 * (fine - 0.5), 0.0, 1.0);
  Vec3 colour = mixed(kDry, kMeadow, smooth(0.15, 0.42, wet));
  colour = mixed(colour, kGrass, smooth(0.40, 0.60, wet));
  const double forest = smooth(0.60, 0.66, wet + 0.25 * (fine - 0.5)) * smooth(0.12, 0.04, steep) * (coast ? smooth(4.0, 14.0, place.height_m) : 1.0);
  colour = mixed(colour, kForest, forest);
  const double rock = smooth(0.055, 0.16, steep + 0.05 * (fine - 0.5));
  colour = mixed(colour, kRock, rock);
  // A beach needs a sea: a plain at its level has none.
  const double sand = coast ? 1.0 - smooth(1.2, 4.5, place.height_m + 1.6 * (fine - 0.5)) : 0.0;
  colour = mixed(colour, kSand, sand);
  colour = (0.90 + 0.24 * (fine - 0.5) + 0.14 * wet) * colour;
  // Slopes are mostly gentle: shading those steeper than they are shows the relief, as maps do.
  const double slope = std::sqrt(place.east * place.east + place.south * place.south);
  const double steeper = 1.0 + 6.0 / (1.0 + 10.0 * slope);
  const double scale = 1.0 / std::sqrt(1.0 + steeper * steeper * slope * slope);
  const Vec3 normal{-steeper * place.east * scale, scale, -steeper * place.south * scale};
  const double lambert = std::max(dot(normal, kSun), 0.0);
  const Vec3 ambient = place.open * mixed(kGroundLight, kSkyLight, 0.5 + 0.5 * normal.y);
  const Vec3 light = lambert * kSunLight + ambient;
  return {{colour.x * light.x, colour.y * light.y, colour.z * light.z}, std::clamp(0.45 + 0.55 * forest + 0.35 * rock - 0.35 * sand, 0.0, 1.0)};
}

double valueNoise(double u, double v, int cells, std::uint32_t octave) {
  const int i = static_cast<int>(u * cells), j = static_cast<int>(v * cells);
  const auto ease = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double fx = ease(u * cells - i), fy = ease(v * cells - j);
  const auto at = [&](int a, int b) { return hashed(static_cast<std::uint32_t>(a % cells), static_cast<std::uint32_t>(b % cells), octave) / 4294967295.0; };
  const double low = at(i, j) + (at(i + 1, j) - at(i, j)) * fx, high = at(i, j + 1) + (at(i + 1, j + 1) - at(i, j + 1)) * fx;
  return low + (high - low) * fy;
}

}  // namespace

std::vector<std::uint8_t> tilingNoise(int side, int cells, int octaves) {
  std::vector<std::uint8_t> out;
  out.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      double sum = 0.0, weight = 1.0, total = 0.0;
      for (int octave = 0; octave < octaves; ++octave, weight *= 0.6) {
        sum += weight * valueNoise(static_cast<double>(x) / side, static_cast<double>(y) / side, cells << octave, static_cast<std::uint32_t>(octave));
        total += weight;
      }
      out.push_back(byteOf(0.5 + 1.6 * (sum / total - 0.5)));
    }
  return out;
}

SurfaceMap surfaceMapOf(const HeightGrid& grid, int threads) {
  SurfaceMap map;
  map.width = sideOf(grid.columns, (grid.columns - 1) * grid.cell_x_m);
  map.height = sideOf(grid.rows, (grid.rows - 1) * grid.cell_z_m);
  map.texels.resize(4u * static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  const bool coast = std::ranges::any_of(grid.heights, [&](float h) { return static_cast<double>(h) < grid.sea_m; });
  const auto shown = [&](double x, double z) { return std::max(grid.height(x, z), grid.sea_m); };
  const auto swells = [&](double x, double z) {
    const double x_m = x * grid.cell_x_m, z_m = z * grid.cell_z_m;
    return 0.6 * landNoise(x_m, z_m, 1900.0, 1) + 0.4 * landNoise(x_m, z_m, 610.0, 2);
  };
  const Broad near(grid, 2, shown), wide(grid, 7, shown), broad(grid, 0, swells);
  const double step_x = (grid.columns - 1.0) / map.width, step_z = (grid.rows - 1.0) / map.height;
  const double metre_x = step_x * grid.cell_x_m, metre_z = step_z * grid.cell_z_m;
  // Heights by which crests stand over their surroundings, typically: a few per cent of the coarse grid's reach.
  const double relief = std::max(0.012 * std::max((grid.columns - 1) * grid.cell_x_m, (grid.rows - 1) * grid.cell_z_m) / kCoarse * 7.0, 1.0);
  parallelFor(threads, static_cast<std::size_t>(map.height), [&](std::size_t row) {
    std::uint8_t* texel = &map.texels[4u * row * static_cast<std::size_t>(map.width)];
    const double z = (static_cast<double>(row) + 0.5) * step_z, v = z / (grid.rows - 1);
    for (int column = 0; column < map.width; ++column, texel += 4) {
      const double x = (column + 0.5) * step_x, u = x / (grid.columns - 1);
      Place place;
      place.x_m = x * grid.cell_x_m;
      place.z_m = z * grid.cell_z_m;
      place.height_m = grid.height(x, z) - grid.sea_m;
      place.east = (grid.height(x + 0.5 * step_x, z) - grid.height(x - 0.5 * step_x, z)) / metre_x;
      place.south = (grid.height(x, z + 0.5 * step_z) - grid.height(x, z - 0.5 * step_z)) / metre_z;
      const double h = place.height_m + grid.sea_m;
      place.moisture = 0.5 - 0.30 * (h - wide.at(u, v)) / relief + (coast ? 0.10 * std::clamp(1.0 - place.height_m / 60.0, 0.0, 1.0) : 0.0) + 0.75 * (broad.at(u, v) - 0.5);
      place.open = std::clamp(0.96 + 0.22 * (h - near.at(u, v)) / relief, 0.55, 1.2);
      const Look look = lookOf(place, coast);
      texel[0] = byteOf(std::sqrt(look.light.x));
      texel[1] = byteOf(std::sqrt(look.light.y));
      texel[2] = byteOf(std::sqrt(look.light.z));
      texel[3] = byteOf(look.rough);
    }
  });
  return map;
}

}  // namespace npsee::render
