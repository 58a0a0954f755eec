#pragma once

#include <filesystem>

namespace npsee::editor {

/// Where the editor keeps what it remembers from one start to the next. Empty paths: it remembers nothing.
struct DeskFolders {
  std::filesystem::path settings;  ///< layout, theme, favourites
  std::filesystem::path state;     ///< unsaved work, recipes of exports
  std::filesystem::path cache;     ///< thumbnails; may be deleted at any time
};

/// The folders `npsee` below XDG_CONFIG_HOME, XDG_STATE_HOME and XDG_CACHE_HOME, or below the defaults of the XDG Base Directory
/// Specification where those are unset or not absolute. All empty without a home.
DeskFolders xdgFolders();

}  // namespace npsee::editor
