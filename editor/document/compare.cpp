#include "editor/document/compare.h"

#include "app/render/renderer.h"

namespace npsee::editor {

void Compare::update(double at_s, bool wait) {
  if (!on()) return;
  shelf.request({preset});
  shelf.poll(wait);
  if (explosion() == nullptr || (explosion() == evaluated_ && at_s == time_s)) return;
  explosion()->at(time_s = at_s, frame, render::kSceneFields);
  evaluated_ = explosion();
}

void Variations::update(double at_s, bool wait) {
  if (!open) return;
  shelf.request({presets.begin(), presets.end()});
  shelf.poll(wait);
  for (std::size_t i = 0; i < kCount; ++i) {
    if (shelf.at(i) == nullptr || (shelf.at(i) == evaluated_[i] && at_s == time_s)) continue;
    shelf.at(i)->at(at_s, frames[i], render::kSceneFields);
    evaluated_[i] = shelf.at(i);
  }
  time_s = at_s;
}

}  // namespace npsee::editor
