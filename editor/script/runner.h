#pragma once

#include "editor/editor.h"
#include "editor/script/parser.h"

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace npsee::editor {

/// Turns a script into mouse and keyboard input, frame by frame.
class ScriptRunner {
 public:
  ScriptRunner(std::vector<ScriptCommand> commands, std::string file, std::function<void(const std::string&)> print);

  /// Feeds ImGui's input for the next frame; false when the script is done. Error kind input: an item or fact that does not
  /// exist, with file and line.
  Expected<bool> next(Editor& editor);

  /// Picture that the frame now being drawn is to be saved as.
  const std::optional<std::filesystem::path>& picture() const { return picture_; }
  /// The expectation that did not hold, with file and line; the script stops there.
  const std::optional<std::string>& failure() const { return failure_; }

 private:
  /// Input of one frame.
  struct Step {
    std::optional<ImVec2> mouse = {};
    std::optional<std::pair<int, bool>> button = {};
    std::optional<std::pair<KeyStroke, bool>> key = {};
    std::optional<std::pair<char, bool>> modifier = {};  ///< its first letter
    std::string text = {};
    float wheel = 0.0f;
    std::optional<std::filesystem::path> picture = {};
  };
  enum class Progress { done, again };  ///< `again`: call once more in the next frame

  Expected<Progress> begin(Editor& editor, const ScriptCommand& command);
  Expected<Progress> set(Editor& editor, const ScriptCommand& command);
  Expected<Progress> setInMission(Editor& editor, const ScriptCommand& command);
  Expected<Progress> pointAt(Editor& editor, const ScriptCommand& command);
  Expected<Progress> expect(Editor& editor, const ScriptCommand& command);
  Expected<Progress> print(Editor& editor, const ScriptCommand& command);
  void pointer(const ScriptCommand& command);
  void dragFrom(ImVec2 at, float dx, float dy);
  void click(ImVec2 at, int button, int times);
  void apply(const Step& step);

  std::optional<std::string> fact(Editor& editor, const std::string& name) const;
  tl::unexpected<Error> noSuch(Editor& editor, const ScriptCommand& command, const std::string& kind, const std::string& name) const;
  tl::unexpected<Error> bad(const ScriptCommand& command, std::string what, std::string remedy = {}) const;

  std::vector<ScriptCommand> commands_;
  std::string file_;
  std::function<void(const std::string&)> print_;
  std::size_t at_ = 0;
  int attempts_ = 0;
  bool ctrl_ = false, shift_ = false, alt_ = false;  ///< held
  std::deque<Step> steps_;
  std::map<std::string, std::string> noted_;
  std::optional<std::filesystem::path> picture_;
  std::optional<std::string> failure_;
};

}  // namespace npsee::editor
