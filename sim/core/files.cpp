#include "sim/core/files.h"

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace npsee {
namespace {

namespace fs = std::filesystem;

/// Closes a descriptor on every way out.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  bool valid() const { return fd_ >= 0; }
  bool close() {
    const int fd = fd_;
    fd_ = -1;
    return fd < 0 || ::close(fd) == 0;
  }

 private:
  int fd_;
};

std::string reason() { return std::strerror(errno); }

tl::unexpected<Error> cannotRead(const fs::path& path, const std::string& why, std::string remedy = {}) {
  return fail(ErrorKind::input, {.what = "cannot be read: " + why + ".", .remedy = std::move(remedy), .file = path.string(), .line = 0, .pointer = {}});
}

tl::unexpected<Error> cannotWrite(const fs::path& path, const std::string& why) {
  return fail(ErrorKind::output,
              {.what = "cannot be written: " + why + ".", .remedy = "Choose another place or make room; nothing was changed.", .file = path.string(), .line = 0, .pointer = {}});
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

}  // namespace

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

Expected<void> writeFileAtomically(const fs::path& wanted, std::span<const std::byte> bytes) {
  const fs::path path = linkTarget(wanted);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return cannotWrite(wanted, "it is a folder");
  // Renaming over a device (/dev/full, /dev/null) would replace the device.
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) {
    const Descriptor direct(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (!direct.valid() || !writeAll(direct.get(), bytes)) return cannotWrite(wanted, reason());
    return {};
  }

  std::string temporary = (folder / ("." + path.filename().string() + ".XXXXXX")).string();
  Descriptor file(::mkostemp(temporary.data(), O_CLOEXEC));
  if (!file.valid()) return cannotWrite(wanted, errno == ENOENT ? "the folder does not exist" : reason());

  struct stat old {};
  // mkstemp makes files private; a new file gets what the umask leaves, a replaced one keeps its mode.
  mode_t mode = 0666;
  if (::stat(path.c_str(), &old) == 0) {
    mode = old.st_mode & 07777;
  } else {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    mode &= ~mask;
  }

  const bool written = writeAll(file.get(), bytes) && ::fchmod(file.get(), mode) == 0 && ::fsync(file.get()) == 0;
  const std::string why = written ? std::string() : reason();
  const bool closed = file.close();
  if (!written || !closed || ::rename(temporary.c_str(), path.c_str()) != 0) {
    const std::string cause = written ? reason() : why;
    ::unlink(temporary.c_str());
    return cannotWrite(wanted, cause);
  }
  const Descriptor parent(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (parent.valid()) ::fsync(parent.get());
  return {};
}

Expected<void> writeFileAtomically(const fs::path& path, std::string_view text) {
  return writeFileAtomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

}  // namespace npsee
