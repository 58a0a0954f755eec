#include "editor/document/compare.h"

#include "app/render/renderer.h"

namespace npsee::editor {

void Compare::update(double time_s, bool wait) {
  if (!on()) return;
  shelf.request({preset});
  shelf.poll(wait);
  if (explosion() != nullptr) explosion()->at(time_s, frame, render::kSceneFields);
}

void Variations::update(double time_s, bool wait) {
  if (!open) return;
  shelf.request({presets.begin(), presets.end()});
  shelf.poll(wait);
  for (std::size_t i = 0; i < kCount; ++i)
    if (shelf.at(i) != nullptr) shelf.at(i)->at(time_s, frames[i], render::kSceneFields);
}

}  // namespace npsee::editor
