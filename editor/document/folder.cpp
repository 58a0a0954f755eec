#include "editor/document/folder.h"

#include "editor/document/file_document.h"

#include <algorithm>
#include <system_error>
#include <tuple>

namespace npsee::editor {

namespace fs = std::filesystem;

FolderListing listFolder(const fs::path& folder) {
  FolderListing out;
  std::error_code error;
  out.folder = fs::absolute(folder.empty() ? fs::path(".") : folder, error).lexically_normal();
  if (!out.folder.has_filename() && out.folder.has_parent_path() && out.folder != out.folder.root_path()) out.folder = out.folder.parent_path();
  auto entry = fs::directory_iterator(out.folder, error);
  for (; !error && entry != fs::end(entry); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    const bool is_folder = entry->is_directory(ignored);
    if (name.starts_with('.') || (!is_folder && !name.ends_with(kPresetEnding) && !name.ends_with(kMissionEnding))) continue;
    if (out.entries.size() == FolderListing::kMaxEntries) {
      out.shortened = true;
      break;
    }
    out.entries.push_back({name, is_folder});
  }
  if (error) out.problem = out.folder.string() + " cannot be read: " + error.message() + ".";
  std::ranges::sort(out.entries, [](const auto& a, const auto& b) { return std::tuple(!a.folder, a.name) < std::tuple(!b.folder, b.name); });
  return out;
}

}  // namespace npsee::editor
