#include "app/render/finish_pass.h"

#include "app/gl/state.h"
#include "app/render/srgb.h"

#include <algorithm>
#include <cmath>

namespace npsee::render {

Expected<FinishPass> FinishPass::create() {
  FinishPass pass;
  for (const auto& loaded : {pass.clear_.load("tiles.vert", "clear.frag"), pass.single_.load("tiles.vert", "finish.frag")})
    if (!loaded) return tl::unexpected<Error>(loaded.error());
  return pass;
}

void FinishPass::clear(const TileMesh& tiles) const {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_CLIP_DISTANCE0);
  clear_.use();
  tiles.draw(clear_, 1.0f);
}

Expected<void> FinishPass::add(const Target& target, const TileMesh& tiles, double share) {
  if (!sum_)
    if (auto loaded = sum_.load("tiles.vert", "sum.frag"); !loaded) return loaded;
  gl::drawPlainly();
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
  sum_.use();
  sum_.set("u_scene", 0);
  sum_.set("u_weight", static_cast<float>(share));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, target.look());
  glBindSampler(0, 0);
  tiles.draw(sum_, 0.0f);
  return {};
}

Expected<void> FinishPass::drawOverBackdrop(const Target& target, const TileMesh& tiles, double exposure, const BloomLight& bloom) {
  target.copyBackdrop();
  return lay(target, tiles, 2, {}, exposure, bloom);
}

Expected<void> FinishPass::drawOverColour(const Target& target, const TileMesh& tiles, const Colour* behind, double exposure, const BloomLight& bloom) {
  const Colour plain = behind != nullptr ? *behind : Colour{};
  target.bindFinished();
  glClearColor(static_cast<float>(plain.r), static_cast<float>(plain.g), static_cast<float>(plain.b), behind != nullptr ? 1.0f : 0.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  return lay(target, tiles, behind != nullptr ? 1 : 0, plain, exposure, bloom);
}

Expected<void> FinishPass::drawMission(const Target& target, const TileMesh& tiles, double exposure, const BloomLight& bloom) {
  gl::Program& program = target.draft() ? mission_draft_ : target.smooth() ? mission_smooth_ : mission_;
  if (!program)
    if (auto loaded = program.load("tiles.vert", target.draft() ? "finish_mission_draft.frag" : target.smooth() ? "finish_mission_smooth.frag" : "finish_mission.frag"); !loaded) return loaded;
  target.bindFinished();
  gl::drawPlainly();
  program.use();
  if (target.draft()) setDraft(program, target);
  program.set("u_scene", 0);
  setLight(program, exposure, bloom);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(target.smooth() ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, target.effect());
  glBindSampler(0, 0);
  tiles.draw(program, 0.0f);
  return {};
}

void FinishPass::setScene(const gl::Program& program, const Target& target, int behind, const Colour& plain) {
  program.use();
  program.set("u_scene", 0);
  program.set("u_backdrop", 1);
  program.set("u_behind", behind);
  setPlain(program, plain);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, target.backdrop());
  glBindSampler(1, 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(target.smooth() ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, target.effect());
  glBindSampler(0, 0);
}

Expected<void> FinishPass::lay(const Target& target, const TileMesh& tiles, int behind, const Colour& plain, double exposure, const BloomLight& bloom) {
  if (target.draft()) return layDraft(target, tiles, behind, plain, exposure);
  if (target.smooth() && !smooth_)
    if (auto loaded = smooth_.load("tiles.vert", "finish_smooth.frag"); !loaded) return loaded;
  target.bindFinished();
  gl::drawPlainly();
  const gl::Program& program = target.smooth() ? smooth_ : single_;
  setScene(program, target, behind, plain);
  setLight(program, exposure, bloom);
  tiles.draw(program, 0.0f);
  return {};
}

Expected<void> FinishPass::layDraft(const Target& target, const TileMesh& tiles, int behind, const Colour& plain, double exposure) {
  if (!draft_) {
    if (auto loaded = draft_.load("tiles.vert", "finish_draft.frag"); !loaded) return loaded;
    if (auto loaded = enlarge_.load("tiles.vert", "enlarge_draft.frag"); !loaded) return loaded;
  }
  gl::drawPlainly();
  target.bindDraft();
  setScene(draft_, target, behind, plain);
  const auto width = static_cast<float>(target.width()), height = static_cast<float>(target.height());
  draft_.set("u_exposure", static_cast<float>(exposure));
  draft_.set("u_scale", width / static_cast<float>(target.draftWidth()), height / static_cast<float>(target.draftHeight()));
  tiles.draw(draft_, 0.0f);
  target.bindFinished();
  if (behind != 0) gl::blendOver();
  enlarge_.use();
  enlarge_.set("u_draft", 0);
  enlarge_.set("u_picture", width, height);
  enlarge_.set("u_straight", behind == 0 ? 1 : 0);
  glBindTexture(GL_TEXTURE_2D, target.draftLight());
  tiles.draw(enlarge_, 0.0f);
  return {};
}

void setDraft(const gl::Program& program, const Target& target) {
  const auto set = [&](const char* name, double x, double y) { program.set(name, static_cast<float>(x), static_cast<float>(y)); };
  set("u_per_pixel", static_cast<double>(target.draftWidth()) / target.width(), static_cast<double>(target.draftHeight()) / target.height());
  set("u_used", target.draftWidth(), target.draftHeight());
  set("u_texels", target.width(), target.height());
}

void setLight(const gl::Program& program, double exposure, const BloomLight& bloom) {
  program.set("u_bloom", 2);
  program.set("u_exposure", static_cast<float>(exposure));
  program.set("u_bloom_share", static_cast<float>(bloom.texture != 0 ? bloom.share : 0.0));
  program.set("u_bloom_cell", bloom.cell_px);
  program.set("u_bloom_size", static_cast<float>(std::max(bloom.width_px, 1.0)), static_cast<float>(std::max(bloom.height_px, 1.0)));
  glActiveTexture(GL_TEXTURE2);
  glBindTexture(GL_TEXTURE_2D, bloom.texture);
  glBindSampler(2, 0);
}

void setPlain(const gl::Program& program, const Colour& plain) {
  program.set("u_plain", static_cast<float>(linearFromSrgb(plain.r)), static_cast<float>(linearFromSrgb(plain.g)), static_cast<float>(linearFromSrgb(plain.b)));
}

}  // namespace npsee::render
