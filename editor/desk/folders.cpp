#include "editor/desk/folders.h"

#include <cstdlib>

namespace npsee::editor {
namespace {

namespace fs = std::filesystem;

fs::path baseFolder(const char* variable, const char* below_home) {
  // "All paths set in these environment variables must be absolute"; others are to be ignored.
  if (const char* set = std::getenv(variable); set != nullptr && *set == '/') return fs::path(set) / "npsee";
  const char* home = std::getenv("HOME");
  return home != nullptr && *home == '/' ? fs::path(home) / below_home / "npsee" : fs::path();
}

}  // namespace

DeskFolders xdgFolders() { return {baseFolder("XDG_CONFIG_HOME", ".config"), baseFolder("XDG_STATE_HOME", ".local/state"), baseFolder("XDG_CACHE_HOME", ".cache")}; }

}  // namespace npsee::editor
