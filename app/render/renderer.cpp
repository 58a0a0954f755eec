#include "app/render/renderer.h"

#include "app/render/backdrop_pass.h"
#include "app/render/bloom.h"
#include "app/render/deep_finish.h"
#include "app/render/effect_passes.h"
#include "app/render/effect_tiles.h"
#include "app/render/fine_frames.h"
#include "app/render/finish_pass.h"
#include "app/render/hour_light.h"
#include "app/render/make_once.h"
#include "app/render/mission_scene.h"
#include "app/render/piece_edges.h"
#include "app/render/surface_pass.h"
#include "app/render/target.h"
#include "app/render/template_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace npsee::render {
namespace {

/// Most pieces drawn with several samples per pixel, which take twice the time; among more, edges no longer show.
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
  ground.hour = hourLight(scene.sky);
  ground.colour = {scene.ground_colour.r, scene.ground_colour.g, scene.ground_colour.b};
  return ground;
}

double exposureOf(const Scene& scene) { return std::exp2(scene.exposure_stops); }

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
  std::optional<Bloom> bloom;
  std::optional<PieceEdges> edges;
  std::optional<DeepFinish> deep;
  std::optional<SurfacePass> surfaces;
  FineFrames looks;
  std::function<void(std::string_view)> watch;
  TileMask mask, bright;  // touched by the effect; by what shines
  BloomLight spread;      // of the picture drawn last
  PieceSpread pieces;     // of the picture drawn last, if they have several samples
  TileMesh tiles;
  std::array<Slot, kPictureSlots> slots;

  void prepareBackdrop(const Scene& scene, const View& view, Slot& slot) const;
  /// What lies on the ground: burnt patches, shadows, light, blast fronts.
  Expected<void> drawOnGround(const Frame& frame, const Scene& scene, const View& view, const GroundLevel& ground);
  Expected<void> draw(const Scene& scene, const View& view, Slot& slot);
  /// All but the finish: backdrop, effect and spread light. `singly`: to be finished in single precision.
  Expected<void> drawLight(const Scene& scene, const View& view, Slot& slot, bool singly);
  /// In bands of so many rows, each in `image` when it is handed over.
  Expected<void> drawFloats(const Scene& scene, const View& view, const FloatRequest& request, int rows, Slot& slot, FloatImage& image, const TakeRows& take);
  Expected<void> draw(const TemplateScene& scene, Slot& slot);
  Expected<void> draw(MissionScene& scene, const Recording& recording, double time_s, const MissionView& view, Slot& slot);
  /// Draws the particles of a frame into the bound framebuffer, whose tiles are cleared: the target's effect, if pieces are to have several
  /// samples (else null).
  Expected<void> drawParticles(const Frame& frame, const Scene& scene, const View& view, const GroundLevel& ground, bool shadows, Target* smooth);
  /// Pieces with several samples into the target's effect, and all that is blended among them.
  Expected<void> drawAmongPieces(const Frame& frame, const Scene& scene, const View& view, const GroundLevel& ground, Target& target);
  /// The same by the scene's quality into the target's effect.
  Expected<void> drawEffect(const Scene& scene, const View& view, const GroundLevel& ground, bool shadows, Target& target);
  /// The mean of a fine picture's looks into the target's sum: `draw_look(index)` draws one into the target's effect.
  template <class DrawLook>
  Expected<void> sumLooks(Target& target, const DrawLook& draw_look);
  void passed(std::string_view pass) const;
  /// Marks what shines, and all that its spread light reaches.
  void markSpread(const Scene& scene, const View& view);
  /// Spreads the light of the tiles in `bright`.
  Expected<void> spreadLight(const Target& target);
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
  const Backdrop wanted{view, scene.ground_height_m, scene.ground_colour, scene.sky, scene.grid, exposureOf(scene)};
  // Frames of a sequence share their backdrop, which costs more to draw than a hundred pieces.
  if (slot.backdrop == wanted) return;
  backdrop.draw(slot.target, wanted);
  slot.backdrop = wanted;
}

Expected<void> Renderer::Impl::drawOnGround(const Frame& frame, const Scene& scene, const View& view, const GroundLevel& ground) {
  if (auto drawn = effects.drawOutlines(frame, scene.layers, view, ground); !drawn) return drawn;
  if (auto drawn = effects.drawScorch(frame, scene.layers, view, ground); !drawn) return drawn;
  passed("scorch");
  if (auto drawn = effects.drawShadows(frame, scene.layers, view, ground); !drawn) return drawn;
  passed("shadow");
  if (auto drawn = effects.drawGlow(view, ground); !drawn) return drawn;
  passed("glow");
  if (auto drawn = effects.drawShockRings(frame, scene.layers, view, ground); !drawn) return drawn;
  passed("ring");
  return {};
}

void Renderer::Impl::markSpread(const Scene& scene, const View& view) {
  bright.reset(mask.width(), mask.height());
  markBright(bright, *scene.frame, scene.layers, view);
  if (!bright.empty()) mask.markAround(bright, static_cast<int>(Bloom::kReach * mask.height() / TileMask::kSide) + 2);
}

Expected<void> Renderer::Impl::spreadLight(const Target& target) {
  spread = {};
  if (bright.empty()) return {};
  if (auto made = makeOnce(bloom); !made) return made;
  auto light = bloom->run(target, bright);
  if (!light) return tl::unexpected<Error>(light.error());
  spread = *light;
  return {};
}

void Renderer::Impl::passed(std::string_view pass) const {
  if (!watch) return;
  glFinish();
  watch(pass);
}

Expected<void> Renderer::Impl::drawAmongPieces(const Frame& frame, const Scene& scene, const View& view, const GroundLevel& ground, Target& target) {
  if (auto made = makeOnce(edges); !made) return made;
  if (auto begun = edges->begin(target, finish, pieces); !begun) return begun;
  if (auto drawn = effects.drawOpaque(frame, scene.layers, view, ground); !drawn) return drawn;
  if (auto drawn = effects.drawFading(frame, scene.layers, view, ground); !drawn) return drawn;
  passed("solid");
  edges->settle(target, view);
  passed("settle");
  const PiecesDrawn drawn{*edges, target, pieces};
  return effects.drawBlended(frame, scene.layers, view, ground, &drawn);
}

Expected<void> Renderer::Impl::drawParticles(const Frame& frame, const Scene& scene, const View& view, const GroundLevel& ground, bool shadows, Target* smooth) {
  effects.upload(frame, scene.layers);
  if (shadows)
    if (auto drawn = drawOnGround(frame, scene, view, ground); !drawn) return drawn;
  pieces.pieces.clear();
  if (smooth != nullptr) findPieces(pieces, mask, frame, scene.layers, view, ground);
  if (!pieces.pieces.empty() && pieces.pieces.size() <= kMostSmooth) {
    if (auto drawn = drawAmongPieces(frame, scene, view, ground, *smooth); !drawn) return drawn;
  } else {
    if (auto drawn = effects.drawOpaque(frame, scene.layers, view, ground); !drawn) return drawn;
    passed("solid");
    if (auto drawn = effects.drawBlended(frame, scene.layers, view, ground); !drawn) return drawn;
  }
  passed("blended");
  if (auto drawn = effects.drawShockShells(frame, scene.layers, view, ground); !drawn) return drawn;
  passed("shell");
  return {};
}

Expected<void> Renderer::Impl::drawEffect(const Scene& scene, const View& view, const GroundLevel& ground, bool shadows, Target& target) {
  effects.setDetail(scene.quality != Quality::draft);
  if (scene.quality == Quality::draft) {
    if (auto begun = target.beginDraft(); !begun) return begun;
    finish.clear(tiles);
    passed("clear");
    return drawParticles(*scene.frame, scene, view, ground, shadows, nullptr);
  }
  const auto begin = [&]() -> Expected<void> {
    if (auto begun = target.beginEffect(false); !begun) return begun;
    finish.clear(tiles);
    passed("clear");
    return {};
  };
  if (scene.quality == Quality::normal) {
    if (auto begun = begin(); !begun) return begun;
    return drawParticles(*scene.frame, scene, view, ground, shadows, target.hasSamples() ? &target : nullptr);
  }
  return sumLooks(target, [&](int look) -> Expected<void> {
    if (auto begun = begin(); !begun) return begun;
    return drawParticles(looks.frameOf(*scene.frame, scene.layers, look), scene, FineFrames::viewOf(view, look, target.width(), target.height()), ground, shadows, nullptr);
  });
}

template <class DrawLook>
Expected<void> Renderer::Impl::sumLooks(Target& target, const DrawLook& draw_look) {
  if (auto bound = target.bindSum(); !bound) return bound;
  finish.clear(tiles);
  for (int look = 0; look < FineFrames::kLooks; ++look) {
    if (auto drawn = draw_look(look); !drawn) return drawn;
    if (auto bound = target.bindSum(); !bound) return bound;
    if (auto added = finish.add(target, tiles, 1.0 / FineFrames::kLooks); !added) return added;
    passed("sum");
  }
  return {};
}

Expected<void> Renderer::Impl::drawLight(const Scene& scene, const View& view, Slot& slot, bool singly) {
  const bool outdoors = scene.background.kind == Background::Kind::sky;
  const bool particles = scene.frame != nullptr && scene.frame->count > 0;
  const bool draft = scene.quality == Quality::draft;
  // A picture without background is for laying over another: it holds the effect alone.
  const bool shadows = scene.background.kind != Background::Kind::transparent && view.eye.y > scene.ground_height_m;
  Target& target = slot.target;
  if (outdoors) prepareBackdrop(scene, view, slot);
  passed("backdrop");
  // A draft's pixels show as much with fewer: each spans more.
  const int width = draft ? target.draftWidth() : target.width(), height = draft ? target.draftHeight() : target.height();
  View seen = view;
  seen.metre_per_pixel *= static_cast<double>(target.height()) / height;
  mask.reset(width, height);
  bright.reset(width, height);
  GroundLevel ground = groundOf(scene);
  if (particles) {
    ground.glow = glowOf(*scene.frame, scene.layers);
    ground.glow.light_m2 = ground.hour.exposure * ground.glow.light_m2;
    if (scene.quality != Quality::fine) markEffect(mask, *scene.frame, scene.layers, seen, ground, shadows);
    else
      for (int look = 0; look < FineFrames::kLooks; ++look) markEffect(mask, looks.frameOf(*scene.frame, scene.layers, look), scene.layers, seen, ground, shadows);
    if (scene.bloom && !draft) markSpread(scene, seen);
  }
  // A draft that is enlarged in single precision is read between its pixels, beyond the tiles too.
  if (draft && singly && particles) mask.markAll();
  tiles.upload(mask);
  if (!mask.empty())
    if (auto drawn = drawEffect(scene, seen, ground, shadows, target); !drawn) return drawn;
  if (auto done = spreadLight(target); !done) return done;
  passed("bloom");
  return {};
}

Expected<void> Renderer::Impl::draw(const Scene& scene, const View& view, Slot& slot) {
  if (auto drawn = drawLight(scene, view, slot, false); !drawn) return drawn;
  Target& target = slot.target;
  const bool outdoors = scene.background.kind == Background::Kind::sky;
  const Colour* plain = scene.background.kind == Background::Kind::colour ? &scene.background.colour : nullptr;
  if (auto finished = outdoors ? finish.drawOverBackdrop(target, tiles, exposureOf(scene), spread) : finish.drawOverColour(target, tiles, plain, exposureOf(scene), spread); !finished) return finished;
  passed("finish");
  return drawnWithoutError();
}

Expected<void> Renderer::Impl::drawFloats(const Scene& scene, const View& view, const FloatRequest& request, int rows, Slot& slot, FloatImage& image, const TakeRows& take) {
  if (request.colour)
    if (auto drawn = drawLight(scene, view, slot, true); !drawn) return drawn;
  if (request.colour)
    if (auto made = makeOnce(deep); !made) return made;
  if (request.depth || request.motion)
    if (auto made = makeOnce(surfaces); !made) return made;
  // `mask` still marks the effect's tiles.
  const DeepParts parts{mask, scene.background.kind == Background::Kind::sky, scene.background.kind == Background::Kind::colour ? &scene.background.colour : nullptr, request.linear, exposureOf(scene), spread};
  const Frame* frame = scene.frame != nullptr && scene.frame->count > 0 ? scene.frame : nullptr;
  const GroundLevel ground = groundOf(scene);
  const int width = slot.target.width(), height = slot.target.height();
  if (frame != nullptr && (request.depth || request.motion)) effects.upload(*frame, scene.layers);
  for (int first = 0; first < height; first += rows) {
    const RowBand band{first, std::min(rows, height - first), height};
    image.rgba.clear();
    image.depth.clear();
    image.motion.clear();
    if (request.colour)
      if (auto finished = deep->run(slot.target, parts, band, image); !finished) return finished;
    if (request.depth || request.motion)
      if (auto drawn = surfaces->run(effects, frame, scene.layers, view, ground, width, band, request, image); !drawn) return drawn;
    if (auto drawn = drawnWithoutError(); !drawn) return drawn;
    if (auto taken = take(first, image); !taken) return taken;
  }
  return {};
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
  if (auto finished = finish.drawOverColour(target, tiles, TemplatePass::background(scene), 1.0, {}); !finished) return finished;
  return drawnWithoutError();
}

Expected<void> Renderer::Impl::draw(MissionScene& scene, const Recording& recording, double time_s, const MissionView& view, Slot& slot) {
  Target& target = slot.target;
  const int width = target.width(), height = target.height();
  const bool draft = view.quality == Quality::draft, fine = view.quality == Quality::fine;
  effects.setDetail(!draft);
  mask.reset(width, height);
  mask.markAll();
  tiles.upload(mask);
  bright.reset(width, height);
  const auto drawAt = [&](double at_s, const std::array<double, 2>& aside) -> Expected<void> {
    if (auto begun = draft ? target.beginDraft() : target.beginEffect(!fine && view.smooth); !begun) return begun;
    return scene.draw(effects, recording, at_s, view, width, height, {draft ? target.draftWidth() : width, draft ? target.draftHeight() : height, aside[0], aside[1]}, bright);
  };
  const auto drawLook = [&](int look) { return drawAt(std::max(time_s + FineFrames::timeOf(look), 0.0), FineFrames::asideOf(look, width, height)); };
  if (auto drawn = fine ? sumLooks(target, drawLook) : drawAt(time_s, {}); !drawn) return drawn;
  if (draft) bright.reset(width, height);
  if (auto done = spreadLight(target); !done) return done;
  if (auto finished = finish.drawMission(target, tiles, std::exp2(view.exposure_stops), spread); !finished) return finished;
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

void Renderer::watchPasses(std::function<void(std::string_view)> watch) { impl_->watch = std::move(watch); }

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
  impl_->passed("read");
  return drawnWithoutError();
}

Expected<Image> Renderer::drawToImage(const Scene& scene, const Camera& camera, int width, int height) {
  Image image;
  if (auto drawn = drawToImage(scene, camera, width, height, image); !drawn) return tl::unexpected<Error>(drawn.error());
  return image;
}

Expected<void> Renderer::drawToFloats(const Scene& scene, const Camera& camera, int width, int height, const FloatRequest& request, FloatImage& image) {
  const auto sized = impl_->sized(0, width, height);
  if (!sized) return tl::unexpected<Error>(sized.error());
  return impl_->drawFloats(scene, makeView(camera, width, height), request, height, **sized, image, [](int, FloatImage&) { return Expected<void>(); });
}

Expected<void> Renderer::drawToRows(const Scene& scene, const Camera& camera, int width, int height, const FloatRequest& request, const TakeRows& take, int rows) {
  const auto sized = impl_->sized(0, width, height);
  if (!sized) return tl::unexpected<Error>(sized.error());
  constexpr int kBandPixels = 1 << 20, kStep = 16;
  const int wanted = rows > 0 ? rows : kBandPixels / width;
  FloatImage image;
  return impl_->drawFloats(scene, makeView(camera, width, height), request, std::max(wanted / kStep, 1) * kStep, **sized, image, take);
}

Expected<Image> Renderer::drawToImage(const TemplateScene& scene, int width, int height) {
  const auto sized = impl_->sized(1, width, height);
  if (!sized) return tl::unexpected<Error>(sized.error());
  if (auto drawn = impl_->draw(scene, **sized); !drawn) return tl::unexpected<Error>(drawn.error());
  Image image;
  readBack((*sized)->target, image);
  if (auto read = drawnWithoutError(); !read) return tl::unexpected<Error>(read.error());
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
  return drawnWithoutError();
}

}  // namespace npsee::render
