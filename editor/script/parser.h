#pragma once

#include <npsee/error.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace npsee::editor {

/// One command of the UI script language (docs/ui-script.md).
struct ScriptCommandInfo {
  std::string_view name;
  std::string_view arguments;  ///< as the help prints them
  int least = 0, most = 0;     ///< how many arguments; the last one takes the rest of the line
  std::string_view doc;
};
std::span<const ScriptCommandInfo> scriptCommands();

struct ScriptCommand {
  std::string name;
  std::vector<std::string> arguments;
  int line = 0;  ///< 1-based
};

/// Reads a script: one command per line, `#` starts a comment line, double quotes hold words with spaces together. Reports
/// every bad line with file and line (kind input).
Expected<std::vector<ScriptCommand>> parseScript(std::string_view text, std::string_view file);

/// A key with its modifiers, "ctrl+shift+S". `code` is GLFW's key code.
struct KeyStroke {
  int code = 0;
  bool ctrl = false, shift = false, alt = false;
  friend bool operator==(const KeyStroke&, const KeyStroke&) = default;
};
/// Error kind input names the nearest key.
Expected<KeyStroke> parseKeyStroke(std::string_view text);
/// "Ctrl+Shift+S", as menus and the cheat sheet print it.
std::string keyText(const KeyStroke& stroke);

}  // namespace npsee::editor
