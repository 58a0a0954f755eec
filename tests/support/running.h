#pragma once

#include <map>
#include <string>
#include <sys/types.h>
#include <vector>

namespace npsee::test {

/// A command under way, to be killed at some moment. Killed at the latest with the object.
class Running {
 public:
  Running(const std::string& program, const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment);
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Waits until so many lines were written to standard output and returns all of it so far; less if the command ends before.
  std::string readLines(int lines);
  /// Ends it as no program can prevent (SIGKILL), and waits until it is gone.
  void kill();

 private:
  pid_t child_ = -1;
  int out_ = -1;
  std::string read_;
};

}  // namespace npsee::test
