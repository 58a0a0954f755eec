#pragma once

#include "sim/core/descriptor.h"

#include <npsee/error.h>

#include <filesystem>

namespace npsee::editor {

/// A folder for temporary files that goes with its owner. It is locked while it is used: so the one that a killed editor has left behind is
/// told from one at work, and removed by whoever makes the next.
class WorkFolder {
 public:
  /// In the system's folder for temporary files (TMPDIR). Error kind output.
  static Expected<WorkFolder> make();
  WorkFolder(WorkFolder&& other) noexcept = default;
  WorkFolder& operator=(WorkFolder&& other) noexcept;
  ~WorkFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  WorkFolder(std::filesystem::path path, Descriptor lock) : path_(std::move(path)), lock_(std::move(lock)) {}

  std::filesystem::path path_;
  Descriptor lock_;  ///< valid as long as the folder is this one's
};

}  // namespace npsee::editor
