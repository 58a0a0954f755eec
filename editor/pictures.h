#pragma once

#include "app/render/mission_scene.h"
#include "app/render/renderer.h"
#include "editor/measure.h"
#include "editor/ui/context.h"
#include "editor/ui/picture_store.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace npsee::editor {

/// How pictures of the explosion are drawn, beside what they show.
struct PictureLook {
  bool grid = true;
  render::Background behind;
  render::Quality quality = render::Quality::normal;
  double exposure_stops = 0.0;
  friend bool operator==(const PictureLook&, const PictureLook&) = default;
};

/// Draws what panels show with the one renderer, and keeps each picture until something else is to be seen in it.
class RendererPictures final : public Pictures {
 public:
  explicit RendererPictures(render::Renderer& renderer) : renderer_(renderer) {}

  ImTextureID explosion(const Session& session, int width, int height) override;
  ImTextureID shape(const Session& session, render::TemplateHandle active, int width, int height) override;
  ImTextureID other(const Session& session, const BesidePicture& beside, int which, int width, int height) override;
  ImTextureID mission(const MissionSession& session, int width, int height) override;
  const std::vector<render::MissionMark>& marks(const MissionSession& session, int width, int height) override;
  ImTextureID file(const std::filesystem::path& path) override;

  bool enabled = true;
  bool scenes = true;           ///< explosions and missions too
  PictureLook look;             ///< of explosions
  bool mission_smooth = true;   ///< several samples a pixel in missions
  double share = 1.0;           ///< of the display's pixels across that are drawn
  Colour background;            ///< of the template
  double scale = 1.0;           ///< of the panels
  std::string fault;
  std::optional<Error> failed;  ///< what the driver could not draw
  PictureTimes* times = nullptr;  ///< where somebody measures

  /// All pictures are drawn anew when they are next asked for.
  void forget();

  /// Textures with another content than when this was asked last.
  std::vector<ImTextureID> takeRedrawn();
  /// Textures that hide all behind them.
  const std::vector<ImTextureID>& opaque() const { return opaque_; }

 private:
  /// All that a picture of an explosion depends on.
  struct ExplosionKey {
    std::shared_ptr<const Explosion> explosion;
    std::uint64_t stamp = 0;
    double time_s = 0.0;
    render::Camera camera;
    double ground_m = 0.0;
    Colour ground;
    Sky sky = Sky::day;
    PictureLook look;
    int width = 0, height = 0;
    friend bool operator==(const ExplosionKey&, const ExplosionKey&) = default;
  };
  struct TemplateKey {
    Preset preset;
    render::TemplateView view = render::TemplateView::surface;
    double yaw_rad = 0.0, pitch_rad = 0.0, scale = 1.0;
    Colour background;
    render::TemplateHandle active = render::TemplateHandle::none;
    int width = 0, height = 0;
    friend bool operator==(const TemplateKey&, const TemplateKey&) = default;
  };
  struct MissionKey {
    std::shared_ptr<const Recording> recording;
    double time_s = 0.0;
    render::MissionView view;
    int width = 0, height = 0;
    friend bool operator==(const MissionKey&, const MissionKey&) = default;
  };
  template <class Key>
  struct Kept {
    std::optional<Key> key;
    ImTextureID texture = nullptr;
  };

  bool prepare(const MissionSession& session);
  ImTextureID drawExplosion(const ExplosionKey& key, const Frame& frame, int slot);
  template <class Key, class Draw>
  ImTextureID kept(Kept<Key>& kept, Key key, double PictureTimes::* cost, bool opaque, const Draw& draw);

  render::Renderer& renderer_;
  PictureStore store_;
  std::unique_ptr<render::MissionScene> scene_;
  std::size_t warned_ = 0;  ///< of the scene's warnings that were shown
  std::vector<render::MissionMark> marks_;
  std::map<int, Kept<ExplosionKey>> explosions_;  ///< by slot
  Kept<TemplateKey> template_;
  Kept<MissionKey> mission_;
  std::vector<ImTextureID> redrawn_, opaque_;
};

}  // namespace npsee::editor
