#include "editor/document/template_ease.h"

#include <npsee/parameters.h>

#include <algorithm>
#include <cmath>

namespace npsee::editor {
namespace {

constexpr double kTime_s = 0.07;      ///< in which what is missing shrinks to a third
constexpr double kNear = 2e-3;        ///< share of the slider's range that nobody sees

/// Takes the numbers of `now` towards those of `wanted`; all else is that of `wanted`. True while something is missing.
bool glide(const Layer& wanted, Layer& now, double share) {
  Layer next = wanted;
  bool missing = false;
  for (const Parameter& row : parameters(Scope::layer)) {
    if (row.type != ParameterType::number) continue;
    const double to = std::get<double>(row.get(wanted)), from = std::get<double>(row.get(now));
    const double span = std::abs(toSi(row.unit, row.slider.max) - toSi(row.unit, row.slider.min));
    if (std::abs(to - from) <= kNear * span) continue;
    row.assign(next, from + share * (to - from));
    missing = true;
  }
  now = std::move(next);
  return missing;
}

}  // namespace

void TemplateEase::update(const std::shared_ptr<const Preset>& preset, int layer, double elapsed_s, bool at_once) {
  const bool same = preset == of_ && layer == layer_;
  if (same && !moving_) return;
  of_ = preset;
  layer_ = layer;
  moving_ = false;
  if (preset == nullptr || layer < 0 || layer >= static_cast<int>(preset->layers.size())) {
    shown_.layers.clear();
    return;
  }
  const Layer& wanted = preset->layers[static_cast<std::size_t>(layer)];
  shown_.burst = preset->burst;
  if (at_once || shown_.layers.empty()) {
    shown_.layers = {wanted};
    return;
  }
  moving_ = glide(wanted, shown_.layers.front(), 1.0 - std::exp(-std::max(elapsed_s, 0.0) / kTime_s));
}

}  // namespace npsee::editor
