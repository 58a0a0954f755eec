#pragma once

#include "editor/desk/child.h"
#include "editor/document/file_stamp.h"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace npsee::editor {

/// Pictures of preset files. Those of shipped presets lie beside them; others are rendered one after the other by a process of their own and
/// kept in the cache under a fingerprint of the preset's bytes and its models', so that they are right after every change and shared between copies.
class Thumbnails {
 public:
  /// Without a cache or a program only shipped pictures are found.
  Thumbnails(std::filesystem::path cache, std::filesystem::path program);

  /// The picture of a preset file; empty while there is none. Asking for it is asking to have it made.
  std::filesystem::path picture(const std::filesystem::path& preset);
  /// Files are looked at once for all that ask until the next call: a library asks for each of its pictures in every frame.
  void lookAgain() { ++looks_; }
  /// Starts and collects renderings; `wait` until all are done.
  void update(bool wait);
  bool busy() const { return child_.has_value() || !wanted_.empty(); }

 private:
  struct Known {
    std::vector<std::filesystem::path> files;  ///< that the picture is of: the preset's, and those of its models
    std::vector<FileStamp> stamps;             ///< of each
    std::filesystem::path picture;  ///< where it is, or will be; empty = cannot be had
    std::filesystem::path shown;    ///< the same if it was there
    std::uint64_t looked = 0;       ///< the number of that look; 0 = none yet
  };
  struct Job {
    std::string text;  ///< of the preset
    std::filesystem::path folder;  ///< of its file, where its models lie
    std::filesystem::path picture;
  };
  Known look(const std::filesystem::path& file);
  void startNext();
  std::filesystem::path workFolder() const;
  void prune() const;

  std::filesystem::path folder_, program_;
  std::map<std::filesystem::path, Known> known_;
  std::set<std::filesystem::path> asked_;  ///< pictures waited for, or that could not be made
  std::deque<Job> wanted_;
  std::uint64_t looks_ = 1;
  std::optional<Child> child_;
  Job now_;
};

}  // namespace npsee::editor
