#include "app/render/surface_pass.h"

#include "app/gl/state.h"
#include "app/render/meshes.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace npsee::render {
namespace {

/// Cover from which puffs together are a surface.
constexpr float kLeastCover = 0.5f;

}  // namespace

Expected<SurfacePass> SurfacePass::create() {
  auto ground = gl::Program::fromFiles("fullscreen.vert", "surface_ground.frag");
  if (!ground) return tl::unexpected<Error>(ground.error());
  SurfacePass pass;
  pass.ground_ = std::move(*ground);
  pass.nothing_ = gl::VertexArray::make();
  return pass;
}

Expected<void> SurfacePass::resize(int width, int rows) {
  // The last band of a picture may be lower than the others.
  if (width_ == width && rows_ >= rows) return {};
  width_ = rows_ = 0;
  depth_ = gl::Renderbuffer::make();
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, rows);
  auto made = makeFloatTexture(width, rows, frame_);
  if (!made) return tl::unexpected<Error>(made.error());
  values_ = std::move(*made);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  if (const char* error = gl::pendingError()) return fail(ErrorKind::graphics, std::string("the driver has no room for the depth of the picture: ") + error + ".", "Choose a smaller size.");
  width_ = width;
  rows_ = rows;
  return {};
}

void SurfacePass::begin(const RowBand& band) const {
  const float nothing[] = {0.0f, 0.0f, 0.0f, 0.0f};
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  showBand(band, width_);
  glClearBufferfv(GL_COLOR, 0, nothing);
}

void SurfacePass::drawGround(const View& view, const GroundLevel& ground, const RowBand& band) const {
  // The ground is behind all that is drawn: what lies below it is clipped.
  gl::drawPlainly();
  ground_.use();
  View seen = view;
  seen.ray_origin = seen.ray_origin + static_cast<double>(band.low()) * view.ray_y;
  setView(ground_, seen);
  ground_.set("u_depth", 0.0f);
  ground_.set("u_height", static_cast<float>(ground.height_m));
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Expected<void> SurfacePass::run(EffectPasses& effects, const Frame* frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, int width, const RowBand& band, const FloatRequest& request, FloatImage& image) {
  if (auto sized = resize(width, band.rows); !sized) return sized;
  const SurfaceFrame surface{width, band.height, band.low(), request.frame_s};
  const float farthest = 1.0f;
  begin(band);
  glDepthMask(GL_TRUE);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  if (ground.solid) drawGround(view, ground, band);
  if (frame != nullptr)
    if (auto drawn = effects.drawSolidSurfaces(*frame, layers, view, ground, surface); !drawn) return drawn;
  image.width = width;
  image.height = band.rows;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(band.rows);
  image.depth.resize(request.depth ? pixels : 0);
  image.motion.resize(request.motion ? 2 * pixels : 0);
  take(image, request, false);
  if (std::ranges::any_of(layers, [](const LayerSpan& layer) { return isSoft(layer.form); }) && frame != nullptr) {
    begin(band);
    if (auto drawn = effects.drawSoftSurfaces(*frame, layers, view, ground, surface); !drawn) return drawn;
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
    take(image, request, true);
  }
  return {};
}

void SurfacePass::take(FloatImage& image, const FloatRequest& request, bool puffs) {
  readFloats(image.width, image.height, read_);
  const std::size_t pixels = read_.size() / 4;
  for (std::size_t i = 0; i < pixels; ++i) {
    const float* values = read_.data() + 4 * i;
    const float cover = values[3];
    if (puffs && cover < kLeastCover) continue;
    if (request.depth) image.depth[i] = cover > 0.0f ? values[0] / cover : std::numeric_limits<float>::infinity();
    if (request.motion)
      for (std::size_t c = 0; c < 2; ++c) image.motion[2 * i + c] = cover > 0.0f ? values[1 + c] / cover : 0.0f;
  }
}

}  // namespace npsee::render
