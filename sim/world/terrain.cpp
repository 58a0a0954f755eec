#include "sim/world/terrain_grid.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <thread>

namespace npsee {
namespace {

/// A place on the grid: the cell, and how far into it.
struct Place {
  int column, row;
  double u, v;
};

/// Grid coordinate clamped to [0, last]; what is not a number becomes 0.
double clampedTo(double g, double last) { return g > 0.0 ? (g < last ? g : last) : 0.0; }

Place placeOf(const Terrain::Grid& grid, double x, double z) {
  const double gx = clampedTo(x / grid.cell_x, grid.columns - 1), gz = clampedTo(z / grid.cell_z, grid.rows - 1);
  const int column = std::min(static_cast<int>(gx), grid.columns - 2), row = std::min(static_cast<int>(gz), grid.rows - 2);
  return {column, row, gx - column, gz - row};
}

constexpr std::array<std::string_view, 5> kKindNames{"flat", "hills", "function", "hgt", "png"};

std::optional<std::string> faultOfSize(double size, bool may_be_zero) {
  if (size == 0.0 && may_be_zero) return std::nullopt;
  if (size > 0.0 && size <= Terrain::kMaxSize_m) return std::nullopt;
  return "The world's size is " + world::shown(size) + " m; it must be above 0 and at most " + world::shown(Terrain::kMaxSize_m) + " m.";
}

Expected<Terrain::Grid> flatTerrain(const TerrainSource& source, double size_x, double size_z) {
  auto grid = world::emptyGrid(size_x, size_z, 2, 2);
  if (grid) std::fill(grid->heights.begin(), grid->heights.end(), static_cast<float>(source.height_m));
  return grid;
}

Expected<Terrain::Grid> made(const TerrainSource& source, double size_x, double size_z, double sea_level, int threads) {
  switch (source.kind) {
    case TerrainKind::flat: return flatTerrain(source, size_x, size_z);
    case TerrainKind::function: return world::functionTerrain(source, size_x, size_z);
    case TerrainKind::hills: return world::hillsTerrain(source, size_x, size_z, sea_level, threads);
    case TerrainKind::hgt:
    case TerrainKind::png: break;
  }
  auto tile = source.kind == TerrainKind::hgt ? world::readHgt(source) : world::readHeightPng(source);
  if (!tile) return tl::unexpected<Error>(std::move(tile.error()));
  return world::cropped(*tile, source, size_x, size_z);
}

}  // namespace

namespace world {

std::string shown(double value) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 8).ptr);
}

Expected<Terrain::Grid> emptyGrid(double size_x, double size_z, double columns, double rows) {
  // In doubles first: a tiny cell would overflow whole numbers.
  if (!(columns * rows <= static_cast<double>(Terrain::kMaxSamples)))
    return fail(ErrorKind::input, "The terrain would have " + shown(columns) + " x " + shown(rows) + " samples, above the limit of " + shown(static_cast<double>(Terrain::kMaxSamples)) + ".",
                "Make the cells (cell) larger or the world smaller.");
  Terrain::Grid grid;
  grid.size_x = size_x;
  grid.size_z = size_z;
  grid.columns = std::max(2, static_cast<int>(columns));
  grid.rows = std::max(2, static_cast<int>(rows));
  grid.cell_x = size_x / (grid.columns - 1);
  grid.cell_z = size_z / (grid.rows - 1);
  grid.heights.resize(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
  return grid;
}

Expected<Terrain::Grid> emptyGridOfCells(double size_x, double size_z, double cell_x, double cell_z) {
  const auto samples = [](double size, double cell) { return 1.0 + std::max(1.0, std::floor(size / cell + 0.5)); };
  return emptyGrid(size_x, size_z, samples(size_x, cell_x), samples(size_z, cell_z));
}

}  // namespace world

void Terrain::Grid::finish() {
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  lowest = *low;
  highest = *high;
  block_columns = (columns - 2) / kBlock + 1;
  block_rows = (rows - 2) / kBlock + 1;
  block_highest.clear();
  for (int block_row = 0; block_row < block_rows; ++block_row)
    for (int block_column = 0; block_column < block_columns; ++block_column) {
      const int west = block_column * kBlock, east = std::min(west + kBlock, columns - 1), north = block_row * kBlock, south = std::min(north + kBlock, rows - 1);
      float most = row(north)[west];
      for (int r = north; r <= south; ++r) most = std::max(most, *std::max_element(row(r) + west, row(r) + east + 1));
      block_highest.push_back(most);
    }
}

Expected<Terrain> Terrain::make(const TerrainSource& source, double size_x_m, double size_z_m, double sea_level_m, int threads) {
  const bool from_file = source.kind == TerrainKind::hgt || source.kind == TerrainKind::png;
  for (const double size : {size_x_m, size_z_m})
    if (auto fault = faultOfSize(size, from_file)) return fail(ErrorKind::input, std::move(*fault), "Give the world's size in metres, e.g. [50000, 50000].");
  if (!(std::fabs(sea_level_m) <= kMaxHeight_m))
    return fail(ErrorKind::input, "The sea level is " + world::shown(sea_level_m) + " m; it must lie within " + world::shown(kMaxHeight_m) + " m of 0.", "0 is usual.");
  if (!(std::fabs(source.height_m) <= kMaxHeight_m))
    return fail(ErrorKind::input, "The terrain's height is " + world::shown(source.height_m) + " m; it must lie within " + world::shown(kMaxHeight_m) + " m of 0.", "Lower it.");
  if (!(source.cell_m >= 0.0 && source.cell_m <= kMaxSize_m))
    return fail(ErrorKind::input, "cell_m is " + world::shown(source.cell_m) + " m; it must be above 0, or 0 to have it chosen.", "30 suits most worlds.");

  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  auto grid = made(source, size_x_m, size_z_m, sea_level_m, threads > 0 ? threads : cores);
  if (!grid) return tl::unexpected<Error>(std::move(grid.error()));
  grid->sea_level = sea_level_m;
  grid->finish();
  return Terrain(std::make_shared<const Grid>(std::move(*grid)));
}

Terrain::Terrain() {
  static const std::shared_ptr<const Grid> level = [] {
    Grid grid = *world::emptyGrid(1000.0, 1000.0, 2, 2);
    grid.finish();
    return std::make_shared<const Grid>(std::move(grid));
  }();
  grid_ = level;
}

double Terrain::height(double x_m, double z_m) const {
  const Place at = placeOf(*grid_, x_m, z_m);
  const float* north = grid_->row(at.row) + at.column;
  const float* south = north + grid_->columns;
  const double nw = north[0], ne = north[1], sw = south[0], se = south[1];
  const double on_north = nw + at.u * (ne - nw), on_south = sw + at.u * (se - sw);
  return on_north + at.v * (on_south - on_north);
}

Vec3 Terrain::normal(double x_m, double z_m) const {
  const Place at = placeOf(*grid_, x_m, z_m);
  const float* north = grid_->row(at.row) + at.column;
  const float* south = north + grid_->columns;
  const double nw = north[0], ne = north[1], sw = south[0], se = south[1];
  // Outside, the edge goes on level.
  const double east = x_m < 0.0 || x_m > grid_->size_x ? 0.0 : ((ne - nw) * (1.0 - at.v) + (se - sw) * at.v) / grid_->cell_x;
  const double south_rise = z_m < 0.0 || z_m > grid_->size_z ? 0.0 : ((sw - nw) * (1.0 - at.u) + (se - ne) * at.u) / grid_->cell_z;
  return (1.0 / std::sqrt(east * east + 1.0 + south_rise * south_rise)) * Vec3{-east, 1.0, -south_rise};
}

double Terrain::detail() const { return std::min(grid_->cell_x, grid_->cell_z); }
bool Terrain::flat() const { return grid_->lowest == grid_->highest; }
double Terrain::seaLevel() const { return grid_->sea_level; }
bool Terrain::sea(double x_m, double z_m) const { return height(x_m, z_m) < grid_->sea_level; }
double Terrain::surface(double x_m, double z_m) const { return std::max(height(x_m, z_m), grid_->sea_level); }
bool Terrain::inside(double x_m, double z_m) const { return x_m >= 0.0 && x_m <= grid_->size_x && z_m >= 0.0 && z_m <= grid_->size_z; }
double Terrain::sizeX() const { return grid_->size_x; }
double Terrain::sizeZ() const { return grid_->size_z; }
int Terrain::columns() const { return grid_->columns; }
int Terrain::rows() const { return grid_->rows; }
double Terrain::cellX() const { return grid_->cell_x; }
double Terrain::cellZ() const { return grid_->cell_z; }
std::span<const float> Terrain::heights() const { return grid_->heights; }
double Terrain::lowest() const { return grid_->lowest; }
double Terrain::highest() const { return grid_->highest; }

std::vector<ProfilePoint> Terrain::profile(const Vec3& a, const Vec3& b, int n) const {
  n = std::clamp(n, 2, 1'000'000);
  const double dx = b.x - a.x, dz = b.z - a.z, length_m = std::sqrt(dx * dx + dz * dz);
  std::vector<ProfilePoint> out(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) {
    const double share = static_cast<double>(i) / (n - 1);
    ProfilePoint& point = out[static_cast<std::size_t>(i)];
    point.distance_m = share * length_m;
    point.x = a.x + share * dx;
    point.z = a.z + share * dz;
    point.ground_m = height(point.x, point.z);
    point.surface_m = std::max(point.ground_m, grid_->sea_level);
  }
  return out;
}

std::string_view terrainKindName(TerrainKind kind) { return kKindNames[static_cast<std::size_t>(kind)]; }

std::optional<TerrainKind> terrainKindFrom(std::string_view name) {
  for (std::size_t i = 0; i < kKindNames.size(); ++i)
    if (kKindNames[i] == name) return static_cast<TerrainKind>(i);
  return std::nullopt;
}

}  // namespace npsee
