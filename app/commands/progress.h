#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace npsee::commands {

/// A line on stderr with a count and the time left, on a terminal only; gone when the work ends.
class Progress {
 public:
  Progress(std::string what, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::size_t done);

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::size_t total_;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point begin_, last_;
};

/// "frame 12 of 60, 20 %, 3 s left"; the time only once there is something to judge by.
std::string progressText(const std::string& what, std::size_t done, std::size_t total, double elapsed_s);

}  // namespace npsee::commands
