#include "app/render/deep_finish.h"

#include "app/gl/state.h"
#include "app/render/finish_pass.h"
#include "app/render/float_target.h"

namespace npsee::render {

Expected<DeepFinish> DeepFinish::create() {
  DeepFinish pass;
  if (auto loaded = pass.program_.load("tiles.vert", "deep.frag"); !loaded) return tl::unexpected<Error>(loaded.error());
  return pass;
}

Expected<void> DeepFinish::run(const Target& target, const TileMask& effect, bool over_backdrop, const Colour* plain, bool linear, const BloomLight& bloom, FloatImage& image) {
  if (width_ != target.width() || height_ != target.height()) {
    auto made = makeFloatTexture(target.width(), target.height(), frame_);
    if (!made) return tl::unexpected<Error>(made.error());
    result_ = std::move(*made);
    width_ = target.width();
    height_ = target.height();
  }
  image.width = width_;
  image.height = height_;
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  glViewport(0, 0, width_, height_);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const int behind = over_backdrop ? 2 : plain != nullptr ? 1 : 0;
  const Colour colour = plain != nullptr ? *plain : Colour{};
  // Outside the effect's tiles the target holds what an earlier picture left.
  all_.reset(width_, height_);
  all_.markAll();
  tiles_.upload(all_);
  draw(target, tiles_, behind, colour, linear, nullptr);
  if (!effect.empty()) {
    tiles_.upload(effect);
    draw(target, tiles_, behind, colour, linear, &bloom);
  }
  readFloats(width_, height_, image.rgba);
  if (static_cast<long long>(width_) * height_ > kMostKeptPixels) {
    frame_.reset();
    result_.reset();
    width_ = height_ = 0;
  }
  return {};
}

void DeepFinish::draw(const Target& target, const TileMesh& tiles, int behind, const Colour& plain, bool linear, const BloomLight* bloom) const {
  const bool with_effect = bloom != nullptr;
  gl::drawPlainly();
  program_.use();
  program_.set("u_scene", 0);
  program_.set("u_backdrop", 1);
  program_.set("u_behind", behind);
  program_.set("u_effect", with_effect ? 1.0f : 0.0f);
  program_.set("u_linear", linear ? 1 : 0);
  setPlain(program_, plain);
  setBloom(program_, with_effect ? *bloom : BloomLight{});
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, target.backdrop());
  glBindSampler(1, 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, with_effect ? target.effect() : target.backdrop());
  glBindSampler(0, 0);
  tiles.draw(program_, 0.0f);
}

}  // namespace npsee::render
