#include "app/render/preset_shelf.h"

#include "app/render/shipped_assets.h"

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

std::shared_ptr<const Preset> PresetShelf::find(const std::string& name, const std::filesystem::path& folder) {
  const std::string key = folder.string() + '\n' + name;
  if (const auto found = read_.find(key); found != read_.end()) return found->second;
  std::shared_ptr<const Preset> out;
  std::error_code ignored;
  const std::filesystem::path file = folder / name;
  if (name.empty()) {
    out = shipped(kFallback);
  } else if (out = shipped(name); out == nullptr && std::filesystem::is_regular_file(file, ignored)) {
    if (auto preset = loadPreset(file)) out = std::make_shared<const Preset>(std::move(*preset));
    else warnings_.push_back(preset.error().text());
  } else if (out == nullptr) {
    warnings_.push_back("there is no explosion preset \"" + name + "\"; its bursts are drawn as " + std::string(kFallback) + ".");
  }
  if (out == nullptr) out = shipped(kFallback);
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
