#pragma once

#include <npsee/terrain.h>

#include <algorithm>

namespace npsee {

/// The samples of a terrain and what follows from them.
struct Terrain::Grid {
  double size_x = 0.0, size_z = 0.0, sea_level = 0.0;
  int columns = 0, rows = 0;
  double cell_x = 0.0, cell_z = 0.0;
  std::vector<float> heights;
  double lowest = 0.0, highest = 0.0;

  /// Highest sample of each block of kBlock x kBlock cells, their borders included: rays high over a block need not look into it.
  static constexpr int kBlock = 8;
  int block_columns = 0, block_rows = 0;
  std::vector<float> block_highest;
  double highestInBlock(int column, int row) const { return block_highest[static_cast<std::size_t>(row) * static_cast<std::size_t>(block_columns) + static_cast<std::size_t>(column)]; }
  /// Fills in what follows from the heights.
  void finish();

  const float* row(int r) const { return heights.data() + static_cast<std::size_t>(r) * static_cast<std::size_t>(columns); }
  float* row(int r) { return heights.data() + static_cast<std::size_t>(r) * static_cast<std::size_t>(columns); }
};

namespace world {

/// Grid of a world of size_x by size_z with `columns` by `rows` samples, heights still to be filled in. Error: more than kMaxSamples.
Expected<Terrain::Grid> emptyGrid(double size_x, double size_z, double columns, double rows);
/// The same, with the number of cells nearest to the wished lengths.
Expected<Terrain::Grid> emptyGridOfCells(double size_x, double size_z, double cell_x, double cell_z);

/// Samples of a file: `cell_m` apart, the north-west corner first.
struct Tile {
  int columns = 0, rows = 0;
  double cell_m = 0.0;
  std::vector<float> heights;
};

Expected<Tile> readHgt(const TerrainSource& source);
Expected<Tile> readHeightPng(const TerrainSource& source);
/// The part of a tile that a world of that size shows (0: all of it).
Expected<Terrain::Grid> cropped(const Tile& tile, const TerrainSource& source, double size_x, double size_z);

Expected<Terrain::Grid> functionTerrain(const TerrainSource& source, double size_x, double size_z);
Expected<Terrain::Grid> hillsTerrain(const TerrainSource& source, double size_x, double size_z, double sea_level, int threads);

/// "12.5" for messages.
std::string shown(double value);

}  // namespace world
}  // namespace npsee
