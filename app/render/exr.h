#pragma once

#include "app/render/float_image.h"

#include <npsee/error.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace npsee::render {

/// OpenEXR bytes; equal pictures give equal bytes. Colour goes into R, G, B and A as half floats (linear light with Rec. 709 primaries,
/// premultiplied), depth into Z and motion into forward.u and forward.v as single floats; a pass that is empty is left out. Lossless
/// (ZIP). `recipe` says from what the picture was made. Error kind output.
Expected<std::vector<std::uint8_t>> encodeExr(const FloatImage& image, std::string_view recipe);

/// The same file written band by band, so that memory does not grow with the picture.
class ExrWriter {
 public:
  /// `passes` says what the bands hold. Error kind output; the file must be a regular one.
  static Expected<std::unique_ptr<ExrWriter>> open(const std::filesystem::path& path, int width, int height, const FloatRequest& passes, std::string_view recipe);
  ~ExrWriter();

  /// The next rows from the top. Error kind output.
  Expected<void> add(const FloatImage& band);
  /// After the last rows; without it the file is not complete. Error kind output.
  Expected<void> finish();

 private:
  struct Impl;
  explicit ExrWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// The recipe of a file of encodeExr or ExrWriter whose every row can be read; nothing for a damaged, unfinished or foreign one. In
/// little memory.
std::optional<std::string> recipeOfWholeExr(const std::filesystem::path& path);

/// What an OpenEXR file of ours holds.
struct ExrPicture {
  FloatImage image;
  std::string recipe;
};

/// Reads what encodeExr writes; `most_pixels` bounds what a header may claim. Error kind input for a damaged or foreign file; `name`
/// begins its message.
Expected<ExrPicture> parseExr(std::string_view bytes, const std::string& name, std::size_t most_pixels = 36'000'000);

}  // namespace npsee::render
