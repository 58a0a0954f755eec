#pragma once

#include <npsee/error.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace npsee {

/// Largest file of text the library reads (bytes); a limit against mistakes and hostile inputs.
inline constexpr std::size_t kMaxTextFile = 16u << 20;

/// Whole regular file as text. Error kind input: missing, unreadable, a folder, over `limit` bytes.
Expected<std::string> readTextFile(const std::filesystem::path& path, std::size_t limit = kMaxTextFile);

/// Writes to a temporary name in the same folder, syncs, renames: afterwards the file is whole, old or new. A symbolic link
/// is followed, and permissions of a replaced file are kept. Error kind output; the temporary file is removed.
Expected<void> writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
Expected<void> writeFileAtomically(const std::filesystem::path& path, std::string_view text);

}  // namespace npsee
