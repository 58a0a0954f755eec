#pragma once

#include <npsee/error.h>
#include <npsee/ground.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace npsee {

/// How a terrain comes about.
enum class TerrainKind { flat, hills, function, hgt, png };

/// A terrain as a mission file describes it: a plain value.
///
/// Functions (`expression`, numbers in `params`; a name without a default must be given). "Across" is the direction across `axis`:
/// x for axis z, z for axis x.
///
///   ridge  crest_x (axis z) or crest_z (axis x), crest_height; foot_before, foot_after: distances from the crest line to the feet, m;
///          base_height 0. Linear flanks; a negative crest below the base makes a valley.
///   slope  from, to (across, m), low 0, high: level, then a straight ramp, then level.
///   step   at (across, m), low 0, high; width 1: a cliff of that width around `at`.
///   plane  height 0, slope_x, slope_z 0 (rise per metre east and south).
///   cone   top_x, top_z, top_height, radius; base_height 0.
///
/// The grid of ridge, slope and step has its lines on every bend, so that the surface is the function itself; its cells are fine
/// across and at most 500 m along the axis. Bends that share no lattice of 1 cm or more with at most 65,536 columns are met to half a cell.
struct TerrainSource {
  TerrainKind kind = TerrainKind::flat;
  double height_m = 0.0;                 ///< flat: height everywhere
  std::string expression;                ///< function: its name
  std::map<std::string, double> params;  ///< function: its named numbers
  std::string axis = "z";                ///< function: the axis ("x" or "z") along which a crest, a ramp or a cliff runs
  /// Distance of the samples, m; 0: chosen by kind and size (hills: 1,250 along the longer side, at least 10 m apart; .hgt: 30 m
  /// with 3,601 samples a side, else 90 m; PNG: the sidecar's). Rounded so that a whole number of cells fits each side.
  double cell_m = 0.0;
  double relief_m = 250.0;    ///< hills: height of the land over the sea, all but the highest half per cent, m
  double scale_m = 6000.0;    ///< hills: distance from one range of hills to the next, m
  double valley = 0.5;        ///< hills: width of the valley floors, 0 (notches) to 1 (plains)
  double sea_fraction = 0.1;  ///< hills: share of the world under the sea, 0 to 0.9
  std::int64_t seed = 1;      ///< hills
  /// hgt: SRTM tile, n x n big-endian 16-bit metres, north row first; -32768 marks a void, filled ring by ring from the known
  /// neighbours' mean. png: 16-bit grey picture, north row first, with a sidecar FILE.json of `cell_m` and either `height_min_m`
  /// and `height_max_m` (black and white) or `scale_m` and `offset_m` (height = offset + scale x grey).
  /// The file's north-west corner is the world's; a larger file is cropped, a smaller one refused.
  std::filesystem::path file;
  friend bool operator==(const TerrainSource&, const TerrainSource&) = default;
};

/// Outcome of a line-of-sight test.
struct Sight {
  bool clear = false;        ///< nothing of the ground stands above the ray
  double clearance_m = 0.0;  ///< least height of the ray over the ground; negative: blocked
  double worst_m = 0.0;      ///< horizontal distance from the eye to where that is
};

/// A point of an elevation profile.
struct ProfilePoint {
  double distance_m = 0.0;  ///< horizontal, from the first end
  double x = 0.0, z = 0.0;
  double ground_m = 0.0;    ///< height of the ground
  double surface_m = 0.0;   ///< height of ground or sea, whichever is higher
};

/// The ground of a mission: heights on a grid over x in [0, size_x] (east) and z in [0, size_z] (south), bilinear in between; outside,
/// the edge goes on level. Immutable; copies share the samples. Every result has equal bits on all processors and thread counts.
class Terrain final : public Ground {
 public:
  /// Most samples of a terrain; more is refused.
  static constexpr std::size_t kMaxSamples = std::size_t{64} << 20;
  /// Largest side of a world and largest height, m.
  static constexpr double kMaxSize_m = 1e6, kMaxHeight_m = 2e4;

  /// Flat at height 0, 1 km square, the sea at 0.
  Terrain();
  /// Sizes in metres; for hgt and png a size of 0 is the file's. `threads` 0: one per core.
  /// Error kind input: what is wrong with the source, the sizes or the file.
  static Expected<Terrain> make(const TerrainSource& source, double size_x_m, double size_z_m, double sea_level_m, int threads = 0);

  double height(double x_m, double z_m) const override;
  Vec3 normal(double x_m, double z_m) const override;
  double detail() const override;
  bool flat() const override;

  double seaLevel() const;  ///< Height of the sea, m.
  /// Whether the ground lies below sea level.
  bool sea(double x_m, double z_m) const;
  /// Height of ground or sea, whichever is higher.
  double surface(double x_m, double z_m) const;
  /// Whether (x, z) lies in the world.
  bool inside(double x_m, double z_m) const;

  double sizeX() const;  ///< East to west, m.
  double sizeZ() const;  ///< North to south, m.
  /// Samples west to east and north to south: sample (c, r) stands at x = c cellX(), z = r cellZ() and is heights()[r columns() + c].
  int columns() const;
  int rows() const;
  /// Distance of the samples; (columns() - 1) cellX() is sizeX(). The two may differ much (a ridge is fine across, coarse along).
  double cellX() const;
  double cellZ() const;
  std::span<const float> heights() const;
  double lowest() const;
  double highest() const;

  /// Exact line of sight over the same surface that `height` gives: the least clearance in each cell passed. Symmetric to the bit.
  /// A grazing of less than a micrometre is clear. An eye or target below the ground is blocked.
  /// Source: cells by Amanatides & Woo 1987; clearance over a bilinear cell is a quadratic in the ray parameter.
  Sight sight(const Vec3& eye, const Vec3& target) const;

  /// `sight(eye, target).clear`, quicker: it ends at the first obstacle.
  bool sees(const Vec3& eye, const Vec3& target) const;

  /// The thesis's test, kept as the legacy mode: "at no more than one hundred locations", evenly along the ray and kSampleSpacing_m apart, or
  /// farther where a hundred would not reach. What is narrower along the ray than that may slip through.
  bool sightSampled(const Vec3& eye, const Vec3& target, int most = 100) const;
  /// A hundred locations on the thesis's greatest distance of sight, 4 km: "features of less than forty meters breadth".
  static constexpr double kSampleSpacing_m = 40.0;

  /// The ground at n >= 2 points evenly from a to b, ends included (at most a million points).
  std::vector<ProfilePoint> profile(const Vec3& a, const Vec3& b, int n) const;

  /// First point within max_m along `direction` (any length) where the ray meets the ground from above, on the surface. A start below the
  /// ground is met at once, at the ground above it. Nothing if there is none or an argument is not finite.
  std::optional<Vec3> raycast(const Vec3& from, const Vec3& direction, double max_m) const;

  struct Grid;

 private:
  explicit Terrain(std::shared_ptr<const Grid> grid) : grid_(std::move(grid)) {}
  std::shared_ptr<const Grid> grid_;
};

/// Name of a kind as files write it: "flat", "hills", "function", "hgt", "png"; and back.
std::string_view terrainKindName(TerrainKind kind);
std::optional<TerrainKind> terrainKindFrom(std::string_view name);
/// Names of the functions, in the order of the list above.
std::vector<std::string_view> terrainFunctionNames();

}  // namespace npsee
