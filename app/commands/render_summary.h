#pragma once

#include "app/commands/golden.h"

#include <string>
#include <vector>

namespace npsee::commands {

/// What a run did, for `--summary json`.
struct RenderSummary {
  const RenderPlan* plan = nullptr;
  const std::vector<std::string>* presets = nullptr;  ///< their files
  const std::vector<WorkItem>* items = nullptr;
  const GoldenCheck* golden = nullptr;  ///< may be null
  std::string driver, processor;        ///< empty: nothing was drawn
  double seconds = 0.0;
};
std::string summaryJson(const RenderSummary& summary);

/// The paths of the files in one of the states, one per line. A device or pipe is no file: its name would end up in what it carries.
std::string pathsText(const std::vector<WorkItem>& items, FileState state);

}  // namespace npsee::commands
