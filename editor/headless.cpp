#include "editor/editor.h"

#include "app/gl/objects.h"
#include "app/render/image.h"
#include "editor/script/runner.h"
#include "sim/core/files.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdio>

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

/// What would be the window: a texture to draw into and read back.
class Surface {
 public:
  Surface(int width, int height) : width_(width), height_(height), texture_(gl::Texture::make()), target_(gl::Framebuffer::make()) {
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
  }

  render::Image picture(const Editor& editor) const {
    glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    editor.draw();
    render::Image image{width_, height_, std::vector<std::uint8_t>(4u * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_))};
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
    // GL counts rows from below, pictures from above; what blending left in alpha means nothing.
    const std::size_t row = 4u * static_cast<std::size_t>(width_);
    for (int y = 0; y < height_ / 2; ++y) std::swap_ranges(image.pixel(0, y), image.pixel(0, y) + row, image.pixel(0, height_ - 1 - y));
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
    return image;
  }

 private:
  int width_, height_;
  gl::Texture texture_;
  gl::Framebuffer target_;
};

/// One frame of a sixtieth of a second; with its picture if `file` is given.
Expected<void> step(Editor& editor, const Surface& surface, const std::filesystem::path& file) {
  ImGui::GetIO().DeltaTime = static_cast<float>(Playback::kFrame_s);
  ImGui::NewFrame();
  editor.frame(Playback::kFrame_s, std::nullopt, !file.empty());
  ImGui::Render();
  if (file.empty()) return {};
  const render::Image picture = surface.picture(editor);
  if (auto fault = editor.takeGraphicsFault()) return tl::unexpected<Error>(std::move(*fault));
  if (const char* error = gl::pendingError()) return fail(ErrorKind::graphics, std::string("the driver failed while drawing: ") + error + ".", "Unset GALLIUM_DRIVER and MESA_* variables.");
  return render::writePng(picture, file);
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
  const Surface surface(options.width, options.height);

  // Sizes settle in the second frame, and the camera with them.
  for (int i = 0; i < 3; ++i)
    if (auto done = step(**editor, surface, {}); !done) return tl::unexpected<Error>(done.error());
  if (!options.editor.time_s) (*editor)->session().playback.seek(0.0);  // a mission starts paused
  ScriptRunner runner(std::move(*commands), options.script.string(), print);
  while (true) {
    const auto more = runner.next(**editor);
    if (!more) return tl::unexpected<Error>(more.error());
    if (!*more) break;
    if (auto done = step(**editor, surface, runner.picture().value_or(std::filesystem::path())); !done) return tl::unexpected<Error>(done.error());
  }
  if (!options.screenshot.empty())
    if (auto done = step(**editor, surface, options.screenshot); !done) return tl::unexpected<Error>(done.error());
  if (!runner.failure()) return 0;
  std::fprintf(stderr, "%s\n", printable(*runner.failure()).c_str());
  return 1;
}

}  // namespace npsee::editor
