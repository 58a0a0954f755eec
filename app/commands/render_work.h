#pragma once

#include "app/commands/render_output.h"
#include "app/commands/render_pipeline.h"
#include "app/render/png_encoder.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace npsee::commands {

/// What is known of a file of a run.
enum class FileState { planned, skipped, written, missing };

/// One file to make.
struct WorkItem {
  std::size_t preset = 0;
  std::int64_t number = 0;  ///< frame number, or which of the moments; see RenderPlan::numberOf
  std::filesystem::path path;
  std::filesystem::path index;  ///< of a sheet; empty = none
  std::string recipe;       ///< fingerprint of preset, options and version: all that its pixels depend on but the program's build
  FileState state = FileState::planned;
};

/// The files of this call (of its shard), in order of presets and numbers.
std::vector<WorkItem> workOf(const RenderPlan& plan, const std::vector<Preset>& presets, const OutputNames& names);

/// Values of 0..1 as the numbers of a 16-bit picture.
std::vector<std::uint16_t> sixteenBits(std::span<const float> values);

/// What a picture says about itself: its recipe, and the build that drew it.
std::string recipeText(const WorkItem& item);
/// What a video says about itself.
std::string recipeComment(const WorkItem& item);

/// Whether the file is there, whole, and made by this recipe: by this build, or by any of this version.
bool isFinished(const WorkItem& item, bool any_build);

/// Marks the finished files as skipped.
void skipFinished(std::vector<WorkItem>& items, bool any_build, int threads);

/// A picture as 8-bit PNG with its recipe inside; the same bytes by the encoder of a sequence as without one.
Expected<std::vector<std::uint8_t>> encoded(const render::Image& image, const WorkItem& item);
/// A picture in the plan's format.
Expected<std::vector<std::uint8_t>> encoded(const RenderPlan& plan, const Picture& picture, const WorkItem& item, render::PngEncoder& encoder);

}  // namespace npsee::commands
