#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>

namespace npsee::editor {

/// Writes and removes small files in order, on a thread of its own: waiting for a disk must not stop a drag. Every file is whole at every
/// moment, old or new.
class Writer {
 public:
  Writer();
  /// Finishes what was asked for.
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Folders are made where they are missing. A file still waiting to be written is overtaken. Gives a number to ask about later.
  std::uint64_t write(std::filesystem::path file, std::string text);
  enum class Fate { waiting, written, failed };
  Fate fateOf(std::uint64_t number) const;
  void remove(std::filesystem::path file);
  /// Returns when all is done.
  void wait();
  /// Why something could not be written, once.
  std::optional<std::string> takeError();

 private:
  struct Task {
    std::filesystem::path file;
    std::optional<std::string> text;  ///< none = remove
    std::uint64_t number = 0;
  };
  std::uint64_t add(Task task);
  void work(const std::stop_token& stop);

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::deque<Task> tasks_;
  bool working_ = false;
  std::uint64_t asked_ = 0, ended_ = 0;  ///< numbers of the newest tasks
  std::set<std::uint64_t> failed_;
  std::optional<std::string> error_;
  std::jthread thread_;  ///< last, so that it ends before what it uses
};

}  // namespace npsee::editor
