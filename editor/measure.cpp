#include "editor/measure.h"

#include "sim/core/text.h"

#include <algorithm>
#include <map>

namespace npsee::editor {
namespace {

std::string figure(double value) { return withDecimals(value, 1); }

/// Which qualities were shown, and in how many frames of a hundred each.
std::string qualities(const std::vector<FrameTimes>& frames) {
  std::map<std::string, std::size_t> counts;
  for (const FrameTimes& frame : frames) ++counts[frame.quality];
  std::string out;
  for (const auto& [quality, count] : counts) out += (out.empty() ? "" : ", ") + quality + ' ' + std::to_string((100 * count + frames.size() / 2) / frames.size()) + " %";
  return out;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> FrameMeter::figures() const {
  if (frames_.empty()) return {{"frames", "0"}};
  std::vector<double> whole;
  FrameTimes sum;
  std::size_t changes = 0, still = 0;
  for (const FrameTimes& frame : frames_) {
    if (!whole.empty() && frame.quality != frames_[whole.size() - 1].quality) ++changes;
    whole.push_back(frame.whole_ms);
    if (!frame.drawn) ++still;
    sum.whole_ms += frame.whole_ms;
    sum.cpu_ms += frame.cpu_ms;
    sum.panels_ms += frame.panels_ms;
    sum.window_ms += frame.window_ms;
    sum.pictures.explosion_ms += frame.pictures.explosion_ms;
    sum.pictures.template_ms += frame.pictures.template_ms;
    sum.pictures.mission_ms += frame.pictures.mission_ms;
    sum.pictures.drawn += frame.pictures.drawn;
  }
  std::ranges::sort(whole);
  const auto count = static_cast<double>(frames_.size());
  const auto mean = [count](double total) { return figure(total / count); };
  return {{"frames", std::to_string(frames_.size())},
          {"fps", figure(1000.0 * count / std::max(sum.whole_ms, 1e-6))},
          {"median_ms", figure(whole[whole.size() / 2])},
          {"slow_ms", figure(whole[whole.size() * 19 / 20])},
          {"cpu_ms", mean(sum.cpu_ms)},
          {"explosion_ms", mean(sum.pictures.explosion_ms)},
          {"template_ms", mean(sum.pictures.template_ms)},
          {"mission_ms", mean(sum.pictures.mission_ms)},
          {"panels_ms", mean(sum.panels_ms)},
          {"window_ms", mean(sum.window_ms)},
          {"pictures", std::to_string(sum.pictures.drawn)},
          {"unchanged", std::to_string(still)},
          {"quality", qualities(frames_)},
          {"quality_changes", std::to_string(changes)}};
}

}  // namespace npsee::editor
