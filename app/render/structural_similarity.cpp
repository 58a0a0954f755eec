#include "app/render/image_compare.h"

#include "sim/core/elementary.h"

#include <algorithm>
#include <array>

namespace npsee::render {
namespace {

constexpr int kReach = 5, kTaps = 2 * kReach + 1;
constexpr double kC1 = 0.01 * 255.0 * 0.01 * 255.0, kC2 = 0.03 * 255.0 * 0.03 * 255.0;

using Row = std::vector<double>;

/// The window's weights along one axis; their sum is 1.
std::array<double, kTaps> window() {
  std::array<double, kTaps> weights{};
  double sum = 0.0;
  for (int k = 0; k < kTaps; ++k) sum += weights[static_cast<std::size_t>(k)] = exponential(-(k - kReach) * (k - kReach) / (2.0 * 1.5 * 1.5));
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// Luma of a row over a grey of `behind` levels, with the edges repeated `kReach` times on both sides.
void lumaRow(const DeepImage& image, int y, double behind, Row& out) {
  const auto width = static_cast<std::size_t>(image.width);
  out.resize(width + 2 * kReach);
  for (int x = 0; x < image.width; ++x) {
    const std::uint16_t* p = image.pixel(x, y);
    const double cover = p[3] / 65535.0;
    out[static_cast<std::size_t>(x) + kReach] = cover * (0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]) / 257.0 + (1.0 - cover) * behind;
  }
  std::fill_n(out.begin(), kReach, out[kReach]);
  std::fill_n(out.end() - kReach, kReach, out[width + kReach - 1]);
}

/// Weighted sums of a, b, a a, b b and a b over the window, for each pixel of a row.
struct Moments {
  std::array<Row, 5> sums;

  void reset(std::size_t width) {
    for (Row& row : sums) row.assign(width, 0.0);
  }
  /// Sums along the row.
  void take(const Row& a, const Row& b, const std::array<double, kTaps>& weights) {
    const std::size_t width = a.size() - 2 * kReach;
    reset(width);
    for (std::size_t k = 0; k < kTaps; ++k)
      for (std::size_t x = 0; x < width; ++x) {
        const double va = a[x + k], vb = b[x + k], wa = weights[k] * va, wb = weights[k] * vb;
        sums[0][x] += wa;
        sums[1][x] += wb;
        sums[2][x] += wa * va;
        sums[3][x] += wb * vb;
        sums[4][x] += wa * vb;
      }
  }
  void add(const Moments& row, double weight) {
    for (std::size_t i = 0; i < sums.size(); ++i)
      for (std::size_t x = 0; x < sums[i].size(); ++x) sums[i][x] += weight * row.sums[i][x];
  }
  double similarity() const {
    double total = 0.0;
    for (std::size_t x = 0; x < sums[0].size(); ++x) {
      const double ma = sums[0][x], mb = sums[1][x];
      const double va = sums[2][x] - ma * ma, vb = sums[3][x] - mb * mb, covariance = sums[4][x] - ma * mb;
      total += (2.0 * ma * mb + kC1) * (2.0 * covariance + kC2) / ((ma * ma + mb * mb + kC1) * (va + vb + kC2));
    }
    return total;
  }
};

/// Keeps the sums of the eleven rows that a window covers, so that memory does not grow with the picture.
double similarityOver(const DeepImage& a, const DeepImage& b, double behind) {
  const auto weights = window();
  std::array<Moments, kTaps> rows;
  Moments window_sums;
  Row luma_a, luma_b;
  double total = 0.0;
  int ready = 0;
  for (int y = 0; y < a.height; ++y) {
    for (; ready <= std::min(y + kReach, a.height - 1); ++ready) {
      lumaRow(a, ready, behind, luma_a);
      lumaRow(b, ready, behind, luma_b);
      rows[static_cast<std::size_t>(ready % kTaps)].take(luma_a, luma_b, weights);
    }
    window_sums.reset(static_cast<std::size_t>(a.width));
    for (int k = 0; k < kTaps; ++k) {
      const int row = std::clamp(y + k - kReach, 0, a.height - 1);
      window_sums.add(rows[static_cast<std::size_t>(row % kTaps)], weights[static_cast<std::size_t>(k)]);
    }
    total += window_sums.similarity();
  }
  return total / (static_cast<double>(a.width) * a.height);
}

}  // namespace

double structuralSimilarity(const DeepImage& a, const DeepImage& b) {
  const double over_black = similarityOver(a, b, 0.0);
  return a.alpha || b.alpha ? std::min(over_black, similarityOver(a, b, 255.0)) : over_black;
}

}  // namespace npsee::render
