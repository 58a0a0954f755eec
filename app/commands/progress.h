#pragma once

#include <npsee/error.h>

#include <chrono>
#include <cstddef>
#include <string>

namespace npsee::commands {

/// Where the count goes: a line that rewrites itself on a terminal, nowhere, lines of their own now and then (for logs), or
/// often (for programs that show it).
enum class ProgressMode { terminal, never, lines, steps };

/// "auto" (or empty), "never", "always", "steps". Error kind usage.
Expected<ProgressMode> readProgress(const std::string& text);

/// A count and the time left, on stderr.
class Progress {
 public:
  /// `mode` terminal shows nothing where stderr is none, and nothing for a single piece of work.
  Progress(std::string what, std::size_t total, ProgressMode mode = ProgressMode::terminal);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::size_t total_;
  ProgressMode mode_;
  bool shown_ = false;
  Clock::time_point begin_, last_;
};

/// "frame 12 of 60, 20 %, 3 s left"; the time only once there is something to judge by.
std::string progressText(const std::string& what, std::size_t done, std::size_t total, double elapsed_s);

}  // namespace npsee::commands
