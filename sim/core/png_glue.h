#pragma once

#include <png.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace npsee::png_glue {

/// libpng reports through callbacks and longjmp. Whoever calls it does so in a function of its own that begins with
/// `if (setjmp(png_jmpbuf(png)) != 0) return false;` and owns nothing that has a destructor; the objects here live in its caller,
/// release libpng's state and keep its message.

/// The last error, as the end of a sentence without a full stop.
struct Complaint {
  char text[200] = "memory is short";
};

/// Whether the bytes begin as every PNG file does.
bool isPng(std::string_view bytes);

/// A PNG file in memory that is read. The bytes must outlive it.
class Reading {
 public:
  explicit Reading(std::string_view bytes);
  ~Reading();
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  /// False where libpng has no memory; then png() and info() must not be used.
  explicit operator bool() const { return info_ != nullptr; }
  png_structp png() const { return png_; }
  png_infop info() const { return info_; }
  const char* complaint() const { return complaint_.text; }

 private:
  static void take(png_structp png, png_bytep data, png_size_t size);

  Complaint complaint_;
  std::string_view left_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

/// A PNG file that is appended to `out`, which must outlive it.
class Writing {
 public:
  explicit Writing(std::vector<std::uint8_t>& out);
  ~Writing();
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;

  /// False where libpng has no memory; then png() and info() must not be used.
  explicit operator bool() const { return info_ != nullptr; }
  png_structp png() const { return png_; }
  png_infop info() const { return info_; }
  const char* complaint() const { return complaint_.text; }

 private:
  Complaint complaint_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace npsee::png_glue
