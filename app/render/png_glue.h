#pragma once

#include <png.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

namespace npsee::render::png_glue {

/// libpng reports through callbacks and longjmp; the message is kept for the error.
struct Complaint {
  char text[200] = {};
};

inline void complain(png_structp png, png_const_charp text) {
  auto* complaint = static_cast<Complaint*>(png_get_error_ptr(png));
  std::snprintf(complaint->text, sizeof complaint->text, "%s", text);
  png_longjmp(png, 1);
}
inline void ignoreWarning(png_structp, png_const_charp) {}

/// Where libpng writes to.
inline void append(png_structp png, png_bytep data, png_size_t size) {
  auto* out = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
  out->insert(out->end(), data, data + size);
}
inline void flushNothing(png_structp) {}

/// Where libpng reads from.
struct Input {
  const std::uint8_t* at;
  std::size_t left;
};
inline void take(png_structp png, png_bytep data, png_size_t size) {
  auto* input = static_cast<Input*>(png_get_io_ptr(png));
  if (size > input->left) png_error(png, "it ends too early");
  std::memcpy(data, input->at, size);
  input->at += size;
  input->left -= size;
}

}  // namespace npsee::render::png_glue
