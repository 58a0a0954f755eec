#include "app/render/image.h"

#include "sim/core/files.h"
#include "sim/core/png_glue.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace npsee::render {
namespace {

/// Runs after the left neighbour is taken off: the fastest way through deflate, and for our pictures, whose skies and grounds
/// hardly change along a row, also one of the smallest (1280x720: 11 ms and 226 kB, level 6 without a filter 37 ms and 153 kB).
constexpr int kDeflateLevel = 1, kDeflateStrategy = Z_RLE, kRowFilter = PNG_FILTER_SUB;
/// Largest picture read, pixels on a side and in all: a header may claim anything.
constexpr png_uint_32 kMaxReadSide = 16384;
constexpr std::size_t kMaxReadPixels = 100'000'000;

bool opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255) return false;
  return true;
}

/// The part between setjmp and longjmp: only plain data lives here.
bool encodeRows(png_structp png, png_infop info, const Image& image, bool with_alpha, std::vector<std::uint8_t>& row) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  const auto width = static_cast<png_uint_32>(image.width), height = static_cast<png_uint_32>(image.height);
  png_set_IHDR(png, info, width, height, 8, with_alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_compression_level(png, kDeflateLevel);
  png_set_compression_strategy(png, kDeflateStrategy);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, kRowFilter);
  png_set_compression_buffer_size(png, 1u << 16);
  png_write_info(png, info);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* from = image.pixel(0, y);
    if (with_alpha) {
      png_write_row(png, from);
      continue;
    }
    std::uint8_t* to = row.data();
    for (int x = 0; x < image.width; ++x, from += 4, to += 3) std::memcpy(to, from, 3);
    png_write_row(png, row.data());
  }
  png_write_end(png, nullptr);
  return true;
}

bool decodeRows(png_structp png, png_infop info, Image& image, std::vector<png_bytep>& rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_user_limits(png, kMaxReadSide, kMaxReadSide);
  png_set_chunk_malloc_max(png, 8'000'000);
  png_read_info(png, info);
  const png_uint_32 width = png_get_image_width(png, info), height = png_get_image_height(png, info);
  if (static_cast<std::size_t>(width) * height > kMaxReadPixels) png_error(png, "it is larger than 100 million pixels");
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  if (png_get_rowbytes(png, info) != static_cast<std::size_t>(width) * 4) png_error(png, "its pixels are of an unknown kind");
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  image.rgba.resize(static_cast<std::size_t>(width) * height * 4);
  for (png_uint_32 y = 0; y < height; ++y) rows.push_back(image.pixel(0, static_cast<int>(y)));
  png_read_image(png, rows.data());
  png_read_end(png, nullptr);
  return true;
}

}  // namespace

Expected<std::vector<std::uint8_t>> encodePng(const Image& image) {
  const std::size_t bytes = static_cast<std::size_t>(std::max(image.width, 0)) * static_cast<std::size_t>(std::max(image.height, 0)) * 4;
  if (bytes == 0 || image.rgba.size() != bytes) return fail(ErrorKind::output, "an empty picture cannot be written as PNG.");
  std::vector<std::uint8_t> out;
  out.reserve(bytes / 4);
  std::vector<std::uint8_t> row(static_cast<std::size_t>(image.width) * 3);
  const png_glue::Writing writing(out);
  if (!writing || !encodeRows(writing.png(), writing.info(), image, !opaque(image), row))
    return fail(ErrorKind::output, std::string("a picture cannot be encoded as PNG: ") + writing.complaint() + ".");
  return out;
}

Expected<void> writePng(const Image& image, const std::filesystem::path& path) {
  const auto bytes = encodePng(image);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  return writeFileAtomically(path, std::as_bytes(std::span(*bytes)));
}

Expected<Image> readPng(const std::filesystem::path& path) {
  const auto refuse = [&](const std::string& why) {
    return fail(ErrorKind::input, {.what = "is no picture that can be read: " + why + ".", .remedy = "Name a PNG file.", .file = path.string(), .line = 0, .pointer = {}});
  };
  const auto text = readTextFile(path, 256u << 20);
  if (!text) return tl::unexpected<Error>(text.error());
  if (!png_glue::isPng(*text)) return refuse("it is not a PNG file");
  const png_glue::Reading reading(*text);
  Image image;
  std::vector<png_bytep> rows;
  if (!reading || !decodeRows(reading.png(), reading.info(), image, rows)) return refuse(reading.complaint());
  return image;
}

}  // namespace npsee::render
