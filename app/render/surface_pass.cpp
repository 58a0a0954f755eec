#include "app/render/surface_pass.h"

#include "app/render/float_target.h"

#include <limits>

namespace npsee::render {

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
  auto made = makeFloatTexture(width, height, frame_);
  if (!made) return tl::unexpected<Error>(made.error());
  surface_ = std::move(*made);
  depth_ = gl::Renderbuffer::make();
  glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
  if (const char* error = gl::pendingError()) return fail(ErrorKind::graphics, std::string("the driver has no room for the depth of the picture: ") + error + ".", "Choose a smaller size.");
  width_ = width;
  height_ = height;
  return {};
}

void SurfacePass::drawGround(const View& view, const GroundLevel& ground) const {
  // The ground is behind all that is drawn: what lies below it is clipped.
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_CLIP_DISTANCE0);
  ground_.use();
  setView(ground_, view);
  ground_.set("u_depth", 0.0f);
  ground_.set("u_height", static_cast<float>(ground.height_m));
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Expected<void> SurfacePass::run(EffectPasses& effects, const Frame* frame, std::span<const LayerSpan> layers, const View& view, const GroundLevel& ground, int width, int height, const FloatRequest& request, FloatImage& image) {
  if (auto sized = resize(width, height); !sized) return sized;
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  const float nothing[] = {0.0f, 0.0f, 0.0f, 0.0f}, farthest = 1.0f;
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  if (ground.solid) drawGround(view, ground);
  if (frame != nullptr)
    if (auto drawn = effects.drawSurfaces(*frame, layers, view, ground, {width, height, request.frame_s}); !drawn) return drawn;
  readFloats(width, height, read_);
  const std::size_t pixels = read_.size() / 4;
  image.depth.resize(request.depth ? pixels : 0);
  image.motion.resize(request.motion ? 2 * pixels : 0);
  for (std::size_t i = 0; i < image.depth.size(); ++i) image.depth[i] = read_[4 * i + 3] > 0.0f ? read_[4 * i] : std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < image.motion.size(); ++i) image.motion[i] = read_[4 * (i / 2) + 1 + i % 2];
  return {};
}

}  // namespace npsee::render
