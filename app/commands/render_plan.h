#pragma once

#include "app/render/renderer.h"

#include <npsee/error.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace npsee::commands {

/// `npsee render`'s options as they were typed; empty = not given.
struct RenderOptions {
  std::vector<std::string> files;
  std::vector<std::string> settings;
  std::string seed, output, time, frames, fps, size, camera, background, sheet, view, layer, threads;
  bool as_template = false;
};

enum class RenderKind { picture, sequence, sheet, template_view };

/// Frames per second as a fraction, so that the time of frame k is one rounded division of integers.
struct FrameRate {
  std::int64_t numerator = 30, denominator = 1;
  double timeOf(std::int64_t frame) const { return static_cast<double>(frame * denominator) / static_cast<double>(numerator); }
};

/// The options understood. Nothing has been read or written yet.
struct RenderPlan {
  RenderKind kind = RenderKind::picture;
  int width = 1280, height = 720;  ///< of each picture, pixels
  int columns = 1, rows = 1;       ///< of a sheet
  int threads = 1;
  render::Background background;
  std::string camera = "auto";
  std::optional<double> time_s;
  std::optional<std::pair<double, double>> range_s;  ///< `--frames`, s
  FrameRate rate;
  std::int64_t first_frame = 0, frame_count = 0;  ///< of a sequence
  render::TemplateView view = render::TemplateView::surface;
  std::string layer;  ///< whose template; empty = the first that is enabled
};

/// Limits, named in the messages.
inline constexpr std::int64_t kMaxFrames = 100'000;
inline constexpr int kMaxSheetSide = 64;
inline constexpr std::int64_t kMaxPicturePixels = 33'554'432;
inline constexpr int kMaxThreads = 256;

/// Error kind usage for each option that cannot be meant.
Expected<RenderPlan> makePlan(const RenderOptions& options);

/// Index of the layer whose template the plan wants, 0 if it wants none. Error kind usage names the nearest layer, kind input a
/// preset without layers.
Expected<int> templateLayer(const RenderPlan& plan, const Preset& preset);

/// One picture to draw.
struct Shot {
  double time_s = 0.0;
  std::int64_t number = 0;  ///< frame number of a sequence, place in a sheet
};

/// The pictures the plan wants of an effect that lasts `duration_s`.
std::vector<Shot> shotsOf(const RenderPlan& plan, double duration_s);

}  // namespace npsee::commands
