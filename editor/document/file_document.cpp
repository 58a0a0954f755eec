#include "editor/document/file_document.h"

namespace npsee::editor {

std::string FileDocument::name() const {
  if (path_.empty()) return "untitled";
  std::string name = path_.filename().string();
  for (const std::string_view ending : {ending_, std::string_view(".json")})
    if (name.size() > ending.size() && name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  return name;
}

std::filesystem::path FileDocument::fileFor(const std::filesystem::path& path) const {
  std::string name = path.filename().string();
  if (name.empty() || name.ends_with(ending_)) return path;
  for (const std::string_view other : {kPresetEnding, kMissionEnding, std::string_view(".json")})
    if (name.size() > other.size() && name.ends_with(other)) {
      name.resize(name.size() - other.size());
      break;
    }
  return path.parent_path() / (name + std::string(ending_));
}

void FileDocument::jump(int steps) {
  for (; steps < 0 && undo(); ++steps) {}
  for (; steps > 0 && redo(); --steps) {}
}

Expected<void> FileDocument::missingFile() const { return fail(ErrorKind::output, "The " + std::string(what_) + " has no file yet.", "Use Save as and give it a name."); }

Expected<void> FileDocument::missingName() { return fail(ErrorKind::output, "The name of the file is missing.", "Write a name after the folder."); }

}  // namespace npsee::editor
