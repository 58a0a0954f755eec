#include "editor/document/quality_chooser.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace npsee::editor {
namespace {

constexpr double kRest_s = 0.35;       ///< nothing moved for so long: it stands still, and is not merely held between two movements
constexpr double kGoes_s = 0.040;      ///< a frame may take so long at a finer level: less than kTooSlow_s, so that it stays there
constexpr double kDisplay_s = 0.0175;  ///< hardly more than a frame of a display of 60 Hz
constexpr double kLongest_s = 60.0;    ///< of patience
constexpr double kTooSoon_s = 4.0;     ///< a finer level that is left again by then was a mistake
constexpr int kFirst = 3;              ///< frames that make textures and compile shaders
constexpr int kEnough = 8;             ///< frames that are judged

}  // namespace

std::string qualityText(const DrawnQuality& quality) {
  std::string out(render::kQualityNames[static_cast<std::size_t>(quality.quality)]);
  if (quality.share < 1.0) out += ", " + std::to_string(static_cast<int>(std::lround(100.0 * quality.share))) + " % of the pixels across";
  return out;
}

const DrawnQuality& QualityChooser::choose(std::string_view wish, bool moves, double elapsed_s) {
  rested_s_ = moves ? 0.0 : rested_s_ + elapsed_s;
  if (wish == "draft" || wish == "normal") return drawn_ = {wish == "draft" ? render::Quality::draft : render::Quality::normal, 1.0};
  if (rested_s_ > kRest_s) {
    frames_ = 0;
    return drawn_ = {wish == "fine" ? render::Quality::fine : render::Quality::normal, 1.0};
  }
  // What a frame takes in which nothing was drawn anew says nothing.
  if (moves) adapt(elapsed_s);
  return drawn_ = kLevels[level_];
}

void QualityChooser::go(std::size_t level) {
  level_ = level;
  frames_ = 0;
  easy_s_ = 0.0;
}

void QualityChooser::adapt(double elapsed_s) {
  since_rise_s_ += elapsed_s;
  if (++frames_ <= kFirst) return;
  interval_s_ = frames_ == kFirst + 1 ? elapsed_s : interval_s_ + 0.25 * (elapsed_s - interval_s_);
  if (frames_ < kEnough) return;
  if (left_s_ > 0.0) dearer_[level_] = std::clamp(std::exchange(left_s_, 0.0) / std::max(interval_s_, 1e-4), 1.0, 16.0);
  if (interval_s_ > kTooSlow_s) {
    if (level_ + 1 == kLevels.size()) return;
    if (since_rise_s_ < kTooSoon_s) patience_s_ = std::min(2.0 * patience_s_, kLongest_s);
    left_s_ = interval_s_;
    return go(level_ + 1);
  }
  // Where frames wait for the display, what they take is hidden: then a finer level is only tried, after a longer while.
  const bool goes = interval_s_ * dearer_[level_] <= kGoes_s, waits = interval_s_ < kDisplay_s;
  if (level_ == 0 || (!goes && !waits)) {
    easy_s_ = 0.0;
    return;
  }
  easy_s_ += elapsed_s;
  if (easy_s_ < (goes ? 1.0 : 4.0) * patience_s_) return;
  since_rise_s_ = 0.0;
  go(level_ - 1);
}

}  // namespace npsee::editor
