#include "app/render/png_encoder.h"

#include "sim/core/files.h"
#include "sim/core/png_glue.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <string>

namespace npsee::render {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Runs after the left neighbour is taken off: the fastest way through deflate, and for our pictures, whose skies and grounds
/// hardly change along a row, also one of the smallest.
constexpr int kLevel = 1, kStrategy = Z_RLE, kMemory = 8;
constexpr std::uint8_t kTakeOffLeft = 1;
/// Filtered bytes of a band, unless one row has more. Beyond 65,274 deflate would shift its window, which takes a third of its time.
constexpr std::size_t kBandBytes = 65'000;
/// Larger pictures (bytes of pixels) are not kept for comparing.
constexpr std::size_t kMostKept = 64u << 20;

struct Band {
  Bytes packed;
  uLong checksum = 0;
};

/// The file around the compressed pixels. Between setjmp and longjmp: only plain data lives here.
bool writeFile(png_structp png, png_infop info, const Image& image, bool with_alpha, const Bytes& pixels) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  const auto width = static_cast<png_uint_32>(image.width), height = static_cast<png_uint_32>(image.height);
  png_set_IHDR(png, info, width, height, 8, with_alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  png_write_chunk(png, reinterpret_cast<png_const_bytep>("IDAT"), pixels.data(), pixels.size());
  // Not png_write_end(), which counts the rows that it has compressed itself.
  png_write_chunk(png, reinterpret_cast<png_const_bytep>("IEND"), nullptr, 0);
  return true;
}

bool opaque(const Image& image) {
  const std::uint8_t* const pixels = image.rgba.data();
  for (int y = 0; y < image.height; ++y) {
    // A row at a time without a way out: the compiler makes vectors of it.
    std::uint8_t all = 255;
    const std::uint8_t* const row = pixels + 4 * static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
    for (std::size_t i = 3; i < 4 * static_cast<std::size_t>(image.width); i += 4) all &= row[i];
    if (all != 255) return false;
  }
  return true;
}

/// A row's filter byte and its pixels less their left neighbours. Writes up to a byte beyond the row.
void filterRow(const std::uint8_t* __restrict row, std::size_t width, bool with_alpha, std::uint8_t* __restrict difference, std::uint8_t* __restrict to) {
  *to++ = kTakeOffLeft;
  std::memcpy(difference, row, 4);
  for (std::size_t i = 4; i < 4 * width; ++i) difference[i] = static_cast<std::uint8_t>(row[i] - row[i - 4]);
  if (with_alpha) {
    std::memcpy(to, difference, 4 * width);
    return;
  }
  for (std::size_t x = 0; x < width; ++x) std::memcpy(to + 3 * x, difference + 4 * x, 4);
}

tl::unexpected<Error> broken(const std::string& why) { return fail(ErrorKind::output, "a picture cannot be encoded as PNG: " + why + "."); }

}  // namespace

struct PngEncoder::Impl {
  explicit Impl(Keep wanted) : keep(wanted) {}
  ~Impl() {
    if (started) deflateEnd(&stream);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  int start();
  int packBand(const Image& image, int first_row, int rows, Band& band);
  bool unchanged(const Image& image, int first_row, int rows) const;
  int packAll(const Image& image);
  Bytes pixelStream(const Image& image) const;

  Keep keep;
  z_stream stream{};
  bool started = false;
  bool with_alpha = false;
  Image before;  ///< picture the bands are of; empty if it is not kept
  int band_rows = 0;
  std::vector<Band> bands;
  Bytes difference, filtered, room;
};

int PngEncoder::Impl::start() {
  if (started) return Z_OK;
  // Raw deflate: the frame around the bands is written by pixelStream().
  const int code = deflateInit2(&stream, kLevel, Z_DEFLATED, -MAX_WBITS, kMemory, kStrategy);
  started = code == Z_OK;
  return code;
}

int PngEncoder::Impl::packBand(const Image& image, int first_row, int rows, Band& band) {
  const auto width = static_cast<std::size_t>(image.width);
  const std::size_t stride = 1 + (with_alpha ? 4 : 3) * width, size = stride * static_cast<std::size_t>(rows);
  filtered.resize(size + 1);
  difference.resize(4 * width);
  for (int y = 0; y < rows; ++y) filterRow(image.pixel(0, first_row + y), width, with_alpha, difference.data(), filtered.data() + stride * static_cast<std::size_t>(y));
  band.checksum = adler32_z(adler32_z(0, nullptr, 0), filtered.data(), size);

  if (const int code = deflateReset(&stream); code != Z_OK) return code;
  // Some bytes more than the bound: it does not count the mark at a flush.
  room.resize(std::max<std::size_t>(room.size(), deflateBound(&stream, static_cast<uLong>(size)) + 16));
  stream.next_in = filtered.data();
  stream.avail_in = static_cast<uInt>(size);
  stream.next_out = room.data();
  stream.avail_out = static_cast<uInt>(room.size());
  const bool last = first_row + rows == image.height;
  const int code = deflate(&stream, last ? Z_FINISH : Z_FULL_FLUSH);
  if (code != (last ? Z_STREAM_END : Z_OK) || stream.avail_out == 0) return code == Z_OK ? Z_BUF_ERROR : code;
  band.packed.assign(room.data(), stream.next_out);
  return Z_OK;
}

bool PngEncoder::Impl::unchanged(const Image& image, int first_row, int rows) const {
  if (before.rgba.empty()) return false;
  return std::memcmp(image.pixel(0, first_row), before.pixel(0, first_row), 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(rows)) == 0;
}

int PngEncoder::Impl::packAll(const Image& image) {
  const bool alpha = !opaque(image);
  if (image.width != before.width || image.height != before.height || alpha != with_alpha) before = Image{};
  with_alpha = alpha;
  const std::size_t stride = 1 + (with_alpha ? 4 : 3) * static_cast<std::size_t>(image.width);
  band_rows = static_cast<int>(std::clamp<std::size_t>(kBandBytes / stride, 1, static_cast<std::size_t>(image.height)));
  bands.resize(static_cast<std::size_t>((image.height + band_rows - 1) / band_rows));
  for (int first = 0; first < image.height; first += band_rows) {
    const int rows = std::min(band_rows, image.height - first);
    if (unchanged(image, first, rows)) continue;
    if (const int code = packBand(image, first, rows, bands[static_cast<std::size_t>(first / band_rows)]); code != Z_OK) return code;
    if (!before.rgba.empty()) std::memcpy(before.pixel(0, first), image.pixel(0, first), 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(rows));
  }
  if (keep == Keep::last && before.rgba.empty() && image.rgba.size() <= kMostKept) before = image;
  return Z_OK;
}

Bytes PngEncoder::Impl::pixelStream(const Image& image) const {
  Bytes out;
  std::size_t size = 6;
  for (const Band& band : bands) size += band.packed.size();
  out.reserve(size);
  // zlib's header: deflate with a window of 32 KiB, fastest level; its check number over all bands ends the stream.
  out.insert(out.end(), {0x78, 0x01});
  uLong checksum = adler32_z(0, nullptr, 0);
  const std::size_t stride = 1 + (with_alpha ? 4 : 3) * static_cast<std::size_t>(image.width);
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const int rows = std::min(band_rows, image.height - static_cast<int>(i) * band_rows);
    out.insert(out.end(), bands[i].packed.begin(), bands[i].packed.end());
    checksum = adler32_combine(checksum, bands[i].checksum, static_cast<z_off_t>(stride * static_cast<std::size_t>(rows)));
  }
  for (const int shift : {24, 16, 8, 0}) out.push_back(static_cast<std::uint8_t>(checksum >> shift));
  return out;
}

PngEncoder::PngEncoder(Keep keep) : impl_(std::make_unique<Impl>(keep)) {}
PngEncoder::~PngEncoder() = default;

Expected<std::vector<std::uint8_t>> PngEncoder::encode(const Image& image) {
  const std::size_t bytes = static_cast<std::size_t>(std::max(image.width, 0)) * static_cast<std::size_t>(std::max(image.height, 0)) * 4;
  if (bytes == 0 || image.rgba.size() != bytes) return fail(ErrorKind::output, "an empty picture cannot be written as PNG.");
  int code = impl_->start();
  if (code == Z_OK) code = impl_->packAll(image);
  if (code != Z_OK) {
    // Some bands may be of this picture and some of the one before.
    impl_->before = Image{};
    return broken(code == Z_MEM_ERROR ? "memory is short" : "zlib failed");
  }
  const Bytes pixels = impl_->pixelStream(image);
  Bytes out;
  out.reserve(pixels.size() + 256);
  const png_glue::Writing writing(out);
  if (!writing || !writeFile(writing.png(), writing.info(), image, impl_->with_alpha, pixels)) return broken(writing.complaint());
  return out;
}

Expected<void> PngEncoder::write(const Image& image, const std::filesystem::path& path) {
  const auto bytes = encode(image);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  return writeFileAtomically(path, std::as_bytes(std::span(*bytes)));
}

}  // namespace npsee::render
