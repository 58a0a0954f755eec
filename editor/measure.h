#pragma once

#include <string>
#include <utility>
#include <vector>

namespace npsee::editor {

/// What pictures of the explosion, the template and a mission cost; only measured where somebody asks, as the driver has to finish each.
struct PictureTimes {
  double explosion_ms = 0.0, template_ms = 0.0, mission_ms = 0.0;
  int drawn = 0;  ///< pictures that were not there already
};

/// One frame of the editor.
struct FrameTimes {
  double whole_ms = 0.0;
  double cpu_ms = 0.0;     ///< of the processor, in all threads: other programs' load does not show in it
  double panels_ms = 0.0;  ///< panels, and the simulation of the moment shown
  double window_ms = 0.0;  ///< drawing the panels' output
  PictureTimes pictures;
  bool drawn = false;      ///< anything was
  std::string quality;     ///< at which the explosion was drawn
};

/// Collects frames and tells what they took.
class FrameMeter {
 public:
  void add(const FrameTimes& frame) { frames_.push_back(frame); }
  /// By name: frames, fps, median_ms, slow_ms (which one frame in twenty exceeds), the means of the parts, the pictures drawn and the frames in which nothing was.
  std::vector<std::pair<std::string, std::string>> figures() const;

 private:
  std::vector<FrameTimes> frames_;
};

}  // namespace npsee::editor
