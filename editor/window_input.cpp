#include "editor/window_input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <vector>

namespace npsee::editor {
namespace {

bool isModifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }

}  // namespace

WindowInput::WindowInput(GLFWwindow* window) : window_(window), x_(-FLT_MAX), y_(-FLT_MAX), inside_(glfwGetWindowAttrib(window, GLFW_HOVERED) != GLFW_FALSE) {
  glfwSetWindowUserPointer(window, this);
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  listen();
}

WindowInput::~WindowInput() {
  ImGui_ImplGlfw_Shutdown();
  glfwSetCursorPosCallback(window_, nullptr);
  glfwSetCursorEnterCallback(window_, nullptr);
  glfwSetCharCallback(window_, nullptr);
  glfwSetDropCallback(window_, nullptr);
  glfwSetWindowRefreshCallback(window_, nullptr);
  glfwSetWindowUserPointer(window_, nullptr);
}

void WindowInput::listen() {
  // The backend's own handlers of focus and wheel stay; these five would lose what is shorter than a frame, or its order.
  glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
    static_cast<WindowInput*>(glfwGetWindowUserPointer(window))->events_.push_back({.kind = Event::Kind::move, .x = static_cast<float>(x), .y = static_cast<float>(y)});
  });
  glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned character) {
    static_cast<WindowInput*>(glfwGetWindowUserPointer(window))->events_.push_back({.kind = Event::Kind::character, .code = static_cast<int>(character)});
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int entered) {
    static_cast<WindowInput*>(glfwGetWindowUserPointer(window))->events_.push_back({.kind = Event::Kind::crossing, .action = entered});
  });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { static_cast<WindowInput*>(glfwGetWindowUserPointer(window))->exposed_ = true; });
  glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
    static_cast<WindowInput*>(glfwGetWindowUserPointer(window))->dropped_.assign(paths, paths + count);
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int) {
    static_cast<WindowInput*>(glfwGetWindowUserPointer(window))->events_.push_back({.kind = Event::Kind::button, .code = button, .action = action});
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    static_cast<WindowInput*>(glfwGetWindowUserPointer(window))->events_.push_back({.kind = Event::Kind::key, .code = key, .scancode = scancode, .action = action, .modifiers = modifiers});
  });
}

void WindowInput::newFrame() {
  ImGui_ImplGlfw_NewFrame();
  ImGuiIO& io = ImGui::GetIO();
  bool button_changed = false, key_pressed = false, moved = false;
  std::vector<int> keys;
  for (; !events_.empty(); events_.pop_front()) {
    const Event& event = events_.front();
    if (event.kind == Event::Kind::key) {
      if (event.action == GLFW_REPEAT) continue;  // ImGui repeats by itself
      // A key belongs to the modifiers of its moment, whichever of them is released first.
      if (button_changed || key_pressed || std::ranges::find(keys, event.code) != keys.end()) break;
      keys.push_back(event.code);
      key_pressed = event.action == GLFW_PRESS && !isModifier(event.code);
      ImGui_ImplGlfw_KeyCallback(window_, event.code, event.scancode, event.action, event.modifiers);
      continue;
    }
    if (event.kind == Event::Kind::character) {
      io.AddInputCharacter(static_cast<unsigned>(event.code));
      continue;
    }
    // A press belongs to the place and the keys of its moment, and a drag ends only after its last movement was seen.
    if (button_changed || (moved && event.kind == Event::Kind::button && event.action == GLFW_RELEASE)) break;
    if (event.kind == Event::Kind::crossing) {
      inside_ = event.action != GLFW_FALSE;
      moved = true;
    } else if (event.kind == Event::Kind::move) {
      x_ = event.x;
      y_ = event.y;
      moved = true;
    } else if (event.code >= 0 && event.code < 3) {
      down_[static_cast<std::size_t>(event.code)] = event.action == GLFW_PRESS;
      button_changed = true;
    }
  }
  // A button is released where the pointer was then, though it may have left since.
  const bool here = inside_ || button_changed || std::ranges::find(down_, true) != down_.end();
  io.MousePos = here ? ImVec2(x_, y_) : ImVec2(-FLT_MAX, -FLT_MAX);
  std::ranges::copy(down_, io.MouseDown);
}

}  // namespace npsee::editor
