#pragma once

#include "app/render/image.h"

#include <filesystem>
#include <memory>

namespace npsee::render {

/// Encodes pictures as PNG, one after the other. A picture is compressed in bands of some rows that know nothing of each other, and a
/// band that is as it was in the picture before is not compressed again: in a sequence with a resting camera most of sky and ground.
/// The bytes depend on the picture alone, not on what was encoded before. Not for several threads at once.
class PngEncoder {
 public:
  /// What the next picture may share with this one is kept (a copy of the picture and its file's bytes), or not.
  enum class Keep { nothing, last };

  explicit PngEncoder(Keep keep = Keep::last);
  ~PngEncoder();
  PngEncoder(const PngEncoder&) = delete;
  PngEncoder& operator=(const PngEncoder&) = delete;

  /// PNG bytes; alpha is left out when every pixel is opaque. Error kind output.
  Expected<std::vector<std::uint8_t>> encode(const Image& image);
  /// The same into a file. Error kind output.
  Expected<void> write(const Image& image, const std::filesystem::path& path);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace npsee::render
