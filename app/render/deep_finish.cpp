#include "app/render/deep_finish.h"

#include "app/gl/state.h"
#include "app/render/finish_pass.h"

namespace npsee::render {

Expected<DeepFinish> DeepFinish::create() {
  DeepFinish pass;
  if (auto loaded = pass.program_.load("tiles.vert", "deep.frag"); !loaded) return tl::unexpected<Error>(loaded.error());
  return pass;
}

Expected<void> DeepFinish::resize(int width, int rows) {
  // The last band of a picture may be lower than the others.
  if (width_ == width && rows_ >= rows) return {};
  auto made = makeFloatTexture(width, rows, frame_);
  if (!made) return tl::unexpected<Error>(made.error());
  result_ = std::move(*made);
  width_ = width;
  rows_ = rows;
  return {};
}

Expected<void> DeepFinish::run(const Target& target, const DeepParts& parts, const RowBand& band, FloatImage& image) {
  if (auto sized = resize(target.width(), band.rows); !sized) return sized;
  image.width = width_;
  image.height = band.rows;
  glBindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  showBand(band, width_);
  // Outside the effect's tiles the target holds what an earlier picture left.
  all_.reset(width_, target.height());
  all_.markAll();
  tiles_.upload(all_);
  if (auto drawn = draw(target, tiles_, parts, band, false); !drawn) return drawn;
  if (!parts.effect.empty()) {
    tiles_.upload(parts.effect);
    if (auto drawn = draw(target, tiles_, parts, band, true); !drawn) return drawn;
  }
  readFloats(width_, band.rows, image.rgba);
  return {};
}

Expected<void> DeepFinish::draw(const Target& target, const TileMesh& tiles, const DeepParts& parts, const RowBand& band, bool with_effect) {
  const bool draft = with_effect && target.draft();
  if (draft && !draft_)
    if (auto loaded = draft_.load("tiles.vert", "deep_draft.frag"); !loaded) return loaded;
  gl::drawPlainly();
  const gl::Program& program = draft ? draft_ : program_;
  program.use();
  if (draft) setDraft(program, target);
  program.set("u_scene", 0);
  program.set("u_backdrop", 1);
  program.set("u_low", band.low());
  program.set("u_behind", parts.over_backdrop ? 2 : parts.plain != nullptr ? 1 : 0);
  program.set("u_effect", with_effect ? 1.0f : 0.0f);
  program.set("u_linear", parts.linear ? 1 : 0);
  setPlain(program, parts.plain != nullptr ? *parts.plain : Colour{});
  setLight(program, parts.exposure, with_effect ? parts.bloom : BloomLight{});
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, target.backdrop());
  glBindSampler(1, 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, with_effect ? target.effect() : target.backdrop());
  glBindSampler(0, 0);
  tiles.draw(program, 0.0f);
  return {};
}

}  // namespace npsee::render
