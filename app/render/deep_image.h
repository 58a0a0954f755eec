#pragma once

#include "app/render/image.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace npsee::render {

/// 16-bit sRGB picture, rows from the top, 4 components (straight alpha), no padding. An 8-bit value v is held as 257 v, so that
/// pictures of both depths share one scale.
struct DeepImage {
  int width = 0, height = 0;
  int bits = 8;        ///< of the file it came from: 8 or 16
  bool alpha = false;  ///< whether the file has an alpha channel, or a pixel is not opaque
  std::vector<std::uint16_t> rgba;

  const std::uint16_t* pixel(int x, int y) const { return rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)); }
  std::uint16_t* pixel(int x, int y) { return rgba.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)); }
};

/// Most pixels of a picture that is read: all that `npsee render` writes fits.
inline constexpr std::size_t kMaxDeepPixels = 36'000'000;

DeepImage deepened(const Image& image);

/// Reads a PNG of any depth and colour type. Size and plausibility of the header are checked before memory is taken for the
/// pixels. Error kind input.
Expected<DeepImage> readDeepPng(const std::filesystem::path& path);
/// The same from bytes; `name` begins the messages.
Expected<DeepImage> parseDeepPng(std::string_view bytes, const std::string& name);

/// PNG bytes with 16 bits per component; equal pictures give equal bytes. The alpha channel is written where `alpha` is set.
Expected<std::vector<std::uint8_t>> encodeDeepPng(const DeepImage& image);

/// The same file made band by band, so that memory does not grow with the picture.
class DeepPngWriter {
 public:
  DeepPngWriter(int width, int height, bool alpha, std::string_view recipe);
  ~DeepPngWriter();

  /// The bytes that the next rows from the top add to the file; of the first also the header. Rows lie as in DeepImage. Error kind output.
  Expected<std::vector<std::uint8_t>> add(std::span<const std::uint16_t> rgba);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace npsee::render
