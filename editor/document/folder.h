#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace npsee::editor {

/// What a file dialog lists: the folders, presets and missions of one folder, folders first, each by name.
struct FolderListing {
  struct Entry {
    std::string name;
    bool folder = false;
  };
  std::filesystem::path folder;
  std::vector<Entry> entries;
  std::string problem;  ///< why nothing could be listed; empty if all is well
  bool shortened = false;  ///< there are more than kMaxEntries

  static constexpr std::size_t kMaxEntries = 2000;
};

/// Hidden names are left out; presets are `*.npsee.json`, missions `*.mission.json`. Never fails: see `problem`.
FolderListing listFolder(const std::filesystem::path& folder);

}  // namespace npsee::editor
