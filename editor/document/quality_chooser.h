#pragma once

#include "app/render/quality.h"

#include <array>
#include <string>
#include <string_view>

namespace npsee::editor {

/// How finely a picture that people work on is drawn.
struct DrawnQuality {
  render::Quality quality = render::Quality::normal;
  double share = 1.0;  ///< of the pixels' number across and down that are drawn
  friend bool operator==(const DrawnQuality&, const DrawnQuality&) = default;
};
/// "normal", "draft, 71 % of the pixels across".
std::string qualityText(const DrawnQuality& quality);

/// What can be wished, as settings name it: automatic, or one of render::kQualityNames.
inline constexpr std::array<std::string_view, 4> kQualityWishes{"automatic", "draft", "normal", "fine"};

/// Chooses the quality of the next picture.
///
/// Draft and normal are kept. Otherwise a picture that stands still is normal, or fine where that is wished, and one that moves is as fine as keeps
/// up with 20 frames a second. It becomes finer again only where that is known to go: from what it took before, relative to what it takes now,
/// and later each time that this was wrong. So it does not flicker.
class QualityChooser {
 public:
  /// Once a frame: whether what is shown `moves`, and the time since the last frame.
  const DrawnQuality& choose(std::string_view wish, bool moves, double elapsed_s);
  const DrawnQuality& drawn() const { return drawn_; }

  /// From fine to quick.
  static constexpr std::array<DrawnQuality, 4> kLevels{{{render::Quality::normal, 1.0}, {render::Quality::draft, 1.0}, {render::Quality::draft, 0.71}, {render::Quality::draft, 0.5}}};
  static constexpr double kTooSlow_s = 0.050;  ///< a frame, smoothed

 private:
  void adapt(double elapsed_s);
  void go(std::size_t level);

  DrawnQuality drawn_;
  std::size_t level_ = 0;          ///< while something moves
  int frames_ = 0;                 ///< drawn at that level since it was chosen or movement began
  double interval_s_ = 0.0;        ///< between them, smoothed
  double rested_s_ = 1e9;          ///< since something moved
  double easy_s_ = 0.0;            ///< for how long a finer level would have gone
  double since_rise_s_ = 1e9;
  double patience_s_ = kPatience_s;
  double left_s_ = 0.0;            ///< what a frame took at the finer level that was left last; 0 = that is learnt already
  std::array<double, 4> dearer_{1.0, 1.0, 1.0, 1.0};  ///< how much longer a frame takes at the level above

  static constexpr double kPatience_s = 1.0;
};

}  // namespace npsee::editor
