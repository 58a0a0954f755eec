#pragma once

#include "app/gl/objects.h"

#include <npsee/error.h>

#include <vector>

namespace npsee::render {

/// An RGBA32F texture of the given size. Error kind graphics when the driver has no room for it and its framebuffer `frame`.
Expected<gl::Texture> makeFloatTexture(int width, int height, gl::Framebuffer& frame);

/// Four values per pixel of the bound framebuffer, rows from the top.
void readFloats(int width, int height, std::vector<float>& out);

}  // namespace npsee::render
