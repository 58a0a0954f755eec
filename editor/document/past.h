#pragma once

#include <npsee/explosion.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace npsee::editor {

/// Where the particles were at some moments before the one shown, at equal distances. Kept until what is asked for is something else.
class Past {
 public:
  /// Above so many particles nothing is looked up: the pictures would be a tangle, and slow.
  static constexpr std::size_t kMostParticles = 30'000;

  /// The last of the `count` moments lies `span_s` back; moments before the burst are left out.
  const std::vector<Frame>& at(const std::shared_ptr<const Explosion>& explosion, double time_s, double span_s, std::size_t count);

 private:
  std::shared_ptr<const Explosion> of_;
  double time_s_ = 0.0, span_s_ = 0.0;
  std::size_t count_ = 0;
  std::vector<Frame> frames_;  ///< youngest first
};

/// A 1, 2 or 5 times a power of ten near `share` of a duration: lengths of trails and arrows that people can say.
double roundTime(double duration_s, double share);

}  // namespace npsee::editor
