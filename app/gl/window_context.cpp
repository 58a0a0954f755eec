#include "app/gl/context.h"
#include "app/gl/loader.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace npsee::gl {
namespace {

constexpr const char* kHeadlessWayOut = "To render without a display use `npsee render PRESET -o picture.png`.";

/// GLFW's own words for its last error ("X11: The DISPLAY environment variable is missing").
tl::unexpected<Error> windowFault() {
  const char* words = nullptr;
  glfwGetError(&words);
  std::string what = words != nullptr ? words : "GLFW gives no reason";
  if (!what.ends_with('.')) what += '.';
  return fail(ErrorKind::graphics, "cannot open a window: " + what, kHeadlessWayOut);
}

class Window final : public WindowContext {
 public:
  explicit Window(GLFWwindow* window) : window_(window) {}
  ~Window() override {
    glfwDestroyWindow(window_);
    glfwTerminate();
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  void makeCurrent() override {
    glfwMakeContextCurrent(window_);
    ensureFunctions(glfwGetProcAddress, this);
  }
  std::string description() const override { return describeDriver(); }
  GLFWwindow* window() const override { return window_; }

 private:
  GLFWwindow* window_;
};

}  // namespace

Expected<std::unique_ptr<WindowContext>> makeWindowContext(const WindowOptions& options) {
  if (glfwInit() != GLFW_TRUE) return windowFault();
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  // Scenes have their own depth and samples; the window only shows textures and panels.
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  // After a reset of the graphics card the driver says so, where it can, instead of ending the process.
  glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  GLFWwindow* window = glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
  if (window == nullptr) {
    auto fault = windowFault();
    glfwTerminate();
    return fault;
  }
  auto context = std::make_unique<Window>(window);
  glfwMakeContextCurrent(window);
  if (auto loaded = loadFunctions(glfwGetProcAddress, context.get()); !loaded) return tl::unexpected<Error>(loaded.error());
  glfwSwapInterval(1);
  return context;
}

}  // namespace npsee::gl
