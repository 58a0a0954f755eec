#include "app/render/preset_shelf.h"

#include "app/render/shipped_assets.h"
#include "sim/core/text.h"

#include <algorithm>

namespace npsee::render {
namespace {

constexpr std::string_view kFallback = "classic_1993";

std::shared_ptr<const Preset> shipped(std::string_view name) {
  for (const ShippedAsset& asset : shippedPresets())
    if (asset.name == name)
      if (auto preset = parsePreset(asset.text, asset.name)) return std::make_shared<const Preset>(std::move(*preset));
  return nullptr;
}

}  // namespace

Expected<std::shared_ptr<const Preset>> PresetShelf::lookUp(const std::string& name, const std::filesystem::path& folder) {
  if (auto preset = shipped(name)) return preset;
  std::error_code ignored;
  if (const std::filesystem::path file = folder / name; std::filesystem::is_regular_file(file, ignored)) {
    auto preset = loadPreset(file);
    if (!preset) return tl::unexpected<Error>(preset.error());
    return std::make_shared<const Preset>(std::move(*preset));
  }
  const auto names = namesOf(shippedPresets(), &ShippedAsset::name);
  const auto meant = nearest(name, names);
  return fail(ErrorKind::usage, "there is no explosion preset \"" + name + "\"." + (meant ? " Did you mean " + std::string(*meant) + "?" : ""),
              "Shipped ones go by their file's name without .npsee.json, others by the path of their file.");
}

std::shared_ptr<const Preset> PresetShelf::find(const std::string& name, const std::filesystem::path& folder) {
  const std::string key = folder.string() + '\n' + name;
  if (const auto known = read_.find(key); known != read_.end()) return known->second;
  auto found = lookUp(name.empty() ? std::string(kFallback) : name, folder);
  if (!found) warnings_.push_back((found.error().kind == ErrorKind::usage ? found.error().faults.front().what : found.error().text()) + " Its bursts are drawn as " + std::string(kFallback) + ".");
  std::shared_ptr<const Preset> out = found ? std::move(*found) : shipped(kFallback);
  if (out == nullptr) out = std::make_shared<const Preset>();
  read_[key] = out;
  return out;
}

double longestDuration(const Preset& preset) {
  // Lives are drawn from a normal distribution: beyond five deviations there is nothing.
  const auto own = [](const Layer& layer) { return layer.start_s + layer.duration_s + layer.lifetime_mean_s + 5.0 * layer.lifetime_deviation_s; };
  double most = 0.0;
  for (const Layer& layer : preset.layers) {
    double end = own(layer);
    int parent = layer.parent.empty() ? -1 : findLayer(preset, layer.parent);
    for (std::size_t depth = 0; parent >= 0 && depth < preset.layers.size(); ++depth) {
      const Layer& above = preset.layers[static_cast<std::size_t>(parent)];
      end += own(above);
      parent = above.parent.empty() ? -1 : findLayer(preset, above.parent);
    }
    most = std::max(most, end);
  }
  return most;
}

}  // namespace npsee::render
