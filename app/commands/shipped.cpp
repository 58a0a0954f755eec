#include "app/commands/shipped.h"

#include <CLI/CLI.hpp>

#include <string>
#include <system_error>

namespace npsee::commands {

namespace fs = std::filesystem;

fs::path shippedFolder(const fs::path& name) {
  std::error_code error;
  const fs::path binary = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  fs::path installed = binary.parent_path().parent_path() / "share" / "npsee" / name;
  if (fs::is_directory(installed, error)) return installed;
  fs::path folder = binary.parent_path();
  for (int up = 0; up < 4 && folder.has_relative_path(); ++up, folder = folder.parent_path())
    if (fs::is_directory(folder / name, error)) return folder / name;
  return {};
}

void acceptShipped(CLI::Option* option, const ShippedFiles& shipped) {
  option->transform([shipped](std::string given) {
    std::error_code ignored;
    // Only what can be nothing but a name: a path means its file, also where there is none.
    if (given.empty() || given.find_first_of("./") != std::string::npos || fs::exists(given, ignored)) return given;
    const fs::path folder = shippedFolder(shipped.folder);
    fs::path file = folder / (given + std::string(shipped.ending));
    return !folder.empty() && fs::is_regular_file(file, ignored) ? file.string() : given;
  });
}

}  // namespace npsee::commands
