#pragma once

#include <npsee/error.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include <sys/types.h>

namespace npsee {

/// Largest file of text the library reads (bytes); a limit against mistakes and hostile inputs.
inline constexpr std::size_t kMaxTextFile = 16u << 20;

/// Whole regular file as text. Error kind input: missing, unreadable, a folder, over `limit` bytes.
Expected<std::string> readTextFile(const std::filesystem::path& path, std::size_t limit = kMaxTextFile);

/// The error of a file that cannot be written; `why` is the end of a sentence without a full stop.
tl::unexpected<Error> cannotWrite(const std::filesystem::path& path, const std::string& why, std::string remedy = "Choose another place or make room; nothing was changed.");

/// Writes to a temporary name in the same folder, syncs, renames: afterwards the file is whole, old or new. A symbolic link
/// is followed; a replaced file keeps its permissions, a new one gets what the umask leaves of rw-rw-rw-. Any number of threads may write at a
/// time. Error kind output; the temporary file is removed.
Expected<void> writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
Expected<void> writeFileAtomically(const std::filesystem::path& path, std::string_view text);

/// Whether something is there that is neither file nor folder, such as a device or a pipe: it is written straight through, never replaced.
bool isSpecialFile(const std::filesystem::path& path);

/// A file that another program fills, and that then replaces `wanted` as writeFileAtomically does. Removed if it is not published.
class TemporaryFile {
 public:
  /// An empty file in the folder of `wanted`. Error kind output: no such folder, not ours to write, or `wanted` is special.
  static Expected<TemporaryFile> beside(const std::filesystem::path& wanted);
  TemporaryFile(TemporaryFile&& other) noexcept;
  ~TemporaryFile();

  const std::filesystem::path& path() const { return path_; }
  /// Syncs and renames it. Error kind output.
  Expected<void> publish();

 private:
  TemporaryFile() = default;
  std::filesystem::path wanted_, target_, path_;
  mode_t mode_ = 0;  ///< it gets in the end
};

}  // namespace npsee
