#pragma once

#include <map>
#include <string>
#include <vector>

namespace npsee::test {

/// What a finished command left: its exit code (128 + signal if it was killed) and both outputs.
struct ProcessResult {
  int exit_code = 0;
  std::string out, err;
};

/// Runs `program arguments...` without a shell, with `environment` added to ours (an empty value unsets) and `folder` as
/// working directory. Killed after two minutes, with exit code 137.
ProcessResult run(const std::string& program, const std::vector<std::string>& arguments,
                  const std::map<std::string, std::string>& environment = {}, const std::string& folder = {});

/// Path of the built `npsee`.
std::string npseePath();

/// Runs the built `npsee`.
ProcessResult npseeRun(const std::vector<std::string>& arguments, const std::map<std::string, std::string>& environment = {});

/// A folder of its own for each test, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  /// Path of a file in it.
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Whole file as bytes; empty if it cannot be read.
std::string slurp(const std::string& path);
void spill(const std::string& path, const std::string& text);

}  // namespace npsee::test
