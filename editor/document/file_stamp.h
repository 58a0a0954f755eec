#pragma once

#include <cstdint>
#include <filesystem>

namespace npsee::editor {

/// What tells cheaply that a file may be another one than before: a save by renaming changes the inode, one in place the time.
struct FileStamp {
  bool exists = false;
  std::int64_t modified_ns = 0, size = 0;
  std::uint64_t inode = 0;
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
/// Never fails: what cannot be looked at does not exist.
FileStamp stampOf(const std::filesystem::path& path);

}  // namespace npsee::editor
