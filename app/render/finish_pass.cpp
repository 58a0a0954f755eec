#include "app/render/finish_pass.h"

#include <cmath>

namespace npsee::render {
namespace {

/// IEC 61966-2-1.
float linearFromSrgb(double c) { return static_cast<float>(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4)); }

}  // namespace

Expected<FinishPass> FinishPass::create() {
  auto program = gl::Program::fromFiles("fullscreen.vert", "finish.frag");
  if (!program) return tl::unexpected<Error>(program.error());
  FinishPass pass;
  pass.program_ = std::move(*program);
  pass.nothing_ = gl::VertexArray::make();
  return pass;
}

void FinishPass::draw(const Target& target, const Colour* behind, bool rows_from_top) const {
  target.resolve();
  target.bindFinished();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_FRAMEBUFFER_SRGB);
  program_.use();
  program_.set("u_depth", 0.0f);
  program_.set("u_scene", 0);
  program_.set("u_flip_height", rows_from_top ? target.height() : 0);
  const Colour colour = behind != nullptr ? *behind : Colour{};
  program_.set("u_background", static_cast<float>(colour.r), static_cast<float>(colour.g), static_cast<float>(colour.b), behind != nullptr ? 1.0f : 0.0f);
  program_.set("u_background_light", linearFromSrgb(colour.r), linearFromSrgb(colour.g), linearFromSrgb(colour.b));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, target.light());
  glBindSampler(0, 0);
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace npsee::render
