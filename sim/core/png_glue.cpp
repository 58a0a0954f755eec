#include "sim/core/png_glue.h"

#include <cstdio>
#include <cstring>
#include <new>

namespace npsee::png_glue {
namespace {

[[noreturn]] void complain(png_structp png, png_const_charp text) {
  auto* complaint = static_cast<Complaint*>(png_get_error_ptr(png));
  std::snprintf(complaint->text, sizeof complaint->text, "%s", text);
  png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

bool appended(std::vector<std::uint8_t>& out, const std::uint8_t* data, std::size_t size) {
  try {
    out.insert(out.end(), data, data + size);
    return true;
  } catch (const std::bad_alloc&) {
    return false;  // an exception must not pass through libpng
  }
}

void append(png_structp png, png_bytep data, png_size_t size) {
  if (!appended(*static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png)), data, size)) png_error(png, "memory is short");
}

void flushNothing(png_structp) {}

/// The bytes up to a chunk that claims to be longer than the rest of the file. libpng takes memory for a chunk by its word, up to 2 GiB.
std::string_view beforeFalseChunk(std::string_view bytes) {
  constexpr std::size_t kSignature = 8, kLength = 4, kAround = 12;  // length, name and checksum of a chunk
  for (std::size_t at = kSignature; at < bytes.size() && bytes.size() - at >= kLength;) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < kLength; ++i) length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
    if (length > bytes.size() - at) return bytes.substr(0, at);
    at += length + kAround;
  }
  return bytes;
}

}  // namespace

bool isPng(std::string_view bytes) { return bytes.size() >= 8 && png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) == 0; }

Reading::Reading(std::string_view bytes) : left_(beforeFalseChunk(bytes)), png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &complaint_, complain, ignoreWarning)) {
  if (png_ != nullptr) info_ = png_create_info_struct(png_);
  if (info_ != nullptr) png_set_read_fn(png_, this, take);
}

Reading::~Reading() { png_destroy_read_struct(&png_, &info_, nullptr); }

void Reading::take(png_structp png, png_bytep data, png_size_t size) {
  std::string_view& left = static_cast<Reading*>(png_get_io_ptr(png))->left_;
  if (size > left.size()) png_error(png, "it ends too early");
  std::memcpy(data, left.data(), size);
  left.remove_prefix(size);
}

Writing::Writing(std::vector<std::uint8_t>& out) : png_(png_create_write_struct(PNG_LIBPNG_VER_STRING, &complaint_, complain, ignoreWarning)) {
  if (png_ != nullptr) info_ = png_create_info_struct(png_);
  if (info_ != nullptr) png_set_write_fn(png_, &out, append, flushNothing);
}

Writing::~Writing() { png_destroy_write_struct(&png_, &info_); }

}  // namespace npsee::png_glue
