#include "app/render/image.h"

#include "app/render/png_encoder.h"
#include "sim/core/files.h"
#include "sim/core/png_glue.h"

#include <string>

namespace npsee::render {
namespace {

/// Largest picture read, pixels on a side and in all: a header may claim anything.
constexpr png_uint_32 kMaxReadSide = 16384;
constexpr std::size_t kMaxReadPixels = 100'000'000;

/// The part between setjmp and longjmp: only plain data lives here.
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

Expected<std::vector<std::uint8_t>> encodePng(const Image& image) { return PngEncoder(PngEncoder::Keep::nothing).encode(image); }

Expected<void> writePng(const Image& image, const std::filesystem::path& path) { return PngEncoder(PngEncoder::Keep::nothing).write(image, path); }

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
