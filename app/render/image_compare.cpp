#include "app/render/image_compare.h"

#include <npsee/units.h>

#include <algorithm>
#include <cmath>

namespace npsee::render {
namespace {

constexpr int kSquare = 16;

/// A pixel with its colour multiplied by alpha, in levels.
std::array<double, 4> seen(const std::uint16_t* pixel) {
  const double cover = pixel[3] / 65535.0;
  return {pixel[0] / 257.0 * cover, pixel[1] / 257.0 * cover, pixel[2] / 257.0 * cover, pixel[3] / 257.0};
}

std::array<double, 4> levels(const std::uint16_t* pixel) { return {pixel[0] / 257.0, pixel[1] / 257.0, pixel[2] / 257.0, pixel[3] / 257.0}; }

struct PixelDifference {
  double max = 0.0, sum = 0.0;
};

PixelDifference differenceAt(const std::uint16_t* a, const std::uint16_t* b) {
  PixelDifference out;
  if (std::equal(a, a + 4, b)) return out;
  const auto before = seen(a), after = seen(b);
  for (std::size_t c = 0; c < 4; ++c) {
    const double d = std::abs(before[c] - after[c]);
    out.max = std::max(out.max, d);
    out.sum += d;
  }
  return out;
}

/// Keeps the worst pixel of each square.
class Worst {
 public:
  explicit Worst(int width) : columns_((width + kSquare - 1) / kSquare) {}

  void add(int x, int y, double difference) {
    const auto at = static_cast<std::size_t>(y / kSquare * columns_ + x / kSquare);
    if (at >= squares_.size()) squares_.resize(at + 1);
    if (difference > squares_[at].difference) squares_[at] = {x, y, difference, {}, {}};
  }

  std::vector<WorstPlace> places(const DeepImage& a, const DeepImage& b) {
    std::erase_if(squares_, [](const WorstPlace& place) { return place.difference == 0.0; });
    // Squares stand in reading order, so equal differences stay in it.
    std::ranges::stable_sort(squares_, std::greater(), &WorstPlace::difference);
    if (squares_.size() > kWorstPlaces) squares_.resize(kWorstPlaces);
    for (WorstPlace& place : squares_) {
      place.before = levels(a.pixel(place.x, place.y));
      place.after = levels(b.pixel(place.x, place.y));
    }
    return std::move(squares_);
  }

 private:
  int columns_;
  std::vector<WorstPlace> squares_;
};

/// Colour of a difference of `level` out of 255: blue, red, yellow. The root shows small ones.
std::array<double, 3> heat(double level) {
  const double t = std::sqrt(std::min(level / 255.0, 1.0));
  if (t < 0.5) return {40.0 + 2.0 * t * 215.0, 70.0 * (1.0 - 2.0 * t), 255.0 - 2.0 * t * 225.0};
  return {255.0, 20.0 + (2.0 * t - 1.0) * 215.0, 30.0};
}

std::uint8_t byte(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0))); }

}  // namespace

ImageDifference compareImages(const DeepImage& a, const DeepImage& b, double threshold) {
  ImageDifference out;
  out.width = a.width;
  out.height = a.height;
  out.threshold = threshold;
  Worst worst(a.width);
  double sum = 0.0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      const PixelDifference d = differenceAt(a.pixel(x, y), b.pixel(x, y));
      if (d.max == 0.0) continue;
      sum += d.sum;
      ++out.differing;
      if (d.max > threshold) ++out.over;
      out.max = std::max(out.max, d.max);
      worst.add(x, y, d.max);
    }
  if (out.same()) return out;
  out.mean = sum / (static_cast<double>(out.pixels()) * (a.alpha || b.alpha ? 4.0 : 3.0));
  out.ssim = structuralSimilarity(a, b);
  out.worst = worst.places(a, b);
  return out;
}

Image differencePicture(const DeepImage& a, const DeepImage& b) {
  Image out{a.width, a.height, {}};
  out.rgba.resize(a.rgba.size());
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      std::uint8_t* to = out.pixel(x, y);
      const double d = differenceAt(a.pixel(x, y), b.pixel(x, y)).max;
      if (d > 0.0) {
        const auto colour = heat(d);
        for (std::size_t c = 0; c < 3; ++c) to[c] = byte(colour[c]);
      } else {
        const auto was = seen(a.pixel(x, y));
        const std::uint8_t grey = byte(0.3 * (0.2126 * was[0] + 0.7152 * was[1] + 0.0722 * was[2]));
        to[0] = to[1] = to[2] = grey;
      }
      to[3] = 255;
    }
  return out;
}

std::vector<std::string> exceeded(const ImageDifference& d, const Tolerance& tolerance) {
  std::vector<std::string> out;
  const double max = tolerance.exact() ? 0.0 : tolerance.max.value_or(d.max);
  if (d.max > max) out.push_back("max " + shortest(d.max) + " is above " + shortest(max));
  if (tolerance.mean && d.mean > *tolerance.mean) out.push_back("mean " + shortest(d.mean) + " is above " + shortest(*tolerance.mean));
  if (tolerance.ssim && d.ssim < *tolerance.ssim) out.push_back("SSIM " + shortest(d.ssim) + " is below " + shortest(*tolerance.ssim));
  if (tolerance.pixels && static_cast<double>(d.over) > tolerance.pixels->share * static_cast<double>(d.pixels()))
    out.push_back(std::to_string(d.over) + " of " + std::to_string(d.pixels()) + " pixels differ by more than " + shortest(tolerance.pixels->over) + ", above " + shortest(100.0 * tolerance.pixels->share) + " %");
  return out;
}

}  // namespace npsee::render
