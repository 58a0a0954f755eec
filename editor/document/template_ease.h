#pragma once

#include <npsee/preset.h>

#include <memory>

namespace npsee::editor {

/// The preset that the template shows: the edited one's selected layer, whose numbers glide to their values when these jump, so that the eye
/// follows what a click, an undo or another preset changed. Knows no clock: whoever shows it says how much time has passed.
class TemplateEase {
 public:
  /// Lets `elapsed_s` pass; `at_once` takes the values as they are (scripts, and while a handle is held). Costs nothing at rest.
  void update(const std::shared_ptr<const Preset>& preset, int layer, double elapsed_s, bool at_once);
  bool moving() const { return moving_; }
  /// One layer, at index 0; none where the edited preset has none.
  const Preset& shown() const { return shown_; }

 private:
  std::shared_ptr<const Preset> of_;
  int layer_ = -1;
  bool moving_ = false;
  Preset shown_;
};

}  // namespace npsee::editor
