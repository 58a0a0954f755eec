#include "editor/document/file_stamp.h"

#include <sys/stat.h>

namespace npsee::editor {

FileStamp stampOf(const std::filesystem::path& path) {
  struct stat status {};
  if (path.empty() || ::stat(path.c_str(), &status) != 0) return {};
  return {true, static_cast<std::int64_t>(status.st_mtim.tv_sec) * 1'000'000'000 + status.st_mtim.tv_nsec, status.st_size, status.st_ino};
}

}  // namespace npsee::editor
