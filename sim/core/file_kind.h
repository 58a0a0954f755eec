#pragma once

#include <npsee/error.h>

#include <optional>
#include <string_view>

namespace npsee {

/// What a file of this program holds.
enum class FileKind { other, preset, mission, recording, projectile };

/// By the key of its version among those of its first object; the text need not be whole.
FileKind fileKindOf(std::string_view text);

/// The fault to tell of a file that could not be read because it is of another kind than the one `wanted`: what it is, and what takes it.
/// Nothing for files of that kind and of none.
std::optional<Fault> otherKind(std::string_view text, std::string_view file, FileKind wanted);

}  // namespace npsee
