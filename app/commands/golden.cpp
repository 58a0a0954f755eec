#include "app/commands/golden.h"

#include "sim/core/files.h"
#include "sim/core/json_text.h"

#include <nlohmann/json.hpp>

#include <system_error>

namespace npsee::commands {
namespace {

namespace fs = std::filesystem;

/// Bytes of pictures kept for a report; what differs after that is listed with its figures only.
constexpr std::size_t kKeptBytes = 192u << 20;

fs::path recordPath(fs::path golden) { return golden.replace_extension(".json"); }

/// An unreadable or missing record means a machine we do not know.
GoldenRecord readRecord(const fs::path& golden) {
  const fs::path path = recordPath(golden);
  const auto text = readTextFile(path, 1u << 16);
  if (!text) return {};
  const auto json = JsonText::parse(*text, path.string());
  if (!json || !json->root().is_object()) return {};
  const auto field = [&](const char* key) {
    const auto at = json->root().find(key);
    return at != json->root().end() && at->is_string() ? at->get<std::string>() : std::string();
  };
  return {field("driver"), field("processor")};
}

std::string recordText(const GoldenRecord& record) {
  return nlohmann::ordered_json{{"npsee", NPSEE_VERSION}, {"driver", record.driver}, {"processor", record.processor}}.dump(2) + '\n';
}

}  // namespace

render::Tolerance toleranceElsewhere() {
  render::Tolerance tolerance;
  tolerance.pixels = {0.0001, 2.0};
  return tolerance;
}

GoldenCheck::GoldenCheck(Settings settings, const std::vector<WorkItem>& items) : settings_(std::move(settings)), items_(items), results_(items.size()) {
  for (std::size_t i = 0; i < items.size(); ++i) results_[i].pair = {{items[i].path.lexically_relative(settings_.folder).string(), items[i].path, {}}, Verdict::missing, {}, {"it was not drawn"}, {}};
}

GoldenResult GoldenCheck::compared(const WorkItem& item, const render::Image& image) const {
  GoldenResult out;
  const PicturePair names = results_[static_cast<std::size_t>(&item - items_.data())].pair.pair;
  std::error_code ignored;
  if (!fs::exists(item.path, ignored)) {
    out.pair = {names, Verdict::missing, {}, {"there is no golden of this name"}, {}};
    return out;
  }
  const auto golden = render::readDeepPng(item.path);
  if (!golden) {
    out.pair = {names, Verdict::unreadable, {}, {"the golden cannot be read"}, golden.error()};
    return out;
  }
  out.same_machine = readRecord(item.path) == settings_.machine;
  const bool by_machine = settings_.tolerance.exact() && !out.same_machine;
  out.pair = judged(names, *golden, render::deepened(image), by_machine ? toleranceElsewhere() : settings_.tolerance);
  return out;
}

Expected<void> GoldenCheck::update(const WorkItem& item, const render::Image& image) const {
  const auto bytes = encoded(image, item);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  if (auto written = writeFileAtomically(item.path, std::as_bytes(std::span(*bytes))); !written) return written;
  return writeFileAtomically(recordPath(item.path), recordText(settings_.machine));
}

void GoldenCheck::keepPictures(GoldenResult& result, const WorkItem& item, const render::Image& image) {
  if (result.pair.verdict == Verdict::same || kept_bytes_ >= kKeptBytes) return;
  if (auto bytes = encoded(image, item)) result.after = std::move(*bytes);
  const auto golden = render::readDeepPng(item.path);
  if (golden && golden->width == image.width && golden->height == image.height)
    if (auto bytes = render::encodePng(render::differencePicture(*golden, render::deepened(image)))) result.difference = std::move(*bytes);
  // Only what has just been read as a picture goes into the page.
  if (golden)
    if (const auto bytes = readTextFile(item.path, kKeptBytes)) result.before.assign(bytes->begin(), bytes->end());
  kept_bytes_ += result.before.size() + result.after.size() + result.difference.size();
}

Expected<void> GoldenCheck::judge(std::size_t index, const render::Image& image) {
  const WorkItem& item = items_[index];
  GoldenResult result = compared(item, image);
  if (settings_.keep_pictures) keepPictures(result, item, image);
  if (settings_.update && !passes(result.pair.verdict)) {
    if (auto written = update(item, image); !written) return written;
    result.updated = true;
  }
  results_[index] = std::move(result);
  return {};
}

GoldenCounts countsOf(const std::vector<GoldenResult>& results) {
  GoldenCounts out;
  for (const GoldenResult& result : results) {
    if (result.pair.verdict == Verdict::same) ++out.same;
    else if (result.pair.verdict == Verdict::within) ++out.within;
    else ++out.failed;
    if (result.updated) ++out.updated;
  }
  return out;
}

std::string goldenText(const GoldenCheck& check) {
  std::string out;
  for (const GoldenResult& result : check.results()) {
    if (passes(result.pair.verdict)) continue;
    out += pairText(result.pair);
    if (result.updated) out += "  golden updated: " + printable(result.pair.pair.before.string()) + '\n';
  }
  const GoldenCounts counts = countsOf(check.results());
  out += std::to_string(check.results().size()) + (check.results().size() == 1 ? " picture: " : " pictures: ") + std::to_string(counts.same) + " same, " + std::to_string(counts.within) + " within the tolerance, " + std::to_string(counts.failed) + " different or missing\n";
  if (counts.updated > 0) out += std::to_string(counts.updated) + " goldens were updated, so this run counts as failed: look at them, commit them, and run again.\n";
  return out;
}

}  // namespace npsee::commands
