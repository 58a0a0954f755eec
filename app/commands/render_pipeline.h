#pragma once

#include "app/commands/render_plan.h"
#include "app/render/png_encoder.h"

#include <functional>
#include <optional>

namespace npsee::commands {

/// A drawn picture: in 8 bits, or in single precision where that is asked for.
struct Picture {
  render::Image image;
  render::FloatImage floats;
};

/// What a run of pictures of one explosion needs.
struct PictureJob {
  const Explosion* explosion = nullptr;
  render::Scene scene;  ///< all but the frame
  render::Camera camera;
  int width = 0, height = 0;
  int threads = 1;
  std::optional<render::FloatRequest> floats;
  std::function<bool()> stopped;  ///< asked before each picture; may be empty
};

/// The error of a run that was asked to stop.
tl::unexpected<Error> stoppedEarly();

/// Simulates ahead on a thread of its own and draws on this one, in order; `take` gets each picture and may keep it (one
/// left in place is used again). Stops at the first error.
Expected<void> drawPictures(render::Renderer& renderer, const PictureJob& job, const std::vector<Shot>& shots,
                            const std::function<Expected<void>(const Shot&, Picture&)>& take);

/// Does something with picture `index` of the shots, such as encoding and writing it. Each thread that saves has an encoder.
using SavePicture = std::function<Expected<void>(std::size_t index, const Picture& picture, render::PngEncoder& encoder)>;

/// Draws the shots and saves each; saving runs on `job.threads` threads behind a bounded queue, so that memory does not grow
/// with the number of pictures. `saved` gets 1 for each picture that was, also when an error ends the run. `progress` hears
/// how many are done.
Expected<void> savePictures(render::Renderer& renderer, const PictureJob& job, const std::vector<Shot>& shots, const SavePicture& save,
                            const std::function<void(std::size_t done)>& progress, std::vector<char>& saved);

}  // namespace npsee::commands
