#include "app/render/renderer.h"

#include "app/render/backdrop_pass.h"
#include "app/render/blend_order.h"
#include "app/render/finish_pass.h"
#include "app/render/shadow_pass.h"
#include "app/render/soft_pass.h"
#include "app/render/solid_pass.h"
#include "app/render/target.h"
#include "app/render/template_pass.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace npsee::render {
namespace {

/// Darkness of the shadow under a form; light throws none.
double shadowStrength(Form form) {
  switch (form) {
    case Form::tetrahedron:
    case Form::disc:
    case Form::sphere:
    case Form::shard: return 0.62;
    case Form::smoke: return 0.22;
    case Form::streak:
    case Form::fire:
    case Form::flash: break;
  }
  return 0.0;
}

/// The span cut to the particles the frame really holds.
std::size_t countIn(const LayerSpan& layer, const Frame& frame) {
  return layer.first >= frame.count ? 0 : std::min(layer.count, frame.count - layer.first);
}

Expected<void> checkSize(int width, int height) {
  if (width >= 1 && height >= 1 && width <= kMaxPictureSize && height <= kMaxPictureSize) return {};
  return fail(ErrorKind::graphics, "a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels cannot be drawn.",
              "Width and height go from 1 to " + std::to_string(kMaxPictureSize) + " pixels.");
}

Expected<void> drawnWithoutError() {
  if (const char* error = gl::pendingError()) return fail(ErrorKind::graphics, std::string("the driver failed while drawing: ") + error + ".", "LIBGL_ALWAYS_SOFTWARE=1 selects Mesa's software driver.");
  return {};
}

Expected<void> sizedTarget(Target& target, int width, int height) {
  if (auto sized = checkSize(width, height); !sized) return sized;
  return target.resize(width, height);
}

void readBack(const Target& target, Image& image) {
  image.width = target.width();
  image.height = target.height();
  image.rgba.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
  target.bindFinished();
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
}

}  // namespace

struct Renderer::Impl {
  BackdropPass backdrop;
  SolidPass solid;
  ShadowPass shadow;
  FinishPass finish;
  // Shaders that not every picture needs are compiled when one does: start-up time counts.
  std::optional<SoftPass> soft;
  std::optional<TemplatePass> icon;
  FrameUpload frame;
  BlendedUpload blended;
  BlendOrder order;
  std::array<Target, 4> targets;

  void drawShadows(const Scene& scene, const View& view) const;
  void drawOpaque(const Scene& scene, const View& view);
  Expected<void> drawBlended(const Scene& scene, const View& view, double ground_m);
  Expected<void> draw(const Scene& scene, const View& view, Target& target, bool rows_from_top);
  Expected<void> draw(const TemplateScene& scene, Target& target, bool rows_from_top);
};

void Renderer::Impl::drawShadows(const Scene& scene, const View& view) const {
  for (const LayerSpan& layer : scene.layers) {
    const std::size_t count = countIn(layer, *scene.frame);
    const double strength = shadowStrength(layer.form);
    if (count > 0 && strength > 0.0) shadow.draw(view, frame, layer.first, count, scene.ground_height_m, strength);
  }
}

void Renderer::Impl::drawOpaque(const Scene& scene, const View& view) {
  for (const LayerSpan& layer : scene.layers)
    if (const std::size_t count = countIn(layer, *scene.frame); count > 0 && !isSoft(layer.form))
      solid.drawOpaque(view, layer.form, frame, layer.first, count, scene.ground_height_m);
}

Expected<void> Renderer::Impl::drawBlended(const Scene& scene, const View& view, double ground_m) {
  order.sort(*scene.frame, scene.layers, view);
  if (order.instances().empty()) return {};
  blended.upload(order.instances());
  for (const BlendOrder::Run& run : order.runs()) {
    if (!isSoft(run.form)) {
      solid.drawBlended(view, run.form, blended, run.first, run.count, scene.ground_height_m);
      continue;
    }
    if (!soft) {
      auto pass = SoftPass::create();
      if (!pass) return tl::unexpected<Error>(pass.error());
      soft = std::move(*pass);
    }
    soft->draw(view, blended, run.first, run.count, ground_m);
  }
  return {};
}

Expected<void> Renderer::Impl::draw(const Scene& scene, const View& view, Target& target, bool rows_from_top) {
  const bool outdoors = scene.background.kind == Background::Kind::sky;
  const bool particles = scene.frame != nullptr && scene.frame->count > 0;
  target.begin();
  if (particles) frame.upload(*scene.frame);
  if (outdoors) backdrop.drawGround(view, scene.ground_height_m, scene.ground_colour, scene.grid);
  // A picture without background is for laying over another: it holds the effect alone.
  if (particles && scene.background.kind != Background::Kind::transparent && view.eye.y > scene.ground_height_m) drawShadows(scene, view);
  if (particles) drawOpaque(scene, view);
  if (outdoors) backdrop.drawSky(view);
  if (particles)
    if (auto drawn = drawBlended(scene, view, outdoors ? scene.ground_height_m : -1e9); !drawn) return drawn;
  // The sky and ground cover everything; what stands behind them does not matter.
  const Colour* behind = scene.background.kind == Background::Kind::transparent ? nullptr : &scene.background.colour;
  finish.draw(target, behind, rows_from_top);
  return drawnWithoutError();
}

Expected<void> Renderer::Impl::draw(const TemplateScene& scene, Target& target, bool rows_from_top) {
  if (scene.preset == nullptr || scene.layer < 0 || static_cast<std::size_t>(scene.layer) >= scene.preset->layers.size())
    return fail(ErrorKind::usage, "there is no layer " + std::to_string(scene.layer) + " to draw a template of.", "Choose one of the preset's layers, or add one.");
  if (!icon) {
    auto pass = TemplatePass::create();
    if (!pass) return tl::unexpected<Error>(pass.error());
    icon = std::move(*pass);
  }
  target.begin();
  icon->draw(scene, target.width(), target.height());
  finish.draw(target, TemplatePass::background(scene), rows_from_top);
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
  if (auto done = take(SolidPass::create(), impl->solid); !done) return tl::unexpected<Error>(done.error());
  if (auto done = take(ShadowPass::create(), impl->shadow); !done) return tl::unexpected<Error>(done.error());
  if (auto done = take(FinishPass::create(), impl->finish); !done) return tl::unexpected<Error>(done.error());
  return std::unique_ptr<Renderer>(new Renderer(std::move(impl)));
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::~Renderer() = default;

Expected<unsigned> Renderer::drawToTexture(const Scene& scene, const Camera& camera, int width, int height, int slot) {
  Target& target = impl_->targets.at(static_cast<std::size_t>(slot));
  if (auto made = sizedTarget(target, width, height); !made) return tl::unexpected<Error>(made.error());
  const View view = makeView(camera, width, height, {0, 0, width, height});
  if (auto drawn = impl_->draw(scene, view, target, false); !drawn) return tl::unexpected<Error>(drawn.error());
  return target.finished();
}

Expected<unsigned> Renderer::drawToTexture(const TemplateScene& scene, int width, int height, int slot) {
  Target& target = impl_->targets.at(static_cast<std::size_t>(slot));
  if (auto made = sizedTarget(target, width, height); !made) return tl::unexpected<Error>(made.error());
  if (auto drawn = impl_->draw(scene, target, false); !drawn) return tl::unexpected<Error>(drawn.error());
  return target.finished();
}

Expected<void> Renderer::drawToImage(const Scene& scene, const Camera& camera, int width, int height, Image& image) {
  Target& target = impl_->targets[0];
  if (auto made = sizedTarget(target, width, height); !made) return made;
  const View view = makeView(camera, width, height, {0, 0, width, height});
  if (auto drawn = impl_->draw(scene, view, target, true); !drawn) return drawn;
  readBack(target, image);
  return {};
}

Expected<Image> Renderer::drawToImage(const Scene& scene, const Camera& camera, int width, int height) {
  Image image;
  if (auto drawn = drawToImage(scene, camera, width, height, image); !drawn) return tl::unexpected<Error>(drawn.error());
  return image;
}

Expected<Image> Renderer::drawToImage(const TemplateScene& scene, int width, int height) {
  Target& target = impl_->targets[1];
  if (auto made = sizedTarget(target, width, height); !made) return tl::unexpected<Error>(made.error());
  if (auto drawn = impl_->draw(scene, target, true); !drawn) return tl::unexpected<Error>(drawn.error());
  Image image;
  readBack(target, image);
  return image;
}

}  // namespace npsee::render
