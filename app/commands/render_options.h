#pragma once

#include "app/commands/tolerance_options.h"

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace npsee::commands {

/// `npsee render`'s options as they were typed; empty = not given.
struct RenderOptions {
  std::vector<std::string> files;
  std::vector<std::string> settings;
  std::string seed, output, time, frames, fps, size, camera, background, sheet, view, layer, threads, format, caption, bits, passes, quality, exposure;
  bool as_template = false, index = false;
  // a pipeline's habits
  std::string shard, summary, progress;
  bool resume = false, any_build = false, dry_run = false, verify = false;
  // goldens
  std::string golden, report, junit;
  bool update_golden = false;
  ToleranceOptions tolerance;
};

/// Of `--quality`, for presets and missions.
inline constexpr const char* kQualityHelp =
    "draft (a third of the resolution, for a look: about four times faster where smoke is heavy), normal (default), or fine (16 pictures in one: smooth edges, what moves blurred by a shutter of 1/50 s)";

/// The words that an option chooses from, as its type: "{a,b}". Completion of bash reads them there.
template <class Names>
std::string choiceOf(const Names& names) {
  std::string out;
  for (const std::string_view name : names) out += (out.empty() ? "{" : ",") + std::string(name);
  return out + '}';
}

void addRenderOptions(CLI::App& command, RenderOptions& options);

}  // namespace npsee::commands
