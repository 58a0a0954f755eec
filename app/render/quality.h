#pragma once

#include <array>
#include <string_view>

namespace npsee::render {

/// How much work a picture is worth.
enum class Quality {
  draft,   ///< the effect at a third of the width and height, coarser noise, no spread light: for a look
  normal,  ///< pieces with four samples a pixel
  fine,    ///< sixteen pictures in one, each aside by part of a pixel and at its own time of the shutter's
};

/// Names as they are typed, in the order of the values.
inline constexpr std::array<std::string_view, 3> kQualityNames{"draft", "normal", "fine"};

/// Width and height of a picture to those of its draft's effect.
inline constexpr int kDraftScale = 3;

/// Time that the shutter is open, s; streaks are as long as their way in it (shaders/soft.vert), and fine pictures blur pieces by it.
inline constexpr double kShutter_s = 1.0 / 50.0;

}  // namespace npsee::render
