#pragma once

#include "app/render/deep_image.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace npsee::render {

/// A place where two pictures differ. Components are levels of 0..255 (whole numbers for 8-bit pictures), alpha last and straight.
struct WorstPlace {
  int x = 0, y = 0;
  double difference = 0.0;
  std::array<double, 4> before{}, after{};
};

/// How two pictures of equal size differ. Differences are absolute, in levels of 0..255, per component of the colour multiplied by
/// its alpha, and of alpha: a colour that cannot be seen does not count.
struct ImageDifference {
  int width = 0, height = 0;
  double max = 0.0;             ///< largest difference of a component
  double mean = 0.0;            ///< over all pixels and components (three, or four where a picture has alpha)
  double ssim = 1.0;            ///< structural similarity, 1 = equal
  std::size_t differing = 0;    ///< pixels with any difference
  std::size_t over = 0;         ///< pixels that differ by more than `threshold`
  double threshold = 2.0;
  std::vector<WorstPlace> worst;  ///< the worst pixel of each of the worst 16-pixel squares, worst first

  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  bool same() const { return differing == 0; }
};

/// Most places named.
inline constexpr std::size_t kWorstPlaces = 5;

/// Compares pictures of equal size, counting pixels over `threshold`.
ImageDifference compareImages(const DeepImage& before, const DeepImage& after, double threshold = 2.0);

/// Mean structural similarity of the luma of two pictures of equal size.
///
///   SSIM = (2 ma mb + C1)(2 sab + C2) / ((ma^2 + mb^2 + C1)(sa^2 + sb^2 + C2))
///
/// m, s^2, sab mean, variance and covariance in a Gaussian window of 11 x 11 pixels with a deviation of 1.5 pixels, C1 = (0.01 L)^2,
/// C2 = (0.03 L)^2, L = 255; beyond the border the picture's edge goes on. Pictures with alpha are laid over black and over white,
/// and the lower result counts. Source: Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment: from error visibility to structural
/// similarity", IEEE Trans. Image Processing 13(4), 2004.
double structuralSimilarity(const DeepImage& before, const DeepImage& after);

/// The first picture dimmed to grey, with every differing pixel in a colour from blue (one level) over red to yellow (all levels).
Image differencePicture(const DeepImage& before, const DeepImage& after);

/// What may differ. Limits that are not set do not count; none set: nothing may differ.
struct Tolerance {
  struct Share {
    double share = 0.0;  ///< of the pixels, 0..1
    double over = 0.0;   ///< levels
  };
  std::optional<double> max, mean, ssim;
  std::optional<Share> pixels;
  std::optional<double> light, depth_m, motion_px;  ///< of the passes of OpenEXR pictures

  bool exact() const { return !max && !mean && !ssim && !pixels && !light && !depth_m && !motion_px; }
  /// The level that pixels are counted over.
  double threshold() const { return pixels ? pixels->over : 2.0; }
};

/// Each limit that is exceeded, in words: "max 37 is above 2". Empty: within the tolerance.
std::vector<std::string> exceeded(const ImageDifference& difference, const Tolerance& tolerance);

}  // namespace npsee::render
