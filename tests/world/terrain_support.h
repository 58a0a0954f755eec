#pragma once

#include <npsee/terrain.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace npsee::test {

/// A terrain that the test takes for granted.
inline Terrain terrain(const TerrainSource& source, double size_x, double size_z, double sea_level = 0.0) {
  auto made = Terrain::make(source, size_x, size_z, sea_level);
  EXPECT_TRUE(made) << (made ? "" : made.error().text());
  if (!made) std::abort();
  return *made;
}

inline TerrainSource hills(std::int64_t seed, double cell_m = 0.0) {
  TerrainSource source;
  source.kind = TerrainKind::hills;
  source.seed = seed;
  source.cell_m = cell_m;
  return source;
}

inline TerrainSource function(const std::string& name, std::map<std::string, double> params, const std::string& axis = "z") {
  TerrainSource source;
  source.kind = TerrainKind::function;
  source.expression = name;
  source.params = std::move(params);
  source.axis = axis;
  return source;
}

/// Numbers in [0, 1) that are the same everywhere.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  double next() {
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state_ >> 11) / 9007199254740992.0;
  }
  double between(double low, double high) { return low + (high - low) * next(); }

 private:
  std::uint64_t state_;
};

}  // namespace npsee::test
