#include "sim/world/terrain_grid.h"

#include "sim/core/files.h"

#include <cmath>
#include <cstdint>

namespace npsee::world {
namespace {

constexpr std::int16_t kVoid = -32768;
constexpr int kFineSide = 3601;  ///< an SRTM tile of one second of arc, about 30 m
constexpr double kFineCell_m = 30.0, kCoarseCell_m = 90.0;

tl::unexpected<Error> faulty(const TerrainSource& source, std::string what, std::string remedy) {
  return fail(ErrorKind::input, {.what = std::move(what), .remedy = std::move(remedy), .file = source.file.string(), .line = 0, .pointer = {}});
}

enum class Sample : std::uint8_t { missing, known, next };

/// Fills voids ring by ring from the known neighbours' mean, each ring at once so that the order of samples does not matter.
/// False if there is nothing to fill from.
bool fillVoids(Tile& tile, std::vector<Sample>& samples) {
  const int columns = tile.columns, rows = tile.rows;
  const auto eachNeighbour = [&](std::size_t at, auto&& visit) {
    const int c = static_cast<int>(at % static_cast<std::size_t>(columns)), r = static_cast<int>(at / static_cast<std::size_t>(columns));
    for (int nr = std::max(0, r - 1); nr <= std::min(rows - 1, r + 1); ++nr)
      for (int nc = std::max(0, c - 1); nc <= std::min(columns - 1, c + 1); ++nc) visit(static_cast<std::size_t>(nr) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(nc));
  };
  std::vector<std::size_t> ring, after;
  std::vector<float> values;
  const auto queue = [&](std::size_t at) {
    samples[at] = Sample::next;
    after.push_back(at);
  };
  for (std::size_t at = 0; at < samples.size(); ++at) {
    bool beside = false;
    if (samples[at] == Sample::missing) eachNeighbour(at, [&](std::size_t n) { beside = beside || samples[n] == Sample::known; });
    if (beside) queue(at);
  }
  if (after.empty()) return false;
  while (!after.empty()) {
    ring.swap(after);
    after.clear();
    values.clear();
    for (const std::size_t at : ring) {
      double sum = 0.0;
      int count = 0;
      eachNeighbour(at, [&](std::size_t n) {
        if (samples[n] != Sample::known) return;
        sum += tile.heights[n];
        ++count;
      });
      values.push_back(static_cast<float>(sum / count));
    }
    for (std::size_t i = 0; i < ring.size(); ++i) {
      tile.heights[ring[i]] = values[i];
      samples[ring[i]] = Sample::known;
    }
    for (const std::size_t at : ring)
      eachNeighbour(at, [&](std::size_t n) {
        if (samples[n] == Sample::missing) queue(n);
      });
  }
  return true;
}

/// Bilinear value of a tile at sample coordinates within it.
float valueAt(const Tile& tile, double gx, double gz) {
  const int c = std::min(static_cast<int>(gx), tile.columns - 2), r = std::min(static_cast<int>(gz), tile.rows - 2);
  const double u = gx - c, v = gz - r;
  const float* north = tile.heights.data() + static_cast<std::size_t>(r) * static_cast<std::size_t>(tile.columns) + c;
  const float* south = north + tile.columns;
  const double on_north = north[0] + u * (static_cast<double>(north[1]) - north[0]), on_south = south[0] + u * (static_cast<double>(south[1]) - south[0]);
  return static_cast<float>(on_north + v * (on_south - on_north));
}

}  // namespace

Expected<Tile> readHgt(const TerrainSource& source) {
  const auto text = readTextFile(source.file, Terrain::kMaxSamples * 2);
  if (!text) return tl::unexpected<Error>(text.error());
  const std::size_t heights = text->size() / 2;
  const auto side = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(heights))));
  if (side < 2 || side * side * 2 != text->size())
    return faulty(source, "is no .hgt terrain: " + std::to_string(text->size()) + " bytes are not n x n 16-bit heights.",
                  "An SRTM tile has 1201 x 1201 (2884802 bytes) or 3601 x 3601 heights (25934402 bytes); fetch or unpack it again.");
  Tile tile{static_cast<int>(side), static_cast<int>(side), side == kFineSide ? kFineCell_m : kCoarseCell_m, std::vector<float>(side * side)};
  std::vector<Sample> samples(side * side, Sample::known);
  bool whole = true;
  for (std::size_t i = 0; i < side * side; ++i) {
    const auto high = static_cast<unsigned char>((*text)[2 * i]), low = static_cast<unsigned char>((*text)[2 * i + 1]);
    const auto value = static_cast<std::int16_t>(static_cast<std::uint16_t>(high << 8 | low));
    tile.heights[i] = value;
    if (value == kVoid) {
      samples[i] = Sample::missing;
      whole = false;
    }
  }
  if (!whole && !fillVoids(tile, samples)) return faulty(source, "holds no height at all: every sample is a void (-32768).", "Take another tile.");
  return tile;
}

Expected<Terrain::Grid> cropped(const Tile& tile, const TerrainSource& source, double size_x, double size_z) {
  const double cell = source.cell_m > 0.0 ? source.cell_m : tile.cell_m;
  const double whole_x = (tile.columns - 1) * cell, whole_z = (tile.rows - 1) * cell;
  if (size_x == 0.0) size_x = whole_x;
  if (size_z == 0.0) size_z = whole_z;
  if (size_x > whole_x * (1.0 + 1e-9) || size_z > whole_z * (1.0 + 1e-9))
    return faulty(source, "covers " + shown(whole_x) + " x " + shown(whole_z) + " m with samples " + shown(cell) + " m apart, less than the world of " + shown(size_x) + " x " + shown(size_z) + " m.",
                  "Make the world smaller or the terrain's cell_m larger.");
  if (std::max(size_x, size_z) > Terrain::kMaxSize_m)
    return faulty(source, "makes a world of " + shown(whole_x) + " x " + shown(whole_z) + " m, above the limit of " + shown(Terrain::kMaxSize_m) + " m.", "Make cell_m smaller.");
  auto grid = emptyGridOfCells(size_x, size_z, cell, cell);
  if (!grid) return grid;
  // Where the size is a whole number of cells, these are the file's own samples.
  const double per_column = grid->cell_x / cell, per_row = grid->cell_z / cell;
  for (int r = 0; r < grid->rows; ++r)
    for (int c = 0; c < grid->columns; ++c)
      grid->row(r)[c] = valueAt(tile, std::min(c * per_column, tile.columns - 1.0), std::min(r * per_row, tile.rows - 1.0));
  return grid;
}

}  // namespace npsee::world
