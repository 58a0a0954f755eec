#include "app/gl/objects.h"
#include "editor/editor.h"
#include "editor/ui/kept_window.h"
#include "editor/window_input.h"

#include <glad/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace npsee::editor {
namespace {

/// Draws one frame into the window and returns its time without waiting for the display, ms; nothing where the window shows it already.
std::optional<float> drawFrame(Editor& editor, WindowInput& input, GLFWwindow* window, std::optional<float> last_ms) {
  const double start = glfwGetTime();
  input.newFrame();
  ImGui::NewFrame();
  // A pause of the machine is not a jump of the effect.
  editor.frame(std::min(static_cast<double>(ImGui::GetIO().DeltaTime), 0.1), last_ms, true);
  ImGui::Render();
  const bool changed = editor.draw();
  if (!input.takeExposed() && !changed) return std::nullopt;
  editor.window().copyTo(0);
  const auto ms = static_cast<float>(1000.0 * (glfwGetTime() - start));
  glfwSwapBuffers(window);
  return ms;
}

/// What the driver says of the frame. A window whose context is lost can only be opened anew; all else is told, drawn again, and work goes on.
Expected<void> checkDriver(Editor& editor) {
  const char* error = gl::pendingError();
  if (error == nullptr) return {};
  if (gl::isLoss(error)) return fail(ErrorKind::graphics, "the graphics driver has lost the window's pictures.", "Start npsee again: what was not saved is offered then.");
  editor.session().notices.error = std::string("The driver failed while drawing: ") + error + ". LIBGL_ALWAYS_SOFTWARE=1 selects Mesa's software driver.";
  editor.drawAnew();
  return {};
}

Expected<void> runLoop(Editor& editor, WindowInput& input, GLFWwindow* window) {
  std::string title;
  std::optional<float> ms;
  float smooth = 0.0f;
  double told = 0.0;
  // The cross in the title bar speaks after what was typed and clicked before it: that waits in queues, and acts in the frame after.
  int until_closed = -1;
  double busy = glfwGetTime();
  while (!editor.session().quitting()) {
    // While nothing moves by itself, panels are laid out for input, and now and then for tooltips, clicks that wait and files that change;
    // nothing is drawn unless it looks different.
    constexpr double kAttentive_s = 3.0;
    if (editor.session().moving() || input.waiting() || until_closed >= 0) glfwPollEvents();
    else glfwWaitEventsTimeout(glfwGetTime() - busy < kAttentive_s ? 0.05 : 0.25);
    if (input.waiting()) busy = glfwGetTime();
    if (glfwWindowShouldClose(window) != GLFW_FALSE) {
      glfwSetWindowShouldClose(window, GLFW_FALSE);
      until_closed = 2;
    }
    if (until_closed >= 0 && !input.waiting() && until_closed-- == 0) editor.session().quit();
    if (const auto dropped = input.takeDropped(); !dropped.empty()) editor.session().drop(dropped);
    const auto measured = drawFrame(editor, input, window, ms);
    if (auto fine = checkDriver(editor); !fine) return fine;
    if (measured) {
      // Twice a second while something moves: figures that tremble cannot be read, and make every frame another one. What a still picture
      // took, the first one with the shaders that were compiled for it, tells nothing of how it will move.
      const bool moving = editor.session().moving();
      smooth = moving && smooth > 0.0f ? smooth + 0.1f * (*measured - smooth) : *measured;
      if (const double now = glfwGetTime(); moving && now - told > 0.5) ms = smooth, told = now;
    }
    if (const std::string now = editor.session().title() + " - npsee"; now != title) glfwSetWindowTitle(window, (title = now).c_str());
  }
  return {};
}

}  // namespace

Expected<void> runWindow(const WindowedOptions& options, const std::function<void(const std::string&)>& print) {
  auto desk = std::make_unique<Desk>(options.editor.folders, options.editor.program, false);
  const Settings& last = desk->settings;
  const bool known = !options.sized && last.window_width >= 800.0 && last.window_height >= 500.0;
  auto context = gl::makeWindowContext({"npsee", known ? static_cast<int>(last.window_width) : options.width, known ? static_cast<int>(last.window_height) : options.height});
  if (!context) return tl::unexpected<Error>(context.error());
  (*context)->makeCurrent();
  GLFWwindow* window = (*context)->window();
  glfwSetWindowSizeLimits(window, 800, 500, GLFW_DONT_CARE, GLFW_DONT_CARE);
  const UiHost host;
  WindowInput input(window);
  EditorOptions chosen = options.editor;
  float across = 1.0f, down = 1.0f;
  glfwGetWindowContentScale(window, &across, &down);
  int shown_width = options.width, shown_height = options.height;
  glfwGetFramebufferSize(window, &shown_width, &shown_height);
  chosen.scale = fittingScale(chosen.scale * std::clamp(across, 1.0f, 4.0f), shown_width, shown_height);
  auto editor = Editor::create(chosen, std::move(desk));
  if (!editor) return tl::unexpected<Error>(editor.error());
  if (auto ran = runLoop(**editor, input, window); !ran) return ran;
  glfwGetWindowSize(window, &shown_width, &shown_height);
  (*editor)->desk().settings.window_width = shown_width;
  (*editor)->desk().settings.window_height = shown_height;
  if (options.print_state)
    for (const auto& [name, value] : (*editor)->facts()) print(name + '=' + value);
  return {};
}

}  // namespace npsee::editor
