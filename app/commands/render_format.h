#pragma once

#include "app/render/video.h"

#include <npsee/error.h>

#include <string>
#include <string_view>

namespace npsee::commands {

/// What `npsee render` writes.
enum class FileFormat { png, exr, mp4, webm, gif };

inline bool isVideo(FileFormat format) { return format == FileFormat::mp4 || format == FileFormat::webm || format == FileFormat::gif; }
/// ".png"
std::string endingOf(FileFormat format);
render::VideoFormat videoFormatOf(FileFormat format);

/// The format that `--format` names, else that of the output's ending, else PNG. Error kind usage: unknown, or the two contradict.
Expected<FileFormat> readFormat(std::string_view format, const std::string& output);

}  // namespace npsee::commands
