#pragma once

#include "app/commands/tolerance_options.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace npsee::commands {

/// `npsee render`'s options as they were typed; empty = not given.
struct RenderOptions {
  std::vector<std::string> files;
  std::vector<std::string> settings;
  std::string seed, output, time, frames, fps, size, camera, background, sheet, view, layer, threads, format, caption, bits, passes, quality;
  bool as_template = false, index = false;
  // a pipeline's habits
  std::string shard, summary, progress;
  bool resume = false, dry_run = false, verify = false;
  // goldens
  std::string golden, report, junit;
  bool update_golden = false;
  ToleranceOptions tolerance;
};

void addRenderOptions(CLI::App& command, RenderOptions& options);

}  // namespace npsee::commands
