#pragma once

#include <npsee/error.h>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace npsee::render {

/// 8-bit sRGB picture, rows from the top, 4 components (straight alpha), no padding.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;

  std::uint8_t* pixel(int x, int y) { return rgba.data() + 4 * (static_cast<std::size_t>(y) * width + x); }
  const std::uint8_t* pixel(int x, int y) const { return rgba.data() + 4 * (static_cast<std::size_t>(y) * width + x); }
};

/// PNG bytes; equal pictures give equal bytes. Alpha is left out when every pixel is opaque.
Expected<std::vector<std::uint8_t>> encodePng(const Image& image);

/// Encodes and writes atomically. Error kind output.
Expected<void> writePng(const Image& image, const std::filesystem::path& path);

/// Reads any 8-bit PNG, bounded in size. Error kind input.
Expected<Image> readPng(const std::filesystem::path& path);

}  // namespace npsee::render
