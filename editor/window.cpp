#include "editor/editor.h"

#include <glad/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <backends/imgui_impl_glfw.h>

#include <algorithm>

namespace npsee::editor {
namespace {

/// ImGui's input from a window; ended before the window is.
class WindowInput {
 public:
  explicit WindowInput(GLFWwindow* window) { ImGui_ImplGlfw_InitForOpenGL(window, true); }
  ~WindowInput() { ImGui_ImplGlfw_Shutdown(); }
  WindowInput(const WindowInput&) = delete;
  WindowInput& operator=(const WindowInput&) = delete;
};

/// Draws one frame into the window and returns its time without waiting for the display, ms.
float drawFrame(Editor& editor, GLFWwindow* window, std::optional<float> last_ms) {
  const double start = glfwGetTime();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  // A pause of the machine is not a jump of the effect.
  editor.frame(std::min(static_cast<double>(ImGui::GetIO().DeltaTime), 0.1), last_ms, true);
  ImGui::Render();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  editor.draw();
  const auto ms = static_cast<float>(1000.0 * (glfwGetTime() - start));
  glfwSwapBuffers(window);
  return ms;
}

void runLoop(Editor& editor, GLFWwindow* window) {
  std::string title;
  std::optional<float> ms;
  while (!editor.session().quitting()) {
    // While nothing moves by itself, a frame is drawn for input, and now and then for tooltips and clicks that wait.
    if (editor.session().playback.playing || editor.session().compiling()) glfwPollEvents();
    else glfwWaitEventsTimeout(0.05);
    if (glfwWindowShouldClose(window) != GLFW_FALSE) {
      glfwSetWindowShouldClose(window, GLFW_FALSE);
      editor.session().quit();
    }
    const float measured = drawFrame(editor, window, ms);
    ms = ms ? *ms + 0.1f * (measured - *ms) : measured;
    if (const std::string now = editor.session().title() + " - npsee"; now != title) glfwSetWindowTitle(window, (title = now).c_str());
  }
}

}  // namespace

Expected<void> runWindow(const WindowedOptions& options, const std::function<void(const std::string&)>& print) {
  auto context = gl::makeWindowContext({"npsee", options.width, options.height});
  if (!context) return tl::unexpected<Error>(context.error());
  (*context)->makeCurrent();
  GLFWwindow* window = (*context)->window();
  const UiHost host;
  const WindowInput input(window);
  EditorOptions chosen = options.editor;
  float across = 1.0f, down = 1.0f;
  glfwGetWindowContentScale(window, &across, &down);
  chosen.scale *= std::clamp(across, 1.0f, 4.0f);
  auto editor = Editor::create(chosen);
  if (!editor) return tl::unexpected<Error>(editor.error());
  runLoop(**editor, window);
  if (options.print_state)
    for (const auto& [name, value] : (*editor)->facts()) print(name + '=' + value);
  return {};
}

}  // namespace npsee::editor
