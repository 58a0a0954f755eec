#pragma once

#include "app/commands/render_plan.h"

#include <filesystem>
#include <functional>

namespace npsee::commands {

/// What a run of pictures of one explosion needs.
struct PictureJob {
  const Explosion* explosion = nullptr;
  render::Scene scene;  ///< all but the frame
  render::Camera camera;
  int width = 0, height = 0;
  int threads = 1;
};

/// Simulates ahead on a thread of its own and draws on this one, in order; `take` gets each picture and may keep it (an
/// Image left in place is used again). Stops at the first error.
Expected<void> drawPictures(render::Renderer& renderer, const PictureJob& job, const std::vector<Shot>& shots,
                            const std::function<Expected<void>(const Shot&, render::Image&)>& take);

/// Draws, encodes and writes one PNG file per shot; encoding runs on `job.threads` threads behind a bounded queue, so that
/// memory does not grow with the number of pictures. Paths of whole files are added to `written` in order, also when an
/// error ends the run. `progress` hears how many are done.
Expected<void> writePictures(render::Renderer& renderer, const PictureJob& job, const std::vector<Shot>& shots,
                             const std::function<std::filesystem::path(const Shot&)>& path, const std::function<void(std::size_t done)>& progress,
                             std::vector<std::filesystem::path>& written);

}  // namespace npsee::commands
