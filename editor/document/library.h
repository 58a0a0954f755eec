#pragma once

#include "editor/document/file_stamp.h"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace npsee::editor {

/// A preset or mission of the library. One that cannot be read is listed with its reason.
struct LibraryEntry {
  std::filesystem::path path;
  std::string title, description;
  std::string tags;  ///< of a preset, with commas
  bool readable = true, mission = false;
};

/// A file's name without its ending (".npsee.json", ".mission.json", else what follows the last dot).
std::string bareName(const std::filesystem::path& file);

/// What lists show of preset and mission files, each read again only when it has changed.
class Library {
 public:
  const LibraryEntry& entry(const std::filesystem::path& file);
  /// What a folder holds of one kind of file, by name; nothing of an empty path, or of one that cannot be read.
  std::vector<LibraryEntry> folder(const std::filesystem::path& folder, std::string_view ending);

 private:
  struct Known {
    FileStamp stamp;
    LibraryEntry entry;
  };
  std::map<std::filesystem::path, Known> known_;
};

}  // namespace npsee::editor
