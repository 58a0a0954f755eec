#pragma once

#include "app/commands/render_output.h"
#include "app/commands/render_plan.h"
#include "app/render/mission_render.h"

#include <npsee/recording.h>

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace npsee::commands {

/// `--render`, `-o`, `--frames`, `--fps` and `--quality` of `npsee mission` and `npsee replay`, as typed.
struct MissionPictureOptions {
  std::vector<std::string> renders;
  std::string output, frames, fps, quality;
};
/// Without `-o`, which the command adds itself if it has other uses for it.
void addMissionPictureOptions(CLI::App& command, MissionPictureOptions& options);

/// The options understood, before anything is simulated or read.
struct MissionPicturePlan {
  std::vector<render::MissionRender> renders;
  std::optional<RenderPlan> sequence;    ///< `--frames`: rate and frames, of the only render
  std::optional<OutputNames> names;      ///< by `-o`; numbered where several pictures have no name of their own
};
/// Error kind usage or output.
Expected<MissionPicturePlan> planMissionPictures(const MissionPictureOptions& options);

/// Draws and writes the pictures without a display; `written` gets their names, also of those before an error.
Expected<void> writeMissionPictures(const MissionPicturePlan& plan, const Recording& recording, std::vector<std::filesystem::path>& written);

}  // namespace npsee::commands
