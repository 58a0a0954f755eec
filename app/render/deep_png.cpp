#include "app/render/deep_image.h"

#include "app/render/png_text.h"
#include "sim/core/files.h"
#include "sim/core/png_glue.h"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

namespace npsee::render {
namespace {

/// Longest side that is read, pixels.
constexpr png_uint_32 kMaxSide = 65'536;
/// Largest file that is read, bytes: more than any picture we write can take.
constexpr std::size_t kMaxFile = 400u << 20;
/// Deflate packs at most 1032 bytes into one; a file much smaller than its header claims cannot hold its pixels.
constexpr std::size_t kMostPacking = 1032;
/// The low bytes of 16-bit colours hardly pack; trying harder takes three times as long for a tenth less.
constexpr int kDeflateLevel = 3;

/// What the header says, in the words of its fault, or null where it can be believed.
const char* headerFault(png_structp png, png_infop info, std::size_t file_bytes) {
  const std::size_t width = png_get_image_width(png, info), height = png_get_image_height(png, info);
  if (width * height > kMaxDeepPixels) return "it has more than 36 million pixels";
  const std::size_t bits = width * height * png_get_channels(png, info) * png_get_bit_depth(png, info);
  if (bits / 8 > (file_bytes + 64) * kMostPacking) return "its header claims more pixels than it can hold";
  return nullptr;
}

/// The part between setjmp and longjmp: only plain data lives here.
bool decodeRows(png_structp png, png_infop info, std::size_t file_bytes, DeepImage& image, std::vector<png_bytep>& rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_user_limits(png, kMaxSide, kMaxSide);
  // Bounds for what a file may hold beside its pixels (texts, profiles): each part, and how many.
  png_set_chunk_malloc_max(png, 4'000'000);
  png_set_chunk_cache_max(png, 64);
  png_read_info(png, info);
  if (const char* fault = headerFault(png, info, file_bytes)) png_error(png, fault);
  const png_uint_32 width = png_get_image_width(png, info), height = png_get_image_height(png, info);
  image.bits = png_get_bit_depth(png, info) == 16 ? 16 : 8;
  image.alpha = (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(png, info, PNG_INFO_tRNS) != 0;
  png_set_expand_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xffff, PNG_FILLER_AFTER);
  if (std::endian::native == std::endian::little) png_set_swap(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  if (png_get_rowbytes(png, info) != static_cast<std::size_t>(width) * 8) png_error(png, "its pixels are of an unknown kind");
  image.width = static_cast<int>(width);
  image.height = static_cast<int>(height);
  image.rgba.resize(static_cast<std::size_t>(width) * height * 4);
  for (png_uint_32 y = 0; y < height; ++y) rows.push_back(reinterpret_cast<png_bytep>(image.pixel(0, static_cast<int>(y))));
  png_read_image(png, rows.data());
  png_read_end(png, nullptr);
  return true;
}

bool encodeHeader(png_structp png, png_infop info, int width, int height, bool alpha) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 16, alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_compression_level(png, kDeflateLevel);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
  png_set_compression_buffer_size(png, 1u << 16);
  png_write_info(png, info);
  if (std::endian::native == std::endian::little) png_set_swap(png);
  return true;
}

/// `row` is room for a row without alpha, null where alpha is written.
bool encodeRows(png_structp png, const std::uint16_t* rgba, std::size_t width, std::size_t rows, std::uint16_t* row) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  for (std::size_t y = 0; y < rows; ++y) {
    const std::uint16_t* from = rgba + 4 * width * y;
    if (row != nullptr) {
      std::uint16_t* to = row;
      for (std::size_t x = 0; x < width; ++x, from += 4, to += 3) std::copy_n(from, 3, to);
      from = row;
    }
    png_write_row(png, reinterpret_cast<png_const_bytep>(from));
  }
  return true;
}

bool encodeEnd(png_structp png) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_write_end(png, nullptr);
  return true;
}

}  // namespace

DeepImage deepened(const Image& image) {
  DeepImage out{image.width, image.height, 8, false, {}};
  out.rgba.reserve(image.rgba.size());
  for (const std::uint8_t value : image.rgba) out.rgba.push_back(static_cast<std::uint16_t>(257 * value));
  for (std::size_t i = 3; i < image.rgba.size() && !out.alpha; i += 4) out.alpha = image.rgba[i] != 255;
  return out;
}

Expected<DeepImage> parseDeepPng(std::string_view text, const std::string& name) {
  const auto refuse = [&](const std::string& why) {
    return fail(ErrorKind::input, {.what = "is no picture that can be read: " + why + ".", .remedy = "Name a PNG file.", .file = name, .line = 0, .pointer = {}});
  };
  if (!png_glue::isPng(text)) return refuse("it is not a PNG file");
  const png_glue::Reading reading(text);
  DeepImage image;
  std::vector<png_bytep> rows;
  if (!reading || !decodeRows(reading.png(), reading.info(), text.size(), image, rows)) return refuse(reading.complaint());
  return image;
}

Expected<DeepImage> readDeepPng(const std::filesystem::path& path) {
  const auto text = readTextFile(path, kMaxFile);
  if (!text) return tl::unexpected<Error>(text.error());
  return parseDeepPng(*text, path.string());
}

struct DeepPngWriter::Impl {
  std::size_t width, height, done = 0;
  bool alpha;
  std::string recipe;
  std::vector<std::uint8_t> out;
  std::vector<std::uint16_t> row;
  png_glue::Writing writing{out};

  bool add(std::span<const std::uint16_t> rgba) {
    const std::size_t rows = rgba.size() / (4 * width);
    if (!writing || (done == 0 && !encodeHeader(writing.png(), writing.info(), static_cast<int>(width), static_cast<int>(height), alpha))) return false;
    if (done == 0 && !recipe.empty()) insertPngText(out, kRecipeKeyword, recipe);
    done += rows;
    return encodeRows(writing.png(), rgba.data(), width, rows, alpha ? nullptr : row.data()) && (done < height || encodeEnd(writing.png()));
  }
};

DeepPngWriter::DeepPngWriter(int width, int height, bool alpha, std::string_view recipe)
    : impl_(new Impl{.width = static_cast<std::size_t>(width), .height = static_cast<std::size_t>(height), .alpha = alpha, .recipe = std::string(recipe), .out = {}, .row = std::vector<std::uint16_t>(3 * static_cast<std::size_t>(width))}) {}
DeepPngWriter::~DeepPngWriter() = default;

Expected<std::vector<std::uint8_t>> DeepPngWriter::add(std::span<const std::uint16_t> rgba) {
  if (!impl_->add(rgba)) return fail(ErrorKind::output, std::string("a picture cannot be encoded as PNG: ") + impl_->writing.complaint() + ".");
  return std::exchange(impl_->out, {});
}

Expected<std::vector<std::uint8_t>> encodeDeepPng(const DeepImage& image) {
  const std::size_t values = static_cast<std::size_t>(std::max(image.width, 0)) * static_cast<std::size_t>(std::max(image.height, 0)) * 4;
  if (values == 0 || image.rgba.size() != values) return fail(ErrorKind::output, "an empty picture cannot be written as PNG.");
  return DeepPngWriter(image.width, image.height, image.alpha, {}).add(image.rgba);
}

}  // namespace npsee::render
