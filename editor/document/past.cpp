#include "editor/document/past.h"

#include <cmath>

namespace npsee::editor {

const std::vector<Frame>& Past::at(const std::shared_ptr<const Explosion>& explosion, double time_s, double span_s, std::size_t count) {
  if (explosion == of_ && time_s == time_s_ && span_s == span_s_ && count == count_) return frames_;
  of_ = explosion;
  time_s_ = time_s;
  span_s_ = span_s;
  count_ = count;
  std::size_t filled = 0;
  if (explosion != nullptr && explosion->particleCount() <= kMostParticles) {
    for (std::size_t k = 1; k <= count; ++k) {
      const double t = time_s - span_s * static_cast<double>(k) / static_cast<double>(count);
      if (t < 0.0) break;
      if (filled == frames_.size()) frames_.emplace_back();
      explosion->at(t, frames_[filled++], kPosition);
    }
  }
  frames_.resize(filled);
  return frames_;
}

double roundTime(double duration_s, double share) {
  const double wish = duration_s * share;
  if (!(wish > 0.0)) return 0.1;
  const double decade = std::pow(10.0, std::floor(std::log10(wish))), lead = wish / decade;
  return decade * (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0);
}

}  // namespace npsee::editor
