#include "editor/editor.h"

#include "app/gl/objects.h"
#include "app/render/image.h"
#include "editor/measure.h"
#include "editor/script/runner.h"
#include "editor/ui/kept_window.h"
#include "sim/core/files.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <utility>

namespace npsee::editor {
namespace {

/// Key codes are GLFW's in a window and here.
void mapKeys() {
  ImGuiIO& io = ImGui::GetIO();
  constexpr std::pair<ImGuiKey, int> kMap[] = {
      {ImGuiKey_Tab, GLFW_KEY_TAB}, {ImGuiKey_LeftArrow, GLFW_KEY_LEFT}, {ImGuiKey_RightArrow, GLFW_KEY_RIGHT}, {ImGuiKey_UpArrow, GLFW_KEY_UP}, {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
      {ImGuiKey_Home, GLFW_KEY_HOME}, {ImGuiKey_End, GLFW_KEY_END}, {ImGuiKey_Delete, GLFW_KEY_DELETE}, {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE}, {ImGuiKey_Space, GLFW_KEY_SPACE},
      {ImGuiKey_Enter, GLFW_KEY_ENTER}, {ImGuiKey_Escape, GLFW_KEY_ESCAPE}, {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER}, {ImGuiKey_A, GLFW_KEY_A}, {ImGuiKey_C, GLFW_KEY_C},
      {ImGuiKey_V, GLFW_KEY_V}, {ImGuiKey_X, GLFW_KEY_X}, {ImGuiKey_Y, GLFW_KEY_Y}, {ImGuiKey_Z, GLFW_KEY_Z}};
  for (const auto& [key, code] : kMap) io.KeyMap[key] = code;
}

render::Image picture(const Editor& editor) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  render::Image image{static_cast<int>(size.x), static_cast<int>(size.y), {}};
  const std::size_t row = 4u * static_cast<std::size_t>(image.width);
  image.rgba.resize(row * static_cast<std::size_t>(image.height));
  editor.window().bindToRead();
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  // GL counts rows from below, pictures from above; what blending left in alpha means nothing.
  for (int y = 0; y < image.height / 2; ++y) std::swap_ranges(image.pixel(0, y), image.pixel(0, y) + row, image.pixel(0, image.height - 1 - y));
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

/// One frame of a sixtieth of a second; with its picture if `file` is given.
Expected<void> step(Editor& editor, const std::filesystem::path& file) {
  ImGui::GetIO().DeltaTime = static_cast<float>(Playback::kFrame_s);
  ImGui::NewFrame();
  editor.frame(Playback::kFrame_s, std::nullopt, !file.empty());
  ImGui::Render();
  if (file.empty()) return {};
  editor.draw();
  const render::Image image = picture(editor);
  if (auto fault = editor.takeGraphicsFault()) return tl::unexpected<Error>(std::move(*fault));
  if (const char* error = gl::pendingError()) return fail(ErrorKind::graphics, std::string("the driver failed while drawing: ") + error + ".", "Unset GALLIUM_DRIVER and MESA_* variables.");
  return render::writePng(image, file);
}

/// Frames as a window draws them, one after the other without waiting for a display, for `seconds`.
FrameMeter measure(Editor& editor, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto ms = [](Clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); };
  constexpr int kFirst = 5;  // make textures and compile shaders
  FrameMeter meter;
  PictureTimes pictures;
  editor.timePictures(&pictures);
  editor.session().goLive();
  double elapsed_s = Playback::kFrame_s;
  std::clock_t used = std::clock();
  auto begin = Clock::now();
  for (int frame = 0; frame <= kFirst || ms(Clock::now() - begin) < 1000.0 * seconds; ++frame) {
    const auto start = Clock::now();
    if (frame == kFirst) begin = start;
    pictures = {};
    ImGui::GetIO().DeltaTime = static_cast<float>(std::max(elapsed_s, 1e-4));
    ImGui::NewFrame();
    editor.frame(std::min(elapsed_s, 0.1), std::nullopt, true);
    ImGui::Render();
    const auto laid = Clock::now();
    const bool drawn = editor.draw();
    glFinish();
    const auto end = Clock::now();
    const std::clock_t used_now = std::clock();
    const double spent = pictures.explosion_ms + pictures.template_ms + pictures.mission_ms;
    const double cpu_ms = 1000.0 * static_cast<double>(used_now - std::exchange(used, used_now)) / CLOCKS_PER_SEC;
    if (frame >= kFirst) meter.add({ms(end - start), cpu_ms, ms(laid - start) - spent, ms(end - laid), pictures, drawn, qualityText(editor.state().desk.view.chooser.drawn())});
    elapsed_s = 1e-3 * ms(end - start);
  }
  editor.timePictures(nullptr);
  return meter;
}

Expected<std::vector<ScriptCommand>> readScript(const std::filesystem::path& file) {
  if (file.empty()) return std::vector<ScriptCommand>();
  const auto text = readTextFile(file);
  if (!text) return tl::unexpected<Error>(text.error());
  return parseScript(*text, file.string());
}

}  // namespace

Expected<int> runHeadless(const HeadlessOptions& options, const std::function<void(const std::string&)>& print) {
  auto commands = readScript(options.script);
  if (!commands) return tl::unexpected<Error>(commands.error());
  auto context = gl::makeOffscreenContext();
  if (!context) return tl::unexpected<Error>(context.error());
  const UiHost host;
  ImGui::GetIO().DisplaySize = ImVec2(static_cast<float>(options.width), static_cast<float>(options.height));
  mapKeys();
  EditorOptions chosen = options.editor;
  chosen.scripted = true;
  chosen.scale = fittingScale(chosen.scale, options.width, options.height);
  auto editor = Editor::create(chosen);
  if (!editor) return tl::unexpected<Error>(editor.error());

  // Sizes settle in the second frame, and the camera with them.
  for (int i = 0; i < 3; ++i)
    if (auto done = step(**editor, {}); !done) return tl::unexpected<Error>(done.error());
  if (!options.editor.time_s) (*editor)->session().playback.seek(0.0);  // a mission starts paused
  ScriptRunner runner(std::move(*commands), options.script.string(), print);
  while (true) {
    const auto more = runner.next(**editor);
    if (!more) return tl::unexpected<Error>(more.error());
    if (!*more) break;
    if (auto done = step(**editor, runner.picture().value_or(std::filesystem::path())); !done) return tl::unexpected<Error>(done.error());
  }
  if (!options.screenshot.empty())
    if (auto done = step(**editor, options.screenshot); !done) return tl::unexpected<Error>(done.error());
  if (!runner.failure() && options.measure_s > 0.0)
    for (const auto& [name, value] : measure(**editor, options.measure_s).figures()) print(name + '=' + value);
  if (!runner.failure()) return 0;
  std::fprintf(stderr, "%s\n", printable(*runner.failure()).c_str());
  return 1;
}

}  // namespace npsee::editor
