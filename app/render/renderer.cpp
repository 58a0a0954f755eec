#include "app/render/renderer.h"

#include "app/render/backdrop_pass.h"
#include "app/render/deep_finish.h"
#include "app/render/effect_passes.h"
#include "app/render/effect_tiles.h"
#include "app/render/finish_pass.h"
#include "app/render/hour_light.h"
#include "app/render/make_once.h"
#include "app/render/mission_scene.h"
#include "app/render/surface_pass.h"
#include "app/render/target.h"
#include "app/render/template_pass.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace npsee::render {
namespace {

/// Most particles drawn with several samples per pixel, which take twice the time; among more, edges no longer show.
constexpr std::size_t kMostSmooth = 10'000;

Expected<void> checkSize(int width, int height) {
  if (width >= 1 && height >= 1 && width <= kMaxPictureSize && height <= kMaxPictureSize) return {};
  return fail(ErrorKind::graphics, "a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels cannot be drawn.",
              "Width and height go from 1 to " + std::to_string(kMaxPictureSize) + " pixels.");
}

Expected<void> drawnWithoutError() {
  if (const char* error = gl::pendingError()) return fail(ErrorKind::graphics, std::string("the driver failed while drawing: ") + error + ".", "LIBGL_ALWAYS_SOFTWARE=1 selects Mesa's software driver.");
  return {};
}

/// The ground around an explosion; over a plain background or none it neither hides nor fades anything.
GroundLevel groundOf(const Scene& scene) {
  GroundLevel ground;
  ground.height_m = scene.ground_height_m;
  ground.solid = ground.fades = scene.background.kind == Background::Kind::sky;
  ground.daylight = hourLight(scene.sky).daylight;
  ground.colour = {scene.ground_colour.r, scene.ground_colour.g, scene.ground_colour.b};
  return ground;
}

void readBack(const Target& target, Image& image) {
  image.width = target.width();
  image.height = target.height();
  image.rgba.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
  target.bindFinished();
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  // GL's first row is the lowest.
  const std::ptrdiff_t row = 4 * static_cast<std::ptrdiff_t>(image.width);
  for (int low = 0, high = image.height - 1; low < high; ++low, --high) std::swap_ranges(image.pixel(0, low), image.pixel(0, low) + row, image.pixel(0, high));
}

}  // namespace

struct Renderer::Impl {
  struct Slot {
    Target target;
    std::optional<Backdrop> backdrop;  // what the target's backdrop shows
  };
  BackdropPass backdrop;
  EffectPasses effects;
  FinishPass finish;
  // Shaders that not every picture needs are compiled when one does: start-up time counts.
  std::optional<TemplatePass> icon;
  std::optional<DeepFinish> deep;
  std::optional<SurfacePass> surfaces;
  TileMask mask;
  TileMesh tiles;
  std::array<Slot, kPictureSlots> slots;

  void prepareBackdrop(const Scene& scene, const View& view, Slot& slot) const;
  /// What lies on the ground: burnt patches, shadows, light, blast fronts.
  Expected<void> drawOnGround(const Scene& scene, const View& view, const GroundLevel& ground, bool shadows);
  Expected<void> draw(const Scene& scene, const View& view, Slot& slot);
  Expected<void> drawFloats(const Scene& scene, const View& view, const FloatRequest& request, Slot& slot, FloatImage& image);
  Expected<void> draw(const TemplateScene& scene, Slot& slot);
  Expected<void> draw(MissionScene& scene, const Recording& recording, double time_s, const MissionView& view, Slot& slot);
  /// The slot with its target at the wanted size.
  Expected<Slot*> sized(int slot, int width, int height);
};

Expected<Renderer::Impl::Slot*> Renderer::Impl::sized(int index, int width, int height) {
  if (auto fits = checkSize(width, height); !fits) return tl::unexpected<Error>(fits.error());
  Slot& slot = slots.at(static_cast<std::size_t>(index));
  if (slot.target.width() != width || slot.target.height() != height) slot.backdrop.reset();
  if (auto made = slot.target.resize(width, height); !made) return tl::unexpected<Error>(made.error());
  return &slot;
}

void Renderer::Impl::prepareBackdrop(const Scene& scene, const View& view, Slot& slot) const {
  const Backdrop wanted{view, scene.ground_height_m, scene.ground_colour, scene.sky, scene.grid};
  // Frames of a sequence share their backdrop, which costs more to draw than a hundred pieces.
  if (slot.backdrop == wanted) return;
  backdrop.draw(slot.target, wanted);
  slot.backdrop = wanted;
}

Expected<void> Renderer::Impl::drawOnGround(const Scene& scene, const View& view, const GroundLevel& ground, bool shadows) {
  if (auto drawn = effects.drawScorch(*scene.frame, scene.layers, view, ground); !drawn) return drawn;
  if (shadows)
    if (auto drawn = effects.drawShadows(*scene.frame, scene.layers, view, ground); !drawn) return drawn;
  if (auto drawn = effects.drawGlow(view, ground); !drawn) return drawn;
  return effects.drawShockRings(*scene.frame, scene.layers, view, ground);
}

Expected<void> Renderer::Impl::draw(const Scene& scene, const View& view, Slot& slot) {
  const bool outdoors = scene.background.kind == Background::Kind::sky;
  const bool particles = scene.frame != nullptr && scene.frame->count > 0;
  // A picture without background is for laying over another: it holds the effect alone.
  const bool shadows = scene.background.kind != Background::Kind::transparent && view.eye.y > scene.ground_height_m;
  const Target& target = slot.target;
  if (outdoors) prepareBackdrop(scene, view, slot);
  mask.reset(target.width(), target.height());
  GroundLevel ground = groundOf(scene);
  const HourLight hour = hourLight(scene.sky);
  if (particles) ground.glow = glowOf(*scene.frame, scene.layers);
  ground.glow.light_m2 = hour.exposure * ground.glow.light_m2;
  if (particles) markEffect(mask, *scene.frame, scene.layers, view, ground, shadows);
  tiles.upload(mask);
  if (!mask.empty()) {
    if (auto begun = slot.target.beginEffect(scene.frame->count <= kMostSmooth); !begun) return begun;
    finish.clear(tiles);
    effects.upload(*scene.frame, scene.layers);
    if (shadows)
      if (auto drawn = drawOnGround(scene, view, ground, hour.shadows); !drawn) return drawn;
    effects.drawOpaque(*scene.frame, scene.layers, view, ground);
    if (auto drawn = effects.drawBlended(*scene.frame, scene.layers, view, ground); !drawn) return drawn;
    if (auto drawn = effects.drawShockShells(*scene.frame, scene.layers, view, ground); !drawn) return drawn;
  }
  if (outdoors) finish.drawOverBackdrop(target, tiles);
  else finish.drawOverColour(target, tiles, scene.background.kind == Background::Kind::colour ? &scene.background.colour : nullptr);
  return drawnWithoutError();
}

Expected<void> Renderer::Impl::drawFloats(const Scene& scene, const View& view, const FloatRequest& request, Slot& slot, FloatImage& image) {
  const bool outdoors = scene.background.kind == Background::Kind::sky;
  image.width = slot.target.width();
  image.height = slot.target.height();
  image.rgba.clear();
  if (request.colour) {
    if (auto drawn = draw(scene, view, slot); !drawn) return drawn;
    if (auto made = makeOnce(deep); !made) return made;
    // `mask` still marks the effect's tiles.
    const Colour* plain = scene.background.kind == Background::Kind::colour ? &scene.background.colour : nullptr;
    if (auto finished = deep->run(slot.target, mask, outdoors, plain, request.linear, image); !finished) return finished;
  }
  image.depth.clear();
  image.motion.clear();
  if (!request.depth && !request.motion) return drawnWithoutError();
  if (auto made = makeOnce(surfaces); !made) return made;
  const Frame* frame = scene.frame != nullptr && scene.frame->count > 0 ? scene.frame : nullptr;
  if (frame != nullptr) effects.upload(*frame, scene.layers);
  const GroundLevel ground = groundOf(scene);
  if (auto drawn = surfaces->run(effects, frame, scene.layers, view, ground, image.width, image.height, request, image); !drawn) return drawn;
  return drawnWithoutError();
}

Expected<void> Renderer::Impl::draw(const TemplateScene& scene, Slot& slot) {
  if (scene.preset == nullptr || scene.layer < 0 || static_cast<std::size_t>(scene.layer) >= scene.preset->layers.size())
    return fail(ErrorKind::usage, "there is no layer " + std::to_string(scene.layer) + " to draw a template of.", "Choose one of the preset's layers, or add one.");
  if (auto made = makeOnce(icon); !made) return made;
  Target& target = slot.target;
  if (auto begun = target.beginEffect(true); !begun) return begun;
  mask.reset(target.width(), target.height());
  mask.markAll();
  tiles.upload(mask);
  finish.clear(tiles);
  icon->draw(scene, target.width(), target.height());
  finish.drawOverColour(target, tiles, TemplatePass::background(scene));
  return drawnWithoutError();
}

Expected<void> Renderer::Impl::draw(MissionScene& scene, const Recording& recording, double time_s, const MissionView& view, Slot& slot) {
  Target& target = slot.target;
  if (auto begun = target.beginEffect(view.smooth); !begun) return begun;
  mask.reset(target.width(), target.height());
  mask.markAll();
  tiles.upload(mask);
  if (auto drawn = scene.draw(effects, recording, time_s, view, target.width(), target.height()); !drawn) return drawn;
  if (auto finished = finish.drawMission(target, tiles); !finished) return finished;
  return drawnWithoutError();
}

Expected<std::unique_ptr<Renderer>> Renderer::create() {
  auto impl = std::make_unique<Impl>();
  const auto take = [](auto made, auto& slot) -> Expected<void> {
    if (!made) return tl::unexpected<Error>(made.error());
    slot = std::move(*made);
    return {};
  };
  if (auto done = take(BackdropPass::create(), impl->backdrop); !done) return tl::unexpected<Error>(done.error());
  if (auto done = take(EffectPasses::create(), impl->effects); !done) return tl::unexpected<Error>(done.error());
  if (auto done = take(FinishPass::create(), impl->finish); !done) return tl::unexpected<Error>(done.error());
  return std::unique_ptr<Renderer>(new Renderer(std::move(impl)));
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::~Renderer() = default;

Expected<unsigned> Renderer::drawToTexture(const Scene& scene, const Camera& camera, int width, int height, int slot) {
  const auto sized = impl_->sized(slot, width, height);
  if (!sized) return tl::unexpected<Error>(sized.error());
  if (auto drawn = impl_->draw(scene, makeView(camera, width, height), **sized); !drawn) return tl::unexpected<Error>(drawn.error());
  return (*sized)->target.finished();
}

Expected<unsigned> Renderer::drawToTexture(const TemplateScene& scene, int width, int height, int slot) {
  const auto sized = impl_->sized(slot, width, height);
  if (!sized) return tl::unexpected<Error>(sized.error());
  if (auto drawn = impl_->draw(scene, **sized); !drawn) return tl::unexpected<Error>(drawn.error());
  return (*sized)->target.finished();
}

Expected<void> Renderer::drawToImage(const Scene& scene, const Camera& camera, int width, int height, Image& image) {
  const auto sized = impl_->sized(0, width, height);
  if (!sized) return tl::unexpected<Error>(sized.error());
  if (auto drawn = impl_->draw(scene, makeView(camera, width, height), **sized); !drawn) return drawn;
  readBack((*sized)->target, image);
  return {};
}

Expected<Image> Renderer::drawToImage(const Scene& scene, const Camera& camera, int width, int height) {
  Image image;
  if (auto drawn = drawToImage(scene, camera, width, height, image); !drawn) return tl::unexpected<Error>(drawn.error());
  return image;
}

Expected<void> Renderer::drawToFloats(const Scene& scene, const Camera& camera, int width, int height, const FloatRequest& request, FloatImage& image) {
  const auto sized = impl_->sized(0, width, height);
  if (!sized) return tl::unexpected<Error>(sized.error());
  return impl_->drawFloats(scene, makeView(camera, width, height), request, **sized, image);
}

Expected<Image> Renderer::drawToImage(const TemplateScene& scene, int width, int height) {
  const auto sized = impl_->sized(1, width, height);
  if (!sized) return tl::unexpected<Error>(sized.error());
  if (auto drawn = impl_->draw(scene, **sized); !drawn) return tl::unexpected<Error>(drawn.error());
  Image image;
  readBack((*sized)->target, image);
  return image;
}

Expected<unsigned> Renderer::drawToTexture(MissionScene& scene, const Recording& recording, double time_s, const MissionView& view, int width, int height, int slot) {
  const auto sized = impl_->sized(slot, width, height);
  if (!sized) return tl::unexpected<Error>(sized.error());
  if (auto drawn = impl_->draw(scene, recording, time_s, view, **sized); !drawn) return tl::unexpected<Error>(drawn.error());
  return (*sized)->target.finished();
}

Expected<void> Renderer::drawToImage(MissionScene& scene, const Recording& recording, double time_s, const MissionView& view, int width, int height, Image& image) {
  const auto sized = impl_->sized(2, width, height);
  if (!sized) return tl::unexpected<Error>(sized.error());
  if (auto drawn = impl_->draw(scene, recording, time_s, view, **sized); !drawn) return drawn;
  readBack((*sized)->target, image);
  return {};
}

}  // namespace npsee::render
