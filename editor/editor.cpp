#include "editor/editor.h"

#include "editor/layout.h"
#include "editor/panels/panels.h"

#include <cstdint>

namespace npsee::editor {
namespace {

/// Draws what panels show with the one renderer. Slots keep the two textures apart.
class RendererPictures final : public Pictures {
 public:
  explicit RendererPictures(render::Renderer& renderer) : renderer_(renderer) {}

  ImTextureID explosion(const Session& session, int width, int height) override {
    if (!enabled || session.explosion() == nullptr) return nullptr;
    const Preset& preset = session.document.preset();
    render::Scene scene;
    scene.frame = &session.frame();
    scene.layers = session.explosion()->layers();
    scene.ground_height_m = preset.ground_height_m;
    scene.ground_colour = preset.ground_colour;
    return id(renderer_.drawToTexture(scene, session.camera, width, height, 0));
  }

  ImTextureID shape(const Session& session, render::TemplateHandle active, int width, int height) override {
    if (!enabled || !session.document.hasLayer()) return nullptr;
    render::TemplateScene scene;
    scene.preset = &session.document.preset();
    scene.layer = session.document.selected();
    scene.view = session.template_view;
    scene.yaw_rad = session.template_yaw_rad;
    scene.pitch_rad = session.template_pitch_rad;
    scene.background = {render::Background::Kind::colour, background};
    scene.handles = true;
    scene.active = active;
    return id(renderer_.drawToTexture(scene, width, height, 1));
  }

  bool enabled = true;
  Colour background;
  std::string fault;

 private:
  ImTextureID id(const Expected<unsigned>& texture) {
    if (!texture) fault = texture.error().text();
    return texture ? reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(*texture)) : nullptr;
  }

  render::Renderer& renderer_;
};

Colour colourOf(ImU32 packed) {
  const ImVec4 v = ImGui::ColorConvertU32ToFloat4(packed);
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

}  // namespace

struct Editor::Impl {
  Impl(const EditorOptions& chosen, std::unique_ptr<render::Renderer> made, Fonts loaded, DrawDataRenderer drawer)
      : options(chosen), session({chosen.library, chosen.scripted}), renderer(std::move(made)), fonts(loaded), panels(std::move(drawer)), pictures(*renderer) {}

  EditorOptions options;
  Session session;
  UiState state;
  Items items;
  std::unique_ptr<render::Renderer> renderer;
  Fonts fonts;
  Theme theme = darkTheme();
  DrawDataRenderer panels;
  RendererPictures pictures;
};

Editor::Editor(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Editor::~Editor() = default;

Expected<std::unique_ptr<Editor>> Editor::create(const EditorOptions& options) {
  const Fonts fonts = loadFonts(options.scale);
  auto renderer = render::Renderer::create();
  if (!renderer) return tl::unexpected<Error>(renderer.error());
  auto panels = DrawDataRenderer::create();
  if (!panels) return tl::unexpected<Error>(panels.error());
  std::unique_ptr<Editor> out(new Editor(std::make_unique<Impl>(options, std::move(*renderer), fonts, std::move(*panels))));
  Session& session = out->session();
  if (!options.file.empty())
    if (auto loaded = session.document.load(options.file); !loaded) return tl::unexpected<Error>(loaded.error());
  session.files.listing.folder = options.file.empty() ? options.library : options.file.parent_path();
  if (options.time_s) {
    session.playback.playing = false;
    session.playback.duration_s = *options.time_s;  // until the compiler says how long the effect lasts
    session.playback.seek(*options.time_s);
  }
  return out;
}

void Editor::frame(double elapsed_s, std::optional<float> frame_ms, bool pictures) {
  Impl& my = *impl_;
  my.theme = my.state.light ? lightTheme() : darkTheme();
  applyTheme(my.theme, my.options.scale);
  my.pictures.enabled = pictures;
  my.pictures.background = colourOf(my.theme.background);
  my.items.beginFrame();
  my.state.hint.clear();
  my.state.hover.seen = false;
  const PanelContext ui{my.session, my.state, my.items, my.pictures, my.theme, my.fonts, my.options.scale, elapsed_s, frame_ms};
  handleKeys(ui);
  my.session.update(elapsed_s);
  ImGui::PushFont(my.fonts.text);
  drawLayout(ui);
  ImGui::PopFont();
  // A drag is over when nothing is held any more: what it changed is one step of the history.
  if (!ImGui::IsAnyItemActive() && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) my.session.document.endMerge();
  if (!std::exchange(my.state.typing.shown, false)) my.state.typing = {};
  if (my.state.hover.seen) my.state.hover.seconds += elapsed_s;
  else my.state.hover = {};
  if (!my.pictures.fault.empty()) my.session.notices.error = std::exchange(my.pictures.fault, {});
}

void Editor::draw() const { impl_->panels.draw(*ImGui::GetDrawData()); }

Session& Editor::session() { return impl_->session; }
UiState& Editor::state() { return impl_->state; }
Items& Editor::items() { return impl_->items; }

std::vector<std::pair<std::string, std::string>> Editor::facts() const {
  const Session& session = impl_->session;
  const Document& document = session.document;
  const auto yes = [](bool b) { return std::string(b ? "yes" : "no"); };
  constexpr const char* kViews[] = {"splines", "polygons", "surface"};
  constexpr const char* kModes[] = {"closed", "open", "save as"};
  const render::Camera& camera = session.camera;
  return {
      {"eye.x", shortest(camera.eye.x)}, {"eye.y", shortest(camera.eye.y)}, {"eye.z", shortest(camera.eye.z)},
      {"target.x", shortest(camera.target.x)}, {"target.y", shortest(camera.target.y)}, {"target.z", shortest(camera.target.z)},
      {"distance", shortest(length(camera.eye - camera.target))},
      {"time", shortest(session.playback.time_s)}, {"duration", shortest(session.playback.duration_s)},
      {"playing", yes(session.playback.playing)}, {"loop", yes(session.playback.loop)}, {"speed", shortest(session.playback.speed)},
      {"alive", std::to_string(session.alive())},
      {"particles", std::to_string(session.explosion() != nullptr ? session.explosion()->particleCount() : 0)},
      {"layers", std::to_string(document.preset().layers.size())}, {"layer", document.hasLayer() ? document.layer().name : std::string()},
      {"undo", std::to_string(document.history().undoSteps())}, {"redo", std::to_string(document.history().redoSteps())},
      {"undo.label", std::string(document.history().undoLabel())},
      {"window.width", shortest(static_cast<double>(ImGui::GetIO().DisplaySize.x))}, {"window.height", shortest(static_cast<double>(ImGui::GetIO().DisplaySize.y))},
      {"dirty", yes(document.dirty())}, {"window.title", session.title()}, {"file", document.path().string()},
      {"question", yes(session.asking() != Intent::none)}, {"quitting", yes(session.quitting())},
      {"files", kModes[static_cast<int>(session.files.mode)]},
      {"error", session.notices.error}, {"note", session.notices.note}, {"hint", impl_->state.hint}, {"typing", impl_->state.typing.name},
      {"template.view", kViews[static_cast<int>(session.template_view)]},
      {"template.yaw", shortest(session.template_yaw_rad)}, {"template.pitch", shortest(session.template_pitch_rad)},
  };
}

UiHost::UiHost() {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;  // pictures of the same script are the same
  io.ConfigWindowsMoveFromTitleBarOnly = true;
}

UiHost::~UiHost() { ImGui::DestroyContext(); }

}  // namespace npsee::editor
