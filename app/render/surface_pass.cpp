#include "app/render/surface_pass.h"

#include "app/gl/state.h"
#include "app/render/float_target.h"
#include "app/render/meshes.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace npsee::render {
namespace {

/// Cover from which puffs together are a surface.
constexpr float kLeastCover = 0.5f;
/// Rows read at a time.
constexpr int kBand = 256;

}  // namespace

Expected<SurfacePass> SurfacePass::create() {
  auto ground = gl::Program::fromFiles("fullscreen.vert", "surface_ground.frag");
  if (!ground) return tl::unexpected<Error>(ground.error());
  SurfacePass pass;
  pass.ground_ = std::move(*ground);
  pass.nothing_ = gl::VertexArray::make();
  return pass;
}

Expected<void> SurfacePass::resize(int width, int height) {
  if (width_ == width && height_ == height) return {};
  width_ = height_ = 0;
  depth_ = gl::Renderbuffer::make();
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  auto made = makeFloatTexture(width, height, frame_);
  if (!made) return tl::unexpected<Error>(made.error());
  values_ = std::move(*made);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  if (const char* error = gl::pendingError()) return fail(ErrorKind::graphics, std::string("the driver has no room for the depth of the picture: ") + error + ".", "Choose a smaller size.");
  width_ = width;
  height_ = height;
  return {};
}

void SurfacePass::begin() const {
  const float nothing[] = {0.0f, 0.0f, 0.0f, 0.0f};
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glViewport(0, 0, width_, height_);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearBufferfv(GL_COLOR, 0, nothing);
}

void SurfacePass::drawGround(const View& view, const GroundLevel& ground) const {
  // The ground is behind all that is drawn: what lies below it is clipped.
  gl::drawPlainly();
  ground_.use();
  setView(ground_, view);
  ground_.set("u_depth", 0.0f);
  ground_.set("u_height", static_cast<float>(ground.height_m));
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Expected<void> SurfacePass::run(EffectPasses& effects, const Frame* frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, int width, int height, const FloatRequest& request, FloatImage& image) {
  if (auto sized = resize(width, height); !sized) return sized;
  const SurfaceFrame surface{width, height, request.frame_s};
  const float farthest = 1.0f;
  begin();
  glDepthMask(GL_TRUE);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  if (ground.solid) drawGround(view, ground);
  if (frame != nullptr)
    if (auto drawn = effects.drawSolidSurfaces(*frame, layers, view, ground, surface); !drawn) return drawn;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  image.depth.resize(request.depth ? pixels : 0);
  image.motion.resize(request.motion ? 2 * pixels : 0);
  take(image, request, false);
  if (std::ranges::any_of(layers, [](const LayerSpan& layer) { return isSoft(layer.form); }) && frame != nullptr) {
    begin();
    if (auto drawn = effects.drawSoftSurfaces(*frame, layers, view, ground, surface); !drawn) return drawn;
    glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
    take(image, request, true);
  }
  if (static_cast<long long>(width) * height > kMostKeptPixels) {
    frame_.reset();
    values_.reset();
    depth_.reset();
    width_ = height_ = 0;
  }
  return {};
}

void SurfacePass::take(FloatImage& image, const FloatRequest& request, bool puffs) {
  const auto columns = static_cast<std::size_t>(width_);
  for (int first = 0; first < height_; first += kBand) {
    const int rows = std::min(kBand, height_ - first);
    readRows(width_, first, rows, band_);
    for (int row = 0; row < rows; ++row) {
      // GL's first row is the lowest.
      const std::size_t to = static_cast<std::size_t>(height_ - 1 - first - row) * columns;
      const float* values = band_.data() + 4 * static_cast<std::size_t>(row) * columns;
      for (std::size_t x = 0; x < columns; ++x, values += 4) {
        const float cover = values[3];
        if (puffs && cover < kLeastCover) continue;
        if (request.depth) image.depth[to + x] = cover > 0.0f ? values[0] / cover : std::numeric_limits<float>::infinity();
        if (request.motion)
          for (std::size_t c = 0; c < 2; ++c) image.motion[2 * (to + x) + c] = cover > 0.0f ? values[1 + c] / cover : 0.0f;
      }
    }
  }
}

}  // namespace npsee::render
