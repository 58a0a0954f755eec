#pragma once

#include "app/render/float_image.h"

#include <npsee/error.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace npsee::render {

/// OpenEXR bytes; equal pictures give equal bytes. Colour goes into R, G, B and A as half floats (linear light with Rec. 709 primaries,
/// premultiplied), depth into Z and motion into forward.u and forward.v as single floats; a pass that is empty is left out. Lossless
/// (ZIP). `recipe` says from what the picture was made. Error kind output.
Expected<std::vector<std::uint8_t>> encodeExr(const FloatImage& image, std::string_view recipe);

/// What an OpenEXR file of ours holds.
struct ExrPicture {
  FloatImage image;
  std::string recipe;
};

/// Reads what encodeExr writes; `most_pixels` bounds what a header may claim. Error kind input for a damaged or foreign file; `name`
/// begins its message.
Expected<ExrPicture> parseExr(std::string_view bytes, const std::string& name, std::size_t most_pixels = 36'000'000);

}  // namespace npsee::render
