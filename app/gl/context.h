#pragma once

#include <npsee/error.h>

#include <memory>
#include <string>

struct GLFWwindow;

namespace npsee::gl {

/// A current-able GL 3.3 core context with its functions loaded. Destroying it needs the thread it was made on.
class Context {
 public:
  virtual ~Context() = default;
  virtual void makeCurrent() = 0;
  /// GL_RENDERER and GL_VERSION in one line, as recorded beside golden pictures.
  virtual std::string description() const = 0;
};

/// Headless context (OSMesa, llvmpipe) over a dummy 1x1 buffer; everything is drawn into framebuffer objects of our own.
/// Error kind graphics.
Expected<std::unique_ptr<Context>> makeOffscreenContext();

struct WindowOptions {
  std::string title = "npsee";
  int width = 1440, height = 900;  ///< screen coordinates
};

/// A GLFW window with a context. Error kind graphics, naming the headless way out.
class WindowContext : public Context {
 public:
  virtual GLFWwindow* window() const = 0;
};
Expected<std::unique_ptr<WindowContext>> makeWindowContext(const WindowOptions& options);

}  // namespace npsee::gl
