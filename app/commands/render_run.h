#pragma once

#include "app/commands/progress.h"
#include "app/commands/render_pipeline.h"
#include "app/commands/render_work.h"

#include <functional>

namespace npsee::commands {

/// Does something with the picture of an item, such as writing it. Called from several threads.
using SaveItem = std::function<Expected<void>(std::size_t item, const Picture& picture, render::PngEncoder& encoder)>;

/// A run that has something to draw.
struct RenderRun {
  const RenderPlan& plan;
  const std::vector<Preset>& presets;
  const std::vector<std::string>& files;  ///< of the presets
  std::vector<WorkItem>& items;  ///< those planned are drawn and become written
  render::Renderer& renderer;
  SaveItem save;
  ProgressMode progress = ProgressMode::terminal;
};

/// Draws all planned items, preset by preset. Stops at the first error, and when a signal asks for it.
Expected<void> drawItems(RenderRun& run);

}  // namespace npsee::commands
