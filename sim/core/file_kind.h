#pragma once

#include <npsee/error.h>

#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

namespace npsee {

/// What a file of this program holds.
enum class FileKind { other, preset, mission, recording, projectile };

/// By the key of its version among those of its first object; the text need not be whole.
FileKind fileKindOf(std::string_view text);
/// By what stands in its first 64 KiB; `other` if it cannot be read.
FileKind fileKindAt(const std::filesystem::path& file);

/// The fault to tell of a file that could not be read because it is of another kind than the one `wanted`: what it is, and what takes it.
/// Nothing for files of that kind and of none.
std::optional<Fault> otherKind(std::string_view text, std::string_view file, FileKind wanted);

/// What was read of a text, or that fault in the place of those that a reader found in a file of another kind.
template <class Read>
Expected<Read> readAs(FileKind wanted, std::string_view text, std::string_view file, Expected<Read> read) {
  if (!read)
    if (auto other = otherKind(text, file, wanted)) return fail(ErrorKind::input, std::move(*other));
  return read;
}

}  // namespace npsee
