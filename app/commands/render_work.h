#pragma once

#include "app/commands/render_output.h"
#include "app/commands/render_pipeline.h"
#include "app/render/png_encoder.h"

#include <filesystem>
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
  std::string recipe;       ///< fingerprint of all that its pixels depend on
  FileState state = FileState::planned;
};

/// The files of this call (of its shard), in order of presets and numbers.
std::vector<WorkItem> workOf(const RenderPlan& plan, const std::vector<Preset>& presets, const OutputNames& names);

/// What a video says about itself.
std::string recipeComment(const WorkItem& item);

/// Whether the file is there, whole, and made by this recipe.
bool isFinished(const WorkItem& item);

/// Marks the finished files as skipped.
void skipFinished(std::vector<WorkItem>& items, int threads);

/// A picture as 8-bit PNG with its recipe inside; the same bytes by the encoder of a sequence as without one.
Expected<std::vector<std::uint8_t>> encoded(const render::Image& image, const WorkItem& item);
/// A picture in the plan's format.
Expected<std::vector<std::uint8_t>> encoded(const RenderPlan& plan, const Picture& picture, const WorkItem& item, render::PngEncoder& encoder);

}  // namespace npsee::commands
