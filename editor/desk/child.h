#pragma once

#include "sim/core/descriptor.h"

#include <npsee/error.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace npsee::editor {

/// Another program at work beside the editor, with less claim on the processor. What it computes cannot take the editor down, and it needs no
/// graphics context of ours. It ends with the editor.
class Child {
 public:
  /// Error kind output: no process can be started.
  static Expected<Child> start(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  Child(Child&& other) noexcept;
  Child& operator=(Child&& other) noexcept;
  /// Killed if it is still running.
  ~Child();

  /// Reads what it has written since; true while it runs. Does not wait.
  bool running();
  /// Returns when it has ended.
  void wait();
  /// Asks it to end (SIGTERM), so that it tidies up.
  void cancel() const;

  const std::string& out() const { return out_; }
  const std::string& err() const { return err_; }
  /// Its exit code once it has ended, 128 + signal if one ended it.
  int exitCode() const { return exit_code_; }

 private:
  Child() = default;
  void read();

  pid_t id_ = -1;
  Descriptor out_pipe_, err_pipe_;
  std::string out_, err_;
  int exit_code_ = 0;
};

/// Words as a shell reads them back, each quoted where it must be.
std::string shellLine(const std::vector<std::string>& words);

}  // namespace npsee::editor
