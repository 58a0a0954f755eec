#pragma once

#include "editor/document/shelf.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace npsee::editor {

/// Another preset, A, beside the edited one, B: at the same time, from the same camera.
struct Compare {
  enum class Mode { off, split, flip };
  Mode mode = Mode::off;
  std::shared_ptr<const Preset> preset;  ///< A
  std::string name;                      ///< what A is, for people
  std::shared_ptr<const Preset> taken;   ///< what was A until the last swap made it B, and what it was called
  std::string taken_name;
  double split = 0.5;                    ///< share of the picture's width that shows A
  bool flipped = false;                  ///< Mode::flip shows A

  Shelf shelf;
  Frame frame;  ///< A at the moment shown
  double time_s = 0.0;  ///< that moment
  const std::shared_ptr<const Explosion>& explosion() const { return shelf.at(0); }
  bool on() const { return mode != Mode::off && preset != nullptr; }

  /// Lets time pass: compiles A where that is new and evaluates it at `time_s`.
  void update(double at_s, bool wait);

 private:
  std::shared_ptr<const Explosion> evaluated_;  ///< that the frame is of
};

/// Nine neighbours: the edited preset in the middle, variations of it around.
struct Variations {
  static constexpr std::size_t kCount = 9, kMiddle = 4;
  /// Above so many particles nine at once would be too much.
  static constexpr std::size_t kMostParticles = 40'000;
  bool open = false;
  std::array<std::shared_ptr<const Preset>, kCount> presets;
  Shelf shelf;
  std::array<Frame, kCount> frames;
  double time_s = 0.0;  ///< the moment that they show

  void update(double at_s, bool wait);

 private:
  std::array<std::shared_ptr<const Explosion>, kCount> evaluated_;
};

}  // namespace npsee::editor
