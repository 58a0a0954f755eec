#include "editor/document/library.h"

#include "editor/document/folder.h"
#include "editor/mission/document.h"

#include <npsee/preset.h>
#include <npsee/scenario.h>

namespace npsee::editor {

namespace fs = std::filesystem;

std::string bareName(const fs::path& file) {
  const std::string name = file.filename().string();
  for (const std::string_view ending : {kPresetEnding, kMissionEnding})
    if (name.size() > ending.size() && name.ends_with(ending)) return name.substr(0, name.size() - ending.size());
  return file.stem().string();
}

const LibraryEntry& Library::entry(const fs::path& file) {
  const FileStamp stamp = stampOf(file);
  const auto known = known_.find(file);
  if (known != known_.end() && known->second.stamp == stamp) return known->second.entry;
  const bool mission = isMissionFile(file);
  LibraryEntry out;
  const auto take = [&](const auto& document) {
    if (document) out = {file, document->title, document->description, {}, true, mission};
    else out = {file, {}, document.error().text(), {}, false, mission};
  };
  if (mission) {
    take(loadScenario(file));
  } else {
    const auto preset = loadPreset(file);
    take(preset);
    if (preset) out.tags = preset->tags;
  }
  return known_.insert_or_assign(file, Known{stamp, std::move(out)}).first->second.entry;
}

std::vector<LibraryEntry> Library::folder(const fs::path& folder, std::string_view ending) {
  std::vector<LibraryEntry> out;
  if (folder.empty()) return out;
  const FolderListing read = listFolder(folder);
  for (const FolderListing::Entry& listed : read.entries)
    if (!listed.folder && listed.name.ends_with(ending)) out.push_back(entry(read.folder / listed.name));
  return out;
}

}  // namespace npsee::editor
