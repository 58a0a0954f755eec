#pragma once

#include <npsee/error.h>
#include <npsee/ground.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace npsee {

enum class TerrainKind { flat, hills, function, hgt, png };

/// How a terrain comes about: a plain value from a mission file.
struct TerrainSource {
  TerrainKind kind = TerrainKind::flat;
  double height_m = 0.0;                 ///< flat: height everywhere
  std::string expression;                ///< function: "ridge", ...
  std::map<std::string, double> params;  ///< function: named numbers
  std::string axis = "z";                ///< function ridge: the line along which the crest runs
  double cell_m = 0.0;                   ///< 0: chosen by the kind and the size
  double relief_m = 250.0, scale_m = 6000.0, valley = 0.5, sea_fraction = 0.1;  ///< hills
  std::int64_t seed = 1;                 ///< hills
  std::filesystem::path file;            ///< hgt, png
  friend bool operator==(const TerrainSource&, const TerrainSource&) = default;
};

struct Sight {
  bool clear = true;
  double clearance_m = 0.0;  ///< least height of the ray over the ground
  double worst_m = 0.0;      ///< horizontal distance from the eye where that is
};

class Terrain final : public Ground {
 public:
  Terrain();  ///< flat at 0, 1 km square
  static Expected<Terrain> make(const TerrainSource& source, double size_x_m, double size_z_m, double sea_level_m);
  double height(double x_m, double z_m) const override;
  Vec3 normal(double x_m, double z_m) const override;
  double detail() const override;
  bool flat() const override;
  double seaLevel() const;
  bool sea(double x_m, double z_m) const;
  double surface(double x_m, double z_m) const;
  double sizeX() const;
  double sizeZ() const;
  int columns() const;
  int rows() const;
  double cellX() const;
  double cellZ() const;
  std::span<const float> heights() const;
  double lowest() const;
  double highest() const;
  Sight sight(const Vec3& eye, const Vec3& target) const;
  bool sightSampled(const Vec3& eye, const Vec3& target, int samples = 100) const;
  std::vector<double> profile(const Vec3& from, const Vec3& to, int samples) const;
  std::optional<Vec3> raycast(const Vec3& from, const Vec3& direction, double max_m) const;
};

}  // namespace npsee
