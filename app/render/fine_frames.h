#pragma once

#include "app/render/view.h"

#include <npsee/explosion.h>

#include <array>
#include <span>

namespace npsee::render {

/// The sixteen looks that make a fine picture: the accumulation buffer of P. Haeberli and K. Akeley (SIGGRAPH 1990).
///
/// Look i is moved aside to the middle of field i of 4 x 4 in a pixel, and shows pieces at a time of its own in the shutter's, each
/// sixteenth of it once, so that neighbouring fields are not neighbours in time. Pieces go on straight at their velocity; streaks are drawn
/// as long as their way already, and clouds change too slowly to show it.
class FineFrames {
 public:
  static constexpr int kLooks = 16;

  /// Time of a look from the picture's, s.
  static double timeOf(int look);
  /// How far a look of a picture of that size is moved to the right and up, as a share of half the picture.
  static std::array<double, 2> asideOf(int look, int width, int height);
  /// The view of a look of a picture of that size.
  static View viewOf(const View& view, int look, int width, int height);
  /// The frame of a look, valid until the next call. Call with look 0 first for each picture.
  const Frame& frameOf(const Frame& frame, std::span<const LayerSpan> layers, int look);

 private:
  Frame moved_;
};

}  // namespace npsee::render
