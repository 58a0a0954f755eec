#include "editor/editor.h"

#include "editor/layout.h"
#include "editor/mission/session.h"
#include "editor/panels/desk/sheets.h"
#include "editor/panels/desk/view_tools.h"
#include "editor/panels/panels.h"
#include "editor/pictures.h"
#include "editor/remember.h"
#include "editor/ui/kept_window.h"

#include <algorithm>
#include <charconv>

namespace npsee::editor {
namespace {

/// What `--background` reads, as far as the viewport offers it.
render::Background backgroundOf(const std::string& text) {
  if (text == "black") return {render::Background::Kind::colour, {}};
  if (text == "white") return {render::Background::Kind::colour, {1.0, 1.0, 1.0}};
  unsigned packed = 0;
  const char* const last = text.data() + text.size();
  if (text.size() != 7 || text[0] != '#' || std::from_chars(text.data() + 1, last, packed, 16).ptr != last) return {};
  const auto part = [packed](int shift) { return static_cast<double>((packed >> shift) & 255u) / 255.0; };
  return {render::Background::Kind::colour, {part(16), part(8), part(0)}};
}

Colour colourOf(ImU32 packed) {
  const ImVec4 v = ImGui::ColorConvertU32ToFloat4(packed);
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

}  // namespace

struct Editor::Impl {
  Impl(const EditorOptions& chosen, std::unique_ptr<Desk> found, std::unique_ptr<render::Renderer> made, Fonts loaded, KeptWindow kept)
      : options(chosen), session({chosen.library, chosen.scripted, chosen.missions}), desk(std::move(found)), renderer(std::move(made)), fonts(loaded), window(std::move(kept)), pictures(*renderer) {}

  EditorOptions options;
  Session session;
  std::unique_ptr<Desk> desk;
  UiState state;
  Items items;
  std::unique_ptr<render::Renderer> renderer;
  Fonts fonts;
  Theme theme = darkTheme();
  KeptWindow window;
  RendererPictures pictures;
};

Editor::Editor(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Editor::~Editor() { impl_->desk->finish(impl_->session.quitting()); }

Expected<std::unique_ptr<Editor>> Editor::create(const EditorOptions& options, std::unique_ptr<Desk> desk) {
  const Fonts fonts = loadFonts(options.scale);
  auto renderer = render::Renderer::create();
  if (!renderer) return tl::unexpected<Error>(renderer.error());
  auto window = KeptWindow::create();
  if (!window) return tl::unexpected<Error>(window.error());
  std::unique_ptr<Editor> out(new Editor(std::make_unique<Impl>(options, desk ? std::move(desk) : std::make_unique<Desk>(options.folders, options.program, options.scripted), std::move(*renderer), fonts, std::move(*window))));
  bringIn(out->desk().settings, out->state());
  if (!options.folders.settings.empty() && !out->desk().settings.tour_done) out->state().desk.tour = 0;
  Session& session = out->session();
  const bool mission = isMissionFile(options.file);
  if (!options.file.empty())
    if (auto loaded = mission ? session.mission().load(options.file) : session.document.load(options.file); !loaded) return tl::unexpected<Error>(loaded.error());
  if (mission) session.setMode(WorkMode::mission);
  session.files.listing.folder = options.file.empty() ? options.library : options.file.parent_path();
  if (options.time_s && mission) {
    session.mission().clock.setDuration(session.mission().document.scenario().duration_s);
    session.mission().clock.seek(*options.time_s);
  } else if (options.time_s) {
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
  my.pictures.scenes = my.state.desk.view.pictures;
  my.pictures.scale = static_cast<double>(my.options.scale);
  my.pictures.background = colourOf(my.theme.background);
  my.items.beginFrame();
  my.state.hint.clear();
  my.state.hover.seen = false;
  const PanelContext ui{my.session, *my.desk, my.state, my.items, my.pictures, my.theme, my.fonts, my.options.scale, elapsed_s, frame_ms};
  handleKeys(ui);
  my.session.update(elapsed_s);
  my.desk->update(elapsed_s, my.session);
  const DrawnQuality& quality = adaptQuality(my.session, my.state.desk.view, elapsed_s);
  my.pictures.look = {my.state.desk.view.grid, backgroundOf(my.state.desk.view.background), quality.quality, my.state.desk.view.exposure_stops};
  my.pictures.share = quality.share;
  my.pictures.mission_smooth = quality.quality != render::Quality::draft;
  ImGui::PushFont(my.fonts.text);
  drawLayout(ui);
  drawTour(ui);
  ImGui::PopFont();
  noteDown(my.state, my.desk->settings);
  // A drag is over when nothing is held any more: what it changed is one step of the history.
  if (!ImGui::IsAnyItemActive() && !ImGui::IsMouseDown(ImGuiMouseButton_Left) && !(my.session.inMission() && my.state.mission.driving.keys)) my.session.endMerge();
  if (!std::exchange(my.state.typing.shown, false)) my.state.typing = {};
  if (my.state.hover.seen) my.state.hover.seconds += elapsed_s;
  else my.state.hover = {};
  if (!my.pictures.fault.empty()) my.session.notices.error = std::exchange(my.pictures.fault, {});
}

void Editor::timePictures(PictureTimes* into) { impl_->pictures.times = into; }

bool Editor::draw() {
  const auto redrawn = impl_->pictures.takeRedrawn();
  return impl_->window.update(*ImGui::GetDrawData(), redrawn, impl_->pictures.opaque());
}

const KeptWindow& Editor::window() const { return impl_->window; }

void Editor::drawAnew() {
  impl_->pictures.forget();
  impl_->window.forget();
}

std::optional<Error> Editor::takeGraphicsFault() { return std::exchange(impl_->pictures.failed, {}); }

Session& Editor::session() { return impl_->session; }
const Session& Editor::session() const { return impl_->session; }
UiState& Editor::state() { return impl_->state; }
const UiState& Editor::state() const { return impl_->state; }
Items& Editor::items() { return impl_->items; }
Desk& Editor::desk() { return *impl_->desk; }
const Desk& Editor::desk() const { return *impl_->desk; }

float fittingScale(float wished, int width, int height) {
  return std::max(0.75f, std::min({wished, static_cast<float>(width) / 880.0f, static_cast<float>(height) / 550.0f}));
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
