#pragma once

#include "app/render/image.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace npsee::render {

enum class VideoFormat { mp4, webm, gif };

struct VideoSettings {
  VideoFormat format = VideoFormat::mp4;
  int width = 0, height = 0;                          ///< pixels; even for mp4 and webm
  std::int64_t rate_numerator = 30, rate_denominator = 1;  ///< frames per second
  bool alpha = false;                                 ///< keep transparency (webm, gif)
  std::string comment;                                ///< kept at the end of the file, up to 120 bytes
};

/// The `ffmpeg` program: $NPSEE_FFMPEG, or the first on the PATH. Error kind output names the Debian package.
Expected<std::filesystem::path> findFfmpeg();

/// The comment of a video that VideoWriter wrote; nothing for other files, and for a video whose end is missing.
std::optional<std::string> videoComment(const std::filesystem::path& path);

/// A video made by the ffmpeg program, which is started without a shell and gets the frames through a pipe. It appears under its
/// name when `finish` is called, and whole; without that nothing is left behind.
class VideoWriter {
 public:
  /// Error kind output: no ffmpeg, or no place to write.
  static Expected<VideoWriter> open(const std::filesystem::path& path, const VideoSettings& settings);
  VideoWriter(VideoWriter&&) noexcept;
  ~VideoWriter();

  /// Appends a frame of the settings' size. Error kind output with ffmpeg's words.
  Expected<void> add(const Image& frame);
  Expected<void> finish();

 private:
  struct Impl;
  explicit VideoWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace npsee::render
