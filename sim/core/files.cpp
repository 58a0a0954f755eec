#include "sim/core/files.h"

#include "sim/core/descriptor.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <optional>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace npsee {
namespace {

namespace fs = std::filesystem;

std::string reason() { return std::strerror(errno); }

tl::unexpected<Error> cannotRead(const fs::path& path, const std::string& why, std::string remedy = {}) {
  return fail(ErrorKind::input, {.what = "cannot be read: " + why + ".", .remedy = std::move(remedy), .file = path.string(), .line = 0, .pointer = {}});
}

bool writeAll(int fd, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(n));
  }
  return true;
}

/// The file a chain of symbolic links ends at, so that saving replaces the content and not the link.
fs::path linkTarget(fs::path path) {
  for (int hop = 0; hop < 16; ++hop) {
    std::error_code error;
    if (!fs::is_symlink(path, error) || error) break;
    const fs::path next = fs::read_symlink(path, error);
    if (error) break;
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// The mode of the file that is to be replaced; nothing if there is none.
std::optional<mode_t> modeOfOld(const fs::path& target) {
  struct stat old {};
  if (::stat(target.c_str(), &old) != 0) return std::nullopt;
  return old.st_mode & 07777;
}

/// What a temporary file is opened with: private where it takes over an old file's mode in the end, else what the kernel leaves of this by
/// the umask. To ask for the umask would be to set it, for all threads of the process.
mode_t modeToOpen(const std::optional<mode_t>& old) { return old ? 0600 : 0666; }

/// A hidden name in the folder of `target`, another for each attempt. A long name is cut at a character, so that this one is no longer than the
/// file system allows.
std::string temporaryName(const fs::path& target, int attempt) {
  constexpr std::size_t kKept = 100;
  std::string name = target.filename().string();
  if (name.size() > kKept) {
    std::size_t end = kKept;
    while (end > kKept - 4 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;
    name.resize(end);
  }
  return (folderOf(target) / ("." + name + "." + std::to_string(::getpid()) + "." + std::to_string(attempt))).string();
}

/// A name that survives a crash of the machine needs its folder on the disk too.
void syncFolder(const fs::path& folder) {
  const Descriptor parent(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (parent.valid()) ::fsync(parent.get());
}

/// Attempts at a name that is free. Names of this process's other threads and of killed ones of the same number are in the way.
constexpr int kAttempts = 1000;

/// Gives a file without a name a temporary one in the folder of `target`; empty if that is not possible.
std::string nameBeside(const Descriptor& file, const fs::path& target) {
  const std::string from = "/proc/self/fd/" + std::to_string(file.get());
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::string name = temporaryName(target, attempt);
    if (::linkat(AT_FDCWD, from.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) return name;
    if (errno != EEXIST) break;
  }
  return {};
}

/// Replaces by a file that has no name until it is whole, so that a process killed on the way leaves nothing behind. False where the file system has no
/// such files, or has no room: the caller then tries a file with a name, and tells what that says.
bool replacedByUnnamed(const fs::path& target, std::span<const std::byte> bytes) {
  const std::optional<mode_t> old = modeOfOld(target);
  Descriptor file(::open(folderOf(target).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, modeToOpen(old)));
  if (!file.valid() || !writeAll(file.get(), bytes) || (old && ::fchmod(file.get(), *old) != 0) || ::fsync(file.get()) != 0) return false;
  const std::string name = nameBeside(file, target);
  if (name.empty() || !file.close()) return false;
  if (::rename(name.c_str(), target.c_str()) == 0) return true;
  ::unlink(name.c_str());
  return false;
}

/// An empty file with a temporary name, which goes to `name`; not valid, with errno, if that is not possible.
Descriptor namedBeside(const fs::path& target, mode_t mode, std::string& name) {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    name = temporaryName(target, attempt);
    Descriptor file(::open(name.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, mode));
    if (file.valid() || errno != EEXIST) return file;
  }
  return Descriptor();
}

}  // namespace

tl::unexpected<Error> cannotWrite(const fs::path& path, const std::string& why, std::string remedy) {
  return fail(ErrorKind::output, {.what = "cannot be written: " + why + ".", .remedy = std::move(remedy), .file = path.string(), .line = 0, .pointer = {}});
}

Expected<std::string> readTextFile(const fs::path& path, std::size_t limit) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.valid()) {
    if (errno == ENOENT) return cannotRead(path, "there is no such file", "Check the path.");
    return cannotRead(path, reason());
  }
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return cannotRead(path, reason());
  if (S_ISDIR(status.st_mode)) return cannotRead(path, "it is a folder", "Name a file inside it.");
  // A pipe or device has no end that we could rely on.
  if (!S_ISREG(status.st_mode)) return cannotRead(path, "it is not a regular file", "Copy its content to a file first.");
  if (static_cast<std::uint64_t>(status.st_size) > limit)
    return cannotRead(path, "it has " + std::to_string(status.st_size) + " bytes, above the limit of " + std::to_string(limit));

  std::string text;
  char buffer[65536];
  for (;;) {
    const ssize_t n = ::read(file.get(), buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return cannotRead(path, reason());
    if (n == 0) return text;
    text.append(buffer, static_cast<std::size_t>(n));
    if (text.size() > limit) return cannotRead(path, "it grew above the limit of " + std::to_string(limit) + " bytes");
  }
}

bool isSpecialFile(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_regular_file(path, ignored) && !fs::is_directory(path, ignored);
}

Expected<TemporaryFile> TemporaryFile::beside(const fs::path& wanted) {
  std::error_code ignored;
  if (fs::is_directory(wanted, ignored)) return cannotWrite(wanted, "it is a folder");
  // Renaming over a device (/dev/full, /dev/null) would replace the device.
  if (isSpecialFile(wanted)) return cannotWrite(wanted, "it is no regular file");
  TemporaryFile out;
  out.wanted_ = wanted;
  out.target_ = linkTarget(wanted);
  const std::optional<mode_t> old = modeOfOld(out.target_);
  std::string name;
  const Descriptor file = namedBeside(out.target_, modeToOpen(old), name);
  if (!file.valid()) return cannotWrite(wanted, errno == ENOENT ? "the folder does not exist" : reason());
  out.path_ = name;
  struct stat made {};
  if (::fstat(file.get(), &made) != 0) return cannotWrite(wanted, reason());
  out.mode_ = old.value_or(made.st_mode & 07777);
  // Nobody else reads it before it is whole; its owner can open it whatever the umask is.
  ::fchmod(file.get(), 0600);
  return out;
}

TemporaryFile::TemporaryFile(TemporaryFile&& other) noexcept
    : wanted_(std::move(other.wanted_)), target_(std::move(other.target_)), path_(std::exchange(other.path_, {})), mode_(other.mode_) {}

TemporaryFile::~TemporaryFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

Expected<void> TemporaryFile::publish() {
  Descriptor file(::open(path_.c_str(), O_RDWR | O_CLOEXEC));
  if (!file.valid() || ::fchmod(file.get(), mode_) != 0 || ::fsync(file.get()) != 0 || !file.close() || ::rename(path_.c_str(), target_.c_str()) != 0) return cannotWrite(wanted_, reason());
  path_.clear();
  syncFolder(folderOf(target_));
  return {};
}

Expected<void> writeFileAtomically(const fs::path& wanted, std::span<const std::byte> bytes) {
  if (isSpecialFile(wanted)) {
    const Descriptor direct(::open(wanted.c_str(), O_WRONLY | O_CLOEXEC));
    if (!direct.valid() || !writeAll(direct.get(), bytes)) return cannotWrite(wanted, reason());
    return {};
  }
  std::error_code ignored;
  const fs::path target = linkTarget(wanted);
  if (!fs::is_directory(target, ignored) && replacedByUnnamed(target, bytes)) {
    syncFolder(folderOf(target));
    return {};
  }
  auto temporary = TemporaryFile::beside(wanted);
  if (!temporary) return tl::unexpected<Error>(temporary.error());
  Descriptor file(::open(temporary->path().c_str(), O_WRONLY | O_CLOEXEC));
  if (!file.valid() || !writeAll(file.get(), bytes) || !file.close()) return cannotWrite(wanted, reason());
  return temporary->publish();
}

Expected<void> writeFileAtomically(const fs::path& path, std::string_view text) {
  return writeFileAtomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace npsee
