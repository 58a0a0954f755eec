#pragma once

#include <array>
#include <deque>
#include <filesystem>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace npsee::editor {

/// ImGui's input from a window. What the mouse and the keys do waits in a queue and is handed on so that no press is lost, every press
/// happens where the pointer was and with the keys that were held, and text comes in the order it was typed, however slowly frames are
/// drawn: a frame takes at most one press of a button and one of a key.
class WindowInput {
 public:
  /// Needs the ImGui context; takes the window's callbacks and user pointer. Ended before the window is.
  explicit WindowInput(GLFWwindow* window);
  ~WindowInput();
  WindowInput(const WindowInput&) = delete;
  WindowInput& operator=(const WindowInput&) = delete;

  /// Before ImGui::NewFrame.
  void newFrame();
  /// True while events wait for the next frame.
  bool waiting() const { return !events_.empty(); }
  /// True if what the window shows was lost since the last call.
  bool takeExposed() { return std::exchange(exposed_, false); }
  /// Files dropped on the window since the last call.
  std::vector<std::filesystem::path> takeDropped() { return std::exchange(dropped_, {}); }

 private:
  struct Event {
    enum class Kind { move, crossing, button, key, character } kind = Kind::move;
    float x = 0.0f, y = 0.0f;
    int code = 0;  ///< of a button, a key or a character
    int scancode = 0, action = 0, modifiers = 0;
  };
  void listen();

  GLFWwindow* window_;
  std::deque<Event> events_;
  float x_, y_;
  std::array<bool, 3> down_{};
  bool inside_;
  std::vector<std::filesystem::path> dropped_;
  bool exposed_ = true;
};

}  // namespace npsee::editor
