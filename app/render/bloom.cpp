#include "app/render/bloom.h"

#include "app/gl/state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace npsee::render {
namespace {

/// Cells of the finest level in the picture's height, and of the coarsest at least.
constexpr int kFinest = 180, kCoarsest = 8;
/// Weights of cells of 1/90, 1/45, 1/22 and 1/11 of the height; the finest level only carries.
constexpr std::array<double, 4> kWeights{0.34, 0.28, 0.22, 0.16};

/// Between the weights by the logarithm of the cell's size, so that pictures of any height have the same profile.
double weightOf(double cells_in_height) {
  const double at = std::log2(90.0 / cells_in_height);
  if (at <= -1.0 || at >= 4.0) return 0.0;
  const int low = static_cast<int>(std::floor(at));
  const auto weight = [](int i) { return i < 0 || i > 3 ? 0.0 : kWeights[static_cast<std::size_t>(i)]; };
  return weight(low) + (weight(low + 1) - weight(low)) * (at - low);
}

void setUp(gl::Texture& texture, gl::Framebuffer& frame, int width, int height) {
  texture = gl::Texture::make();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, width, height, 0, GL_RGBA, GL_HALF_FLOAT, nullptr);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  // Beyond the picture it is dark.
  const float none[] = {0.0f, 0.0f, 0.0f, 0.0f};
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_BORDER);
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, none);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  frame = gl::Framebuffer::make();
  glBindFramebuffer(GL_FRAMEBUFFER, frame.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
}

}  // namespace

int Bloom::cellOf(int height) { return std::max(1, (height + kFinest / 2) / kFinest); }

Expected<Bloom> Bloom::create() {
  Bloom pass;
  for (const auto& loaded : {pass.bright_.load("tiles.vert", "bloom_bright.frag"), pass.bright_smooth_.load("tiles.vert", "bloom_bright_smooth.frag"), pass.down_.load("fullscreen.vert", "bloom_down.frag"),
                             pass.up_.load("fullscreen.vert", "bloom_up.frag")})
    if (!loaded) return tl::unexpected<Error>(loaded.error());
  pass.nothing_ = gl::VertexArray::make();
  return pass;
}

Expected<void> Bloom::resize(int width, int height) {
  if (width == width_ && height == height_) return {};
  levels_.clear();
  width_ = height_ = 0;
  cell_ = cellOf(height);
  double sum = 0.0;
  int cell = cell_;
  for (int w = (width + cell_ - 1) / cell_, h = (height + cell_ - 1) / cell_;; w = (w + 1) / 2, h = (h + 1) / 2, cell *= 2) {
    Level level;
    level.width = w;
    level.height = h;
    // The finest level's own cells would show.
    level.weight = static_cast<float>(levels_.empty() ? 0.0 : weightOf(static_cast<double>(height) / cell));
    sum += static_cast<double>(level.weight);
    setUp(level.texture, level.frame, w, h);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE || gl::pendingError() != nullptr) {
      levels_.clear();
      return fail(ErrorKind::graphics, "the driver has no room for the spread light of a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels.", "Choose a smaller size, or --quality draft.");
    }
    levels_.push_back(std::move(level));
    if (h / 2 < kCoarsest || w <= 1) break;
  }
  if (!(sum > 0.0)) levels_.back().weight = 1.0f;
  else
    for (Level& level : levels_) level.weight = static_cast<float>(static_cast<double>(level.weight) / sum);
  width_ = width;
  height_ = height;
  return {};
}

void Bloom::take(const Target& target, const TileMask& bright) {
  const Level& to = levels_.front();
  glBindFramebuffer(GL_FRAMEBUFFER, to.frame.name());
  glViewport(0, 0, to.width, to.height);
  const float none[] = {0.0f, 0.0f, 0.0f, 0.0f};
  glClearBufferfv(GL_COLOR, 0, none);
  const gl::Program& program = target.smooth() ? bright_smooth_ : bright_;
  program.use();
  program.set("u_scene", 0);
  program.set("u_cell", cell_);
  program.set("u_last", static_cast<float>(width_ - 1), static_cast<float>(height_ - 1));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(target.smooth() ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, target.effect());
  glBindSampler(0, 0);
  tiles_.upload(bright);
  tiles_.draw(program, 0.0f, to.width * cell_, to.height * cell_);
}

void Bloom::down(const Level& from, const Level& to) const {
  glBindFramebuffer(GL_FRAMEBUFFER, to.frame.name());
  glViewport(0, 0, to.width, to.height);
  glBindTexture(GL_TEXTURE_2D, from.texture.name());
  down_.set("u_size", static_cast<float>(from.width), static_cast<float>(from.height));
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Bloom::up(const Level& from, const Level& to, float scale) const {
  glBindFramebuffer(GL_FRAMEBUFFER, to.frame.name());
  glViewport(0, 0, to.width, to.height);
  glBindTexture(GL_TEXTURE_2D, from.texture.name());
  up_.set("u_size", static_cast<float>(from.width), static_cast<float>(from.height));
  up_.set("u_scale", scale);
  // The alpha says where light was taken: it stays.
  glBlendColor(to.weight, to.weight, to.weight, 1.0f);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Expected<BloomLight> Bloom::run(const Target& target, const TileMask& bright) {
  if (auto sized = resize(target.width(), target.height()); !sized) return tl::unexpected<Error>(sized.error());
  gl::drawPlainly();
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  take(target, bright);
  glBindVertexArray(nothing_.name());
  down_.use();
  down_.set("u_depth", 0.0f);
  down_.set("u_from", 0);
  for (std::size_t i = 0; i + 1 < levels_.size(); ++i) down(levels_[i], levels_[i + 1]);
  up_.use();
  up_.set("u_depth", 0.0f);
  up_.set("u_from", 0);
  // What a level has of its own counts by its weight, what comes from the coarser ones is weighted already.
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_CONSTANT_COLOR);
  for (std::size_t i = levels_.size() - 1; i > 0; --i) up(levels_[i], levels_[i - 1], i + 1 == levels_.size() ? levels_[i].weight : 1.0f);
  glDisable(GL_BLEND);
  const Level& finest = levels_.front();
  // A picture of one cell keeps its light.
  if (levels_.size() < 2) return BloomLight{};
  return BloomLight{finest.texture.name(), kShare, static_cast<double>(finest.width) * cell_, static_cast<double>(finest.height) * cell_, cell_};
}

}  // namespace npsee::render
