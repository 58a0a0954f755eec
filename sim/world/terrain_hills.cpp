// Hills, valleys and sea from a seed. Noise says where the land rises and where the sea lies; rivers then cut the valleys, so that
// every slope drains to the sea or out of the map, as real country does; the result is drawn finer with a little noise.

#include "sim/core/parallel.h"
#include "sim/world/erosion.h"
#include "sim/world/noise.h"
#include "sim/world/terrain_grid.h"

#include <cmath>

namespace npsee::world {
namespace {

/// Uses of the seed; written values, part of every terrain's look.
enum class Use : std::uint32_t { continent = 1, uplift = 2, hardness = 3, start = 4, detail = 5, rim = 6 };

/// Samples of the eroded landscape, about; and the share of the world's longer side added around it, so that the rim lies outside.
constexpr double kNodes = 150'000.0, kMargin = 0.12;
/// Upstream area, in squared lengths of the hills, from which a stream has a valley floor.
constexpr double kStreamArea = 0.03;
constexpr double kFinestCell_m = 10.0, kCellsAlong = 1250.0;
/// The lowest land over the sea, as a share of the relief.
constexpr double kBeach = 0.008;

double smoothStep(double low, double high, double x) {
  const double s = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

/// Where the coarse landscape lies: sample (c, r) stands at x = origin_x + c step.
struct Frame {
  double origin_x = 0.0, origin_z = 0.0, step = 1.0;
  int columns = 0, rows = 0;
  double x(int c) const { return origin_x + c * step; }
  double z(int r) const { return origin_z + r * step; }
  Frame coarser(int factor) const { return {origin_x, origin_z, step * factor, (columns - 1) / factor + 1, (rows - 1) / factor + 1}; }
};

Frame frameFor(double size_x, double size_z, double cell) {
  const double margin = kMargin * std::max(size_x, size_z);
  const double wide = size_x + 2.0 * margin, high = size_z + 2.0 * margin;
  const double step = std::max(cell, std::sqrt(wide * high / kNodes));
  // Cells in fours, so that the coarser frames have lines in common.
  const auto samples = [step](double length) { return 4 * static_cast<int>(std::ceil(length / (4.0 * step))) + 1; };
  Frame frame{0.0, 0.0, step, samples(wide), samples(high)};
  frame.origin_x = 0.5 * (size_x - (frame.columns - 1) * step);
  frame.origin_z = 0.5 * (size_z - (frame.rows - 1) * step);
  return frame;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::ptrdiff_t>(std::lround(std::clamp(share, 0.0, 1.0) * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// The lie of the land before rivers: high and low country, 0 at the coast.
class Country {
 public:
  Country(const TerrainSource& source, double size_x, double size_z) : source_(source), size_(std::max(size_x, size_z)) {
    // The land falls towards one side, so that there is one sea rather than ponds.
    const std::uint32_t bits = mixedSeed(source.seed, static_cast<std::uint32_t>(Use::rim));
    const double a = (bits & 0xffffu) / 32768.0 - 1.0, b = (bits >> 16) / 32768.0 - 1.0, size = std::max(0.1, std::sqrt(a * a + b * b));
    tilt_x_ = a / size;
    tilt_z_ = b / size;
    if (source.sea_fraction <= 0.0) return;
    std::vector<double> inside;
    for (int r = 0; r < 128; ++r)
      for (int c = 0; c < 128; ++c) inside.push_back(at((c + 0.5) / 128.0 * size_x, (r + 0.5) / 128.0 * size_z));
    coast_ = quantile(std::move(inside), source.sea_fraction);
  }

  bool hasSea() const { return source_.sea_fraction > 0.0; }
  /// Negative under the sea.
  double at(double x, double z) const {
    const double wide = 1.3 * size_, near = 1.7 * source_.scale_m;
    const double slope = 1.1 * (tilt_x_ * x + tilt_z_ * z) / size_;
    return slope + 0.8 * gradientNoise(seed(Use::continent, 1), x / wide + 5.3, z / wide + 1.9) +
           0.35 * layeredNoise(seed(Use::continent, 0), x / near, z / near, 4, 0.5) - coast_;
  }
  double uplift(double x, double z) const {
    const double length = source_.scale_m;
    const double ranges = layeredNoise(seed(Use::uplift, 0), x / length, z / length, 3, 0.5);
    return 0.2 + smoothStep(-0.6, 0.8, ranges) * (0.6 + 0.4 * smoothStep(-0.3, 0.6, at(x, z)));
  }
  double hardness(double x, double z) const {
    const double length = 0.25 * source_.scale_m;
    return 1.0 + 0.45 * std::clamp(layeredNoise(seed(Use::hardness, 0), x / length, z / length, 3, 0.7), -1.0, 1.0);
  }
  std::uint32_t seed(Use use, std::uint32_t part) const { return mixedSeed(source_.seed, static_cast<std::uint32_t>(use) + 100u * part); }

 private:
  const TerrainSource& source_;
  double size_, tilt_x_ = 1.0, tilt_z_ = 0.0, coast_ = 0.0;
};

/// Fills in what does not change while rivers cut.
void prepare(Landscape& land, const Country& country, const Frame& frame, double scale, int threads) {
  const std::size_t size = static_cast<std::size_t>(frame.columns) * static_cast<std::size_t>(frame.rows);
  land.columns = frame.columns;
  land.rows = frame.rows;
  land.spacing = frame.step / scale;
  land.uplift.resize(size);
  land.hardness.resize(size);
  land.outlet.assign(size, 0);
  parallelFor(threads, static_cast<std::size_t>(frame.rows), [&](std::size_t row) {
    const int r = static_cast<int>(row);
    for (int c = 0; c < frame.columns; ++c) {
      const std::size_t i = land.index(c, r);
      const double x = frame.x(c), z = frame.z(r), lie = country.at(x, z);
      const bool rim = r == 0 || c == 0 || r + 1 == frame.rows || c + 1 == frame.columns;
      land.uplift[i] = country.uplift(x, z);
      land.hardness[i] = country.hardness(x, z);
      // Rivers leave by the sea and by the lower parts of the rim.
      land.outlet[i] = (country.hasSea() && lie < 0.0) || (rim && gradientNoise(country.seed(Use::rim, 1), x / scale, z / scale) < 0.0) ? 1 : 0;
    }
  });
  // One corner at least, or water would have nowhere to go.
  land.outlet[0] = 1;
  for (std::size_t i = 0; i < size && !land.height.empty(); ++i)
    if (land.outlet[i] != 0) land.height[i] = 0.0;
}

Landscape carved(const Country& country, const Frame& frame, double scale, int threads) {
  struct Stage {
    int factor, steps;
    double dt;
  };
  // Long on a coarse grid, where the great valleys form, and short on the finer ones.
  constexpr Stage kStages[] = {{4, 24, 0.5}, {2, 7, 0.4}, {1, 3, 0.3}};
  Landscape land;
  for (const Stage& stage : kStages) {
    const Frame here = frame.coarser(stage.factor);
    if (land.height.empty()) {
      land.columns = here.columns;
      land.height.resize(static_cast<std::size_t>(here.columns) * static_cast<std::size_t>(here.rows));
    } else {
      land = resampled(land, here.columns, here.rows);
    }
    const std::uint32_t seed = country.seed(Use::start, static_cast<std::uint32_t>(stage.factor));
    for (int r = 0; r < here.rows; ++r)
      for (int c = 0; c < here.columns; ++c) land.height[land.index(c, r)] += 0.02 * (latticeBits(seed, c, r) >> 8) / 16777216.0;
    prepare(land, country, here, scale, threads);
    erode(land, stage.steps, stage.dt);
  }
  return land;
}

void smooth(const Landscape& land, std::vector<double>& field) {
  std::vector<double> out = field;
  for (int r = 1; r + 1 < land.rows; ++r)
    for (int c = 1; c + 1 < land.columns; ++c) {
      const std::size_t i = land.index(c, r), up = land.index(c, r - 1), down = land.index(c, r + 1);
      out[i] = 0.25 * field[i] + 0.125 * (field[i - 1] + field[i + 1] + field[up] + field[down]) +
               0.0625 * (field[up - 1] + field[up + 1] + field[down - 1] + field[down + 1]);
    }
  field = std::move(out);
}

/// Height of each sample over the stream it drains to; the returned field is 0 along streams and under the sea.
std::vector<double> overStream(const Landscape& land) {
  const Drainage drainage = drainageOf(land);
  std::vector<double> stream(land.size()), over(land.size());
  for (const std::uint32_t at : drainage.order) {
    const bool wet = drainage.receiver[at] == at || drainage.area[at] >= kStreamArea;
    stream[at] = wet ? land.height[at] : stream[drainage.receiver[at]];
    over[at] = std::max(0.0, land.height[at] - stream[at]);
  }
  return over;
}

/// Heights over the sea in metres, and how rough the ground is (0 on floors and under the sea, 1 on hills), of every coarse sample.
struct Shape {
  std::vector<double> height_m, roughness;
};

Shape shaped(Landscape land, const TerrainSource& source, const Country& country, const Frame& frame, double relief) {
  std::vector<double> over = overStream(land);
  double mean = 0.0;
  for (const double d : over) mean += d / static_cast<double>(over.size());
  // Streams lay floors: d over the stream becomes d^2 / (d + w).
  const double floor = std::max(1e-9, 1.6 * source.valley * mean);
  std::vector<double> fill(land.size());
  for (std::size_t i = 0; i < fill.size(); ++i) fill[i] = over[i] * floor / (over[i] + floor);
  smooth(land, fill);
  std::vector<double> dry;
  for (std::size_t i = 0; i < land.size(); ++i) {
    if (land.outlet[i] != 0) continue;
    land.height[i] = std::max(0.0, land.height[i] - fill[i]);
    dry.push_back(land.height[i]);
  }
  smooth(land, land.height);
  const double top = std::max(1e-9, quantile(std::move(dry), 0.995));
  Shape out{std::vector<double>(land.size()), std::vector<double>(land.size())};
  for (int r = 0; r < land.rows; ++r)
    for (int c = 0; c < land.columns; ++c) {
      const std::size_t i = land.index(c, r);
      const double depth = country.hasSea() ? -country.at(frame.x(c), frame.z(r)) : -1.0;
      out.roughness[i] = depth > 0.0 ? 0.0 : 0.15 + 0.85 * smoothStep(0.1, 1.2, over[i] / std::max(1e-9, 2.0 * mean));
      out.height_m[i] = relief * (depth > 0.0 ? -0.8 * depth * depth / (depth + 0.15) - kBeach * smoothStep(0.0, 0.02, depth)
                                              : kBeach * smoothStep(-0.005, 0.02, country.hasSea() ? -depth : 1.0) + land.height[i] / top);
    }
  smooth(land, out.roughness);
  return out;
}

/// Weights of the cubic B-spline over four neighbouring samples: smooth to the second derivative and never beyond its samples.
struct Spline {
  int first;
  double weight[4];
};

Spline splineAt(double g, int samples) {
  const int i = std::clamp(static_cast<int>(std::floor(g)), 1, samples - 3);
  const double t = std::clamp(g - i, 0.0, 1.0), s = 1.0 - t;
  return {i - 1, {s * s * s / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0, (4.0 - 6.0 * s * s + 3.0 * s * s * s) / 6.0, t * t * t / 6.0}};
}

void drawFine(Terrain::Grid& grid, const Shape& shape, const Frame& frame, const Country& country, double sea_level, double relief, int threads) {
  std::vector<Spline> across(static_cast<std::size_t>(grid.columns));
  for (int c = 0; c < grid.columns; ++c) across[static_cast<std::size_t>(c)] = splineAt((c * grid.cell_x - frame.origin_x) / frame.step, frame.columns);
  const double wave = 4.0 * frame.step;
  int octaves = 0;
  for (double length = wave; length >= 4.0 * std::max(grid.cell_x, grid.cell_z) && octaves < 4; length *= 0.5) ++octaves;
  // Slopes of the drawn noise about the same at every size of the coarse cells.
  const double amplitude = std::min(0.05 * relief, 0.02 * wave);
  const std::uint32_t seed = country.seed(Use::detail, 0);
  parallelFor(threads, static_cast<std::size_t>(grid.rows), [&](std::size_t row) {
    const int r = static_cast<int>(row);
    const double z = r * grid.cell_z;
    const Spline down = splineAt((z - frame.origin_z) / frame.step, frame.rows);
    std::vector<double> height(static_cast<std::size_t>(frame.columns)), rough(height.size());
    for (std::size_t c = 0; c < height.size(); ++c)
      for (int k = 0; k < 4; ++k) {
        const std::size_t i = static_cast<std::size_t>(down.first + k) * height.size() + c;
        height[c] += down.weight[k] * shape.height_m[i];
        rough[c] += down.weight[k] * shape.roughness[i];
      }
    for (int c = 0; c < grid.columns; ++c) {
      const Spline& spline = across[static_cast<std::size_t>(c)];
      double h = 0.0, roughness = 0.0;
      for (int k = 0; k < 4; ++k) {
        h += spline.weight[k] * height[static_cast<std::size_t>(spline.first + k)];
        roughness += spline.weight[k] * rough[static_cast<std::size_t>(spline.first + k)];
      }
      if (octaves > 0 && roughness > 0.0) h += amplitude * roughness * layeredNoise(seed, c * grid.cell_x / wave, z / wave, octaves, 0.42);
      grid.row(r)[c] = static_cast<float>(sea_level + h);
    }
  });
}

Expected<void> checked(const TerrainSource& source) {
  Error error;
  const auto require = [&](bool holds, const char* name, double value, const char* bounds, const char* remedy) {
    if (!holds) error.faults.push_back({std::string("The hills' ") + name + " is " + shown(value) + "; it must be " + bounds + ".", remedy, {}, 0, {}});
  };
  require(source.relief_m >= 0.0 && source.relief_m <= 9000.0, "relief_m", source.relief_m, "from 0 to 9000 m", "250 makes hills, 1500 mountains.");
  require(source.scale_m >= 100.0 && source.scale_m <= Terrain::kMaxSize_m, "scale_m", source.scale_m, "from 100 to 1000000 m", "6000 is usual.");
  require(source.valley >= 0.0 && source.valley <= 1.0, "valley", source.valley, "from 0 to 1", "0.5 is usual.");
  require(source.sea_fraction >= 0.0 && source.sea_fraction <= 0.9, "sea_fraction", source.sea_fraction, "from 0 to 0.9", "0 leaves the sea out.");
  if (!error.faults.empty()) return tl::unexpected<Error>(std::move(error));
  return {};
}

}  // namespace

Expected<Terrain::Grid> hillsTerrain(const TerrainSource& source, double size_x, double size_z, double sea_level, int threads) {
  if (auto fine = checked(source); !fine) return tl::unexpected<Error>(fine.error());
  const double size = std::max(size_x, size_z);
  const double cell = source.cell_m > 0.0 ? source.cell_m : std::max(kFinestCell_m, size / kCellsAlong);
  auto grid = emptyGridOfCells(size_x, size_z, cell, cell);
  if (!grid) return grid;
  // A world smaller than its hills shows a part of one: the slopes stay.
  const double relief = source.relief_m * std::min(1.0, size / source.scale_m);
  const Country country(source, size_x, size_z);
  const Frame frame = frameFor(size_x, size_z, std::max(grid->cell_x, grid->cell_z));
  const Landscape land = carved(country, frame, source.scale_m, threads);
  drawFine(*grid, shaped(land, source, country, frame, relief), frame, country, sea_level, relief, threads);
  return grid;
}

}  // namespace npsee::world
