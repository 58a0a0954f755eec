#pragma once

#include "app/commands/render_format.h"
#include "app/commands/render_options.h"
#include "app/render/renderer.h"

#include <npsee/error.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace npsee::commands {

enum class RenderKind { picture, sequence, sheet, template_view, video };

/// Frames per second as a fraction, so that the time of frame k is one rounded division of integers.
struct FrameRate {
  std::int64_t numerator = 30, denominator = 1;
  double timeOf(std::int64_t frame) const { return static_cast<double>(frame * denominator) / static_cast<double>(numerator); }
};

/// A time after the burst, s, or a share of the effect's duration.
struct Moment {
  double value = 0.25;
  bool share = true;
  double at(double duration_s) const { return share ? value * duration_s : value; }
};

/// Part `index` of `count`, counted from 1: every count-th file, so that parts take equally long.
struct Shard {
  std::int64_t index = 1, count = 1;
  bool takes(std::int64_t file) const { return file % count == index - 1; }
};

/// The options understood. Nothing has been read or written yet.
struct RenderPlan {
  RenderKind kind = RenderKind::picture;
  FileFormat format = FileFormat::png;
  std::optional<render::FloatRequest> floats;  ///< for 16-bit PNG and OpenEXR
  int width = 1280, height = 720;  ///< of each picture, pixels
  int columns = 1, rows = 1;       ///< of a sheet
  int threads = 1;
  render::Background background;
  std::string camera = "auto";
  render::Quality quality = render::Quality::normal;
  double exposure_stops = 0.0;
  std::vector<Moment> moments{Moment{}};  ///< of pictures; a quarter into an effect its pieces are usually spread and in flight
  std::optional<std::pair<double, double>> range_s;  ///< `--frames`, s
  FrameRate rate;
  std::int64_t first_frame = 0, frame_count = 0;  ///< of a sequence; of a video with a range
  std::string caption;  ///< of a sheet's pictures; empty = none
  bool index = false;   ///< of a sheet
  render::TemplateView view = render::TemplateView::surface;
  std::string layer;  ///< whose template; empty = the first that is enabled
  Shard shard;

  /// Whether the file names carry a number.
  bool numbered() const { return kind == RenderKind::sequence || (kind == RenderKind::picture && moments.size() > 1); }
  /// Files made of each preset.
  std::int64_t filesPerPreset() const { return kind == RenderKind::sequence ? frame_count : kind == RenderKind::picture ? static_cast<std::int64_t>(moments.size()) : 1; }
  /// Number of a preset's file: the frame number of a sequence.
  std::int64_t numberOf(std::int64_t file) const { return kind == RenderKind::sequence ? first_frame + file : file; }
};

/// Limits, named in the messages.
inline constexpr std::int64_t kMaxFrames = 100'000;
inline constexpr int kMaxSheetSide = 64;
inline constexpr std::int64_t kMaxPicturePixels = 33'554'432;
inline constexpr int kMaxThreads = 256;
inline constexpr std::size_t kMaxMoments = 1000;
inline constexpr std::int64_t kMaxShards = 100'000;

/// Error kind usage for each option that cannot be meant.
Expected<RenderPlan> makePlan(const RenderOptions& options);

/// `--quality`, normal if it is empty. Error kind usage.
Expected<render::Quality> readQuality(std::string_view text);

/// Index of the layer whose template the plan wants, 0 if it wants none. Error kind usage names the nearest layer, kind input a
/// preset without layers.
Expected<int> templateLayer(const RenderPlan& plan, const Preset& preset);

/// One picture to draw.
struct Shot {
  double time_s = 0.0;
  std::int64_t number = 0;  ///< frame number of a sequence, place in a sheet
};

/// The picture with a number, of an effect that lasts `duration_s`: not for sheets.
Shot shotOf(const RenderPlan& plan, std::int64_t number, double duration_s);
/// The pictures of a video. Error kind usage: too many.
Expected<std::vector<Shot>> videoShots(const RenderPlan& plan, double duration_s);
/// The pictures of a sheet.
std::vector<Shot> sheetShots(const RenderPlan& plan, double duration_s);

}  // namespace npsee::commands
