#pragma once

#include "app/gl/objects.h"

#include <npsee/error.h>

#include <vector>

namespace npsee::render {

/// An RGBA32F texture of the given size. Error kind graphics when the driver has no room for it and its framebuffer `frame`.
Expected<gl::Texture> makeFloatTexture(int width, int height, gl::Framebuffer& frame);

/// Pixels from which float textures are given back after use, since they then take more memory than the picture itself.
inline constexpr long long kMostKeptPixels = 9'000'000;

/// Rows `first` to `first + rows` (from the lowest) of the bound framebuffer, four values per pixel, the lowest first.
void readRows(int width, int first, int rows, std::vector<float>& out);

/// Four values per pixel of the bound framebuffer, rows from the top.
void readFloats(int width, int height, std::vector<float>& out);

}  // namespace npsee::render
