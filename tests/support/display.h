#pragma once

#include "tests/support/process.h"

#include <map>
#include <string>
#include <sys/types.h>
#include <vector>

namespace npsee::test {

/// An X server without a screen (Xvfb) on a free display number, ended with the object. Throws if it does not start: a test
/// of the real window is never skipped.
class VirtualDisplay {
 public:
  explicit VirtualDisplay(const std::string& screen = "1280x800x24");
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

  /// Environment that makes a program use it.
  std::map<std::string, std::string> environment() const { return {{"DISPLAY", name_}, {"WAYLAND_DISPLAY", ""}, {"LIBGL_ALWAYS_SOFTWARE", "1"}}; }
  /// Asks a window to close, as the cross in its title bar does (xdotool would destroy it).
  void askToClose(const std::string& window) const;
  /// Runs the other program of tests/support/x_client.cpp on it.
  ProcessResult client(const std::vector<std::string>& words) const;
  /// Runs xdotool with these words and returns what it prints; throws if it fails.
  std::string xdotool(const std::vector<std::string>& words) const;

 private:
  pid_t server_ = -1;
  std::string name_;
};

}  // namespace npsee::test
