#pragma once

#include "app/gl/objects.h"

#include <npsee/error.h>

#include <vector>

namespace npsee::render {

/// An RGBA32F texture of the given size. Error kind graphics when the driver has no room for it and its framebuffer `frame`.
Expected<gl::Texture> makeFloatTexture(int width, int height, gl::Framebuffer& frame);

/// Rows of a picture, counted from its top, that are drawn at a time.
struct RowBand {
  int first = 0, rows = 0;
  int height = 0;  ///< of the whole picture

  /// Row of the picture, counted from the lowest, that is the band's lowest.
  int low() const { return height - first - rows; }
};

/// Sets the viewport of a picture of that width so that the bound framebuffer, as high as the band, holds the band's rows.
void showBand(const RowBand& band, int width);

/// Rows of the bound framebuffer from its lowest, four values per pixel, the lowest first.
void readRows(int width, int rows, std::vector<float>& out);

/// The same from the uppermost.
void readFloats(int width, int rows, std::vector<float>& out);

}  // namespace npsee::render
