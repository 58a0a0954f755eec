#include "editor/desk/work_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace npsee::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kStart = "npsee-export-";

Expected<fs::path> temporaryFolder() {
  std::error_code none;
  fs::path base = fs::temp_directory_path(none);
  if (!none) return base;
  std::string named = "/tmp cannot be used.";
  for (const char* variable : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"})
    if (const char* set = std::getenv(variable); set != nullptr) {
      named = std::string(variable) + " is \"" + set + "\".";
      break;
    }
  return fail(ErrorKind::output, "There is no folder for temporary files: " + named, "Set TMPDIR to a folder that can be written.");
}

Descriptor opened(const fs::path& folder) { return Descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)); }

/// Removes what editors have left that were killed: folders of this user that nobody has locked.
void removeLeftovers(const fs::path& base) {
  std::error_code error, ignored;
  for (auto entry = fs::directory_iterator(base, error); !error && entry != fs::end(entry); entry.increment(error)) {
    if (!entry->path().filename().string().starts_with(kStart)) continue;
    const Descriptor folder = opened(entry->path());
    struct stat status {};
    if (!folder.valid() || ::fstat(folder.get(), &status) != 0 || status.st_uid != ::geteuid()) continue;
    if (::flock(folder.get(), LOCK_EX | LOCK_NB) == 0) fs::remove_all(entry->path(), ignored);
  }
}

/// False if another editor, making one just now, took the folder for one left behind. Where nothing can be locked nothing is taken either.
bool locked(const fs::path& path, const Descriptor& folder) {
  struct stat held {}, there {};
  if (!folder.valid() || (::flock(folder.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)) return false;
  return ::fstat(folder.get(), &held) == 0 && ::lstat(path.c_str(), &there) == 0 && held.st_ino == there.st_ino && held.st_dev == there.st_dev;
}

}  // namespace

Expected<WorkFolder> WorkFolder::make() {
  const auto base = temporaryFolder();
  if (!base) return tl::unexpected<Error>(base.error());
  removeLeftovers(*base);
  constexpr int kTries = 20;
  std::string why = "another program removes it at once";
  for (int i = 0; i < kTries; ++i) {
    std::string name = (*base / (std::string(kStart) + "XXXXXX")).string();
    if (::mkdtemp(name.data()) == nullptr) {
      why = std::strerror(errno);
      break;
    }
    Descriptor folder = opened(name);
    if (locked(name, folder)) return WorkFolder(std::move(name), std::move(folder));
  }
  return fail(ErrorKind::output, "No folder for temporary files can be made in " + base->string() + ": " + why + ".", "Make room there, or set TMPDIR to a folder that can be written.");
}

WorkFolder& WorkFolder::operator=(WorkFolder&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(lock_, other.lock_);
  return *this;
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  if (lock_.valid()) fs::remove_all(path_, ignored);
}

}  // namespace npsee::editor
