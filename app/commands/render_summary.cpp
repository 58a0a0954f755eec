#include "app/commands/render_summary.h"

#include "app/commands/build_id.h"

#include "sim/core/files.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace npsee::commands {
namespace {

std::string_view stateName(FileState state) {
  switch (state) {
    case FileState::planned: return "planned";
    case FileState::skipped: return "skipped";
    case FileState::written: return "written";
    case FileState::missing: break;
  }
  return "missing";
}

nlohmann::ordered_json itemJson(const RenderSummary& summary, const WorkItem& item) {
  nlohmann::ordered_json out{{"file", item.path.string()}, {"state", stateName(item.state)}, {"preset", summary.presets->at(item.preset)}};
  if (summary.plan->numbered()) out["number"] = item.number;
  if (summary.plan->kind == RenderKind::sequence) out["time_s"] = summary.plan->rate.timeOf(item.number);
  out["recipe"] = item.recipe;
  return out;
}

nlohmann::ordered_json goldenJson(const GoldenCheck& check) {
  const GoldenCounts counts = countsOf(check.results());
  nlohmann::ordered_json out{{"folder", check.settings().folder.string()}, {"same", counts.same}, {"within", counts.within}, {"failed", counts.failed}, {"updated", counts.updated}};
  out["results"] = nlohmann::ordered_json::array();
  for (const GoldenResult& result : check.results()) {
    nlohmann::ordered_json one = pairJson(result.pair);
    one["updated"] = result.updated;
    one["same_machine"] = result.same_machine;
    out["results"].push_back(std::move(one));
  }
  return out;
}

}  // namespace

std::string summaryJson(const RenderSummary& summary) {
  const auto count = [&](FileState state) { return std::ranges::count(*summary.items, state, &WorkItem::state); };
  const RenderPlan& plan = *summary.plan;
  nlohmann::ordered_json out{{"npsee", NPSEE_VERSION}, {"build", buildId()}, {"driver", summary.driver}, {"processor", summary.processor}, {"width", plan.width}, {"height", plan.height}, {"quality", render::kQualityNames[static_cast<std::size_t>(plan.quality)]}, {"exposure", plan.exposure_stops}, {"shard", {plan.shard.index, plan.shard.count}}, {"seconds", summary.seconds}};
  out["written"] = count(FileState::written);
  out["skipped"] = count(FileState::skipped);
  out["planned"] = count(FileState::planned);
  out["missing"] = count(FileState::missing);
  out["files"] = nlohmann::ordered_json::array();
  for (const WorkItem& item : *summary.items) out["files"].push_back(itemJson(summary, item));
  if (summary.golden != nullptr) out["golden"] = goldenJson(*summary.golden);
  return out.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

std::string pathsText(const std::vector<WorkItem>& items, FileState state) {
  std::string out;
  for (const WorkItem& item : items)
    if (item.state == state && !isSpecialFile(item.path)) out += item.path.string() + '\n';
  return out;
}

}  // namespace npsee::commands
