#include "editor/pictures.h"

#include "editor/mission/session.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <utility>

namespace npsee::editor {
namespace {

constexpr int kFirstBesideSlot = 4;

}  // namespace

std::vector<ImTextureID> RendererPictures::takeRedrawn() {
  const auto read = store_.takeRead();
  redrawn_.insert(redrawn_.end(), read.begin(), read.end());
  return std::exchange(redrawn_, {});
}

void RendererPictures::forget() {
  explosions_.clear();
  template_ = {};
  mission_ = {};
}

template <class Key, class Draw>
ImTextureID RendererPictures::kept(Kept<Key>& kept, Key key, double PictureTimes::* cost, bool opaque, const Draw& draw) {
  if (kept.key == key) return kept.texture;
  using Clock = std::chrono::steady_clock;
  // What was begun before is not what this picture costs.
  if (times != nullptr) glFinish();
  const auto start = Clock::now();
  const Expected<unsigned> texture = draw();
  if (times != nullptr) {
    glFinish();
    times->*cost += std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    ++times->drawn;
  }
  kept = {};
  if (!texture) {
    fault = texture.error().text();
    if (texture.error().kind == ErrorKind::graphics) failed = texture.error();
    return nullptr;
  }
  kept = {std::move(key), reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(*texture))};
  redrawn_.push_back(kept.texture);
  if (opaque && std::ranges::find(opaque_, kept.texture) == opaque_.end()) opaque_.push_back(kept.texture);
  return kept.texture;
}

ImTextureID RendererPictures::drawExplosion(const ExplosionKey& key, const Frame& frame, int slot) {
  return kept(explosions_[slot], key, &PictureTimes::explosion_ms, true, [&] {
    render::Scene scene;
    scene.frame = &frame;
    scene.layers = key.explosion->layers();
    scene.ground_height_m = key.ground_m;
    scene.ground_colour = key.ground;
    scene.sky = key.sky;
    scene.grid = key.look.grid;
    scene.background = key.look.behind;
    scene.quality = key.look.quality;
    scene.exposure_stops = key.look.exposure_stops;
    return renderer_.drawToTexture(scene, key.camera, key.width, key.height, slot);
  });
}

ImTextureID RendererPictures::explosion(const Session& session, int width, int height) {
  if (!enabled || !scenes || session.explosion() == nullptr) return nullptr;
  const Preset& preset = session.document.preset();
  return drawExplosion({session.explosionShared(), session.frameStamp(), 0.0, session.camera, preset.ground_height_m, preset.ground_colour, preset.sky, look, width, height}, session.frame(), 0);
}

ImTextureID RendererPictures::other(const Session& session, const BesidePicture& beside, int which, int width, int height) {
  if (!enabled || !scenes || beside.explosion == nullptr) return nullptr;
  const Preset& preset = beside.preset;
  return drawExplosion({beside.explosion, 0, beside.time_s, session.camera, preset.ground_height_m, preset.ground_colour, preset.sky, look, width, height}, beside.frame, kFirstBesideSlot + which);
}

ImTextureID RendererPictures::shape(const Session& session, render::TemplateHandle active, int width, int height) {
  if (!enabled || session.design.ease.shown().layers.empty()) return nullptr;
  TemplateKey key{session.design.ease.shown(), session.template_view, session.template_yaw_rad, session.template_pitch_rad, scale, background, active, width, height};
  return kept(template_, std::move(key), &PictureTimes::template_ms, false, [&] {
    render::TemplateScene scene;
    scene.preset = &session.design.ease.shown();
    scene.layer = 0;
    scene.view = session.template_view;
    scene.yaw_rad = session.template_yaw_rad;
    scene.pitch_rad = session.template_pitch_rad;
    scene.background = {render::Background::Kind::colour, background};
    scene.handles = true;
    scene.active = active;
    scene.scale = scale;
    return renderer_.drawToTexture(scene, width, height, 1);
  });
}

/// The scene of the mission shown; it notices by itself when the recording grows or the ground is another.
bool RendererPictures::prepare(const MissionSession& session) {
  if (scene_) return true;
  auto made = render::MissionScene::make(*session.recording());
  if (made) scene_ = std::move(*made);
  else fault = made.error().text();
  return scene_ != nullptr;
}

ImTextureID RendererPictures::mission(const MissionSession& session, int width, int height) {
  const Recording* recording = session.recording();
  if (!enabled || !scenes || recording == nullptr || !prepare(session)) return nullptr;
  MissionKey key{session.sharedRecording(), session.clock.time_s, session.view, width, height};
  key.view.smooth = mission_smooth;
  key.view.exposure_stops = look.exposure_stops;
  key.view.scale = scale * share;
  const render::MissionView view = key.view;
  const ImTextureID texture = kept(mission_, std::move(key), &PictureTimes::mission_ms, true, [&] { return renderer_.drawToTexture(*scene_, *recording, session.clock.time_s, view, width, height, 2); });
  for (; warned_ < scene_->warnings().size(); ++warned_) fault = scene_->warnings()[warned_];
  return texture;
}

const std::vector<render::MissionMark>& RendererPictures::marks(const MissionSession& session, int width, int height) {
  marks_.clear();
  if (session.recording() == nullptr || !prepare(session)) return marks_;
  render::MissionView view = session.view;
  view.scale = scale;
  marks_ = scene_->marks(*session.recording(), session.clock.time_s, view, width, height);
  return marks_;
}

ImTextureID RendererPictures::file(const std::filesystem::path& path) { return enabled ? store_.texture(path) : nullptr; }

}  // namespace npsee::editor
