#include "editor/ui/items.h"

#include <algorithm>
#include <utility>

namespace npsee::editor {

void Items::beginFrame() {
  shown_ = std::exchange(drawn_, {});
  drawn_.reserve(shown_.size());
}

void Items::add(std::string name, ImVec2 min, ImVec2 max, ImVec2 clip_min, ImVec2 clip_max) {
  const ImVec2 low(std::max(min.x, clip_min.x), std::max(min.y, clip_min.y));
  const ImVec2 high(std::max(low.x, std::min(max.x, clip_max.x)), std::max(low.y, std::min(max.y, clip_max.y)));
  const float shown = (high.x - low.x) * (high.y - low.y), whole = (max.x - min.x) * (max.y - min.y);
  drawn_.push_back({std::move(name), low, high, shown > 0.0f && shown >= 0.5f * whole});
}

const Items::Item* Items::find(std::string_view name) const {
  const auto found = std::ranges::find(shown_, name, &Item::name);
  return found == shown_.end() ? nullptr : &*found;
}

}  // namespace npsee::editor
