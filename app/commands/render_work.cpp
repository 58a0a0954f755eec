#include "app/commands/render_work.h"

#include "app/commands/build_id.h"
#include "app/commands/sprite_index.h"
#include "app/render/deep_image.h"
#include "app/render/exr.h"
#include "app/render/png_text.h"
#include "sim/core/files.h"
#include "sim/core/parallel.h"
#include "sim/core/sha256.h"

#include <npsee/fragments.h>
#include <npsee/units.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <system_error>

namespace npsee::commands {
namespace {

constexpr std::size_t kMaxFinishedFile = 400u << 20;

std::string timeText(const Moment& moment) { return moment.share ? shortest(100.0 * moment.value) + "%" : shortest(moment.value) + "s"; }

std::string kindText(const RenderPlan& plan) {
  constexpr std::string_view kViews[] = {"splines", "polygons", "surface"};
  if (plan.kind == RenderKind::template_view) return "template " + std::string(kViews[static_cast<std::size_t>(plan.view)]);
  std::string out = "picture";
  if (plan.kind == RenderKind::video) out = endingOf(plan.format) + ' ' + std::to_string(plan.rate.numerator) + '/' + std::to_string(plan.rate.denominator);
  if (plan.kind == RenderKind::sheet) out = "sheet " + std::to_string(plan.columns) + 'x' + std::to_string(plan.rows) + ' ' + plan.caption;
  if (plan.kind != RenderKind::sequence && plan.range_s) out += " from " + shortest(plan.range_s->first) + "s to " + shortest(plan.range_s->second) + 's';
  return out;
}

std::string backgroundText(const render::Background& background) {
  using Kind = render::Background::Kind;
  if (background.kind == Kind::sky) return "sky";
  if (background.kind == Kind::transparent) return "transparent";
  const Colour& c = background.colour;
  return shortest(c.r) + ',' + shortest(c.g) + ',' + shortest(c.b);
}

/// What is written beside or instead of 8 bits.
std::string floatsText(const RenderPlan& plan) {
  if (!plan.floats) return {};
  const render::FloatRequest& f = *plan.floats;
  if (!f.linear) return "bits 16\n";
  return std::string("passes") + (f.colour ? " colour" : "") + (f.depth ? " depth" : "") + (f.motion ? " motion over " + shortest(f.frame_s) + 's' : std::string()) + '\n';
}

/// Nothing where it is the usual one: what is finished stays so.
std::string qualityText(const RenderPlan& plan) {
  return plan.quality == render::Quality::normal ? std::string() : "quality " + std::string(render::kQualityNames[static_cast<std::size_t>(plan.quality)]) + '\n';
}

std::string exposureText(const RenderPlan& plan) { return plan.exposure_stops == 0.0 ? std::string() : "exposure " + shortest(plan.exposure_stops) + '\n'; }

/// All but the preset and the time.
std::string planText(const RenderPlan& plan) {
  return std::string("npsee " NPSEE_VERSION "\n") + kindText(plan) + "\nsize " + std::to_string(plan.width) + 'x' + std::to_string(plan.height) + "\ncamera " + plan.camera + "\nbackground " + backgroundText(plan.background) + '\n' + qualityText(plan) + exposureText(plan) + floatsText(plan);
}

render::DeepImage deepImage(const render::FloatImage& floats) {
  render::DeepImage out{floats.width, floats.height, 16, false, sixteenBits(floats.rgba)};
  for (std::size_t i = 3; i < out.rgba.size() && !out.alpha; i += 4) out.alpha = out.rgba[i] != 65535;
  return out;
}

Expected<std::vector<std::uint8_t>> withRecipe(Expected<std::vector<std::uint8_t>> png, const WorkItem& item) {
  if (png) render::insertPngText(*png, render::kRecipeKeyword, recipeText(item));
  return png;
}

std::string timeOf(const RenderPlan& plan, std::int64_t number) {
  if (plan.kind == RenderKind::sequence) return timeText({plan.rate.timeOf(number), false});
  return plan.kind == RenderKind::picture ? timeText(plan.moments.at(static_cast<std::size_t>(number))) : std::string();
}

}  // namespace

std::vector<WorkItem> workOf(const RenderPlan& plan, const std::vector<Preset>& presets, const OutputNames& names) {
  std::vector<WorkItem> out;
  const std::string options = planText(plan);
  std::int64_t file = 0;
  for (std::size_t p = 0; p < presets.size(); ++p) {
    std::string content = sha256(presetText(presets[p]) + modelTexts(presets[p]));
    if (plan.kind == RenderKind::template_view) content += " layer " + std::to_string(*templateLayer(plan, presets[p]));
    for (std::int64_t i = 0; i < plan.filesPerPreset(); ++i, ++file) {
      if (!plan.shard.takes(file)) continue;
      const std::int64_t number = plan.numberOf(i);
      out.push_back({p, number, names.path(p, number), {}, sha256(options + content + '\n' + timeOf(plan, number)), FileState::planned});
      if (plan.index) out.back().index = indexPath(out.back().path);
    }
  }
  return out;
}

std::vector<std::uint16_t> sixteenBits(std::span<const float> values) {
  std::vector<std::uint16_t> out;
  out.reserve(values.size());
  // Written so that what is no number becomes 0.
  for (const float value : values) out.push_back(value > 0.0f ? static_cast<std::uint16_t>(std::lround(65535.0f * std::min(value, 1.0f))) : std::uint16_t{0});
  return out;
}

std::string recipeText(const WorkItem& item) { return item.recipe + " build " + buildId(); }

std::string recipeComment(const WorkItem& item) { return std::string(render::kRecipeKeyword) + ' ' + recipeText(item); }

bool isFinished(const WorkItem& item, bool any_build) {
  // The whole text names the build; up to the first space it is the recipe.
  const auto same = [&](std::string_view found) { return found == recipeText(item) || (any_build && found.substr(0, found.find(' ')) == item.recipe); };
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(item.path, ignored)) return false;
  if (!item.index.empty() && !std::filesystem::is_regular_file(item.index, ignored)) return false;
  if (std::optional<std::string> comment = render::videoComment(item.path)) {
    const std::string before = std::string(render::kRecipeKeyword) + ' ';
    return comment->starts_with(before) && same(std::string_view(*comment).substr(before.size()));
  }
  if (item.path.extension() == ".exr") return same(render::recipeOfWholeExr(item.path).value_or(std::string()));
  const auto bytes = readTextFile(item.path, kMaxFinishedFile);
  return bytes && same(render::textOfWholePng(*bytes, render::kRecipeKeyword).value_or(std::string()));
}

void skipFinished(std::vector<WorkItem>& items, bool any_build, int threads) {
  parallelFor(threads, items.size(), [&](std::size_t i) {
    if (isFinished(items[i], any_build)) items[i].state = FileState::skipped;
  });
}

Expected<std::vector<std::uint8_t>> encoded(const render::Image& image, const WorkItem& item) {
  render::PngEncoder alone(render::PngEncoder::Keep::nothing);
  return withRecipe(alone.encode(image), item);
}

Expected<std::vector<std::uint8_t>> encoded(const RenderPlan& plan, const Picture& picture, const WorkItem& item, render::PngEncoder& encoder) {
  if (!plan.floats) return withRecipe(encoder.encode(picture.image), item);
  if (plan.format == FileFormat::exr) return render::encodeExr(picture.floats, recipeText(item));
  return withRecipe(render::encodeDeepPng(deepImage(picture.floats)), item);
}

}  // namespace npsee::commands
