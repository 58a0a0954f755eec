#include <npsee/parameters.h>

#include "sim/core/text.h"

namespace npsee {
namespace {

/// All keys `--set` knows for this preset.
std::vector<std::string> settableKeys(const Preset& preset) {
  std::vector<std::string> keys;
  for (const Parameter& row : parameters(Scope::burst)) keys.emplace_back(row.key);
  for (const Layer& layer : preset.layers)
    for (const Parameter& row : parameters(Scope::layer)) keys.push_back(layer.name + '.' + std::string(row.key));
  return keys;
}

tl::unexpected<Error> refuse(std::string_view expression, std::string why, std::string remedy = {}) {
  return fail(ErrorKind::usage, "--set " + std::string(expression) + ": " + std::move(why), std::move(remedy));
}

tl::unexpected<Error> noSuchParameter(const Preset& preset, std::string_view expression, std::string_view key) {
  const std::vector<std::string> keys = settableKeys(preset);
  const std::vector<std::string_view> views(keys.begin(), keys.end());
  std::string what = "no such parameter.";
  if (const auto near = nearest(key, views)) what += " Did you mean " + std::string(*near) + "?";
  const auto names = namesOf(preset.layers, &Layer::name);
  return refuse(expression, std::move(what), "Layers are " + listed(names) + "; `npsee params` lists all parameters.");
}

/// Splits at the layer whose name the key begins with; the longest such name wins ("fire" against "fire ball").
int layerOfKey(const Preset& preset, std::string_view key, std::string_view& rest) {
  int best = -1;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < preset.layers.size(); ++i) {
    const std::string& name = preset.layers[i].name;
    if (key.size() > name.size() && key.starts_with(name) && key[name.size()] == '.' && (best < 0 || name.size() > longest)) {
      best = static_cast<int>(i);
      longest = name.size();
      rest = key.substr(name.size() + 1);
    }
  }
  return best;
}

}  // namespace

Expected<void> applySetting(Preset& preset, std::string_view expression) {
  const std::size_t equals = expression.find('=');
  if (equals == std::string_view::npos || equals == 0)
    return refuse(expression, "this is not KEY=VALUE.", "For example --set fragments.speed_mean=60 or --set burst=air.");
  const std::string_view key = trimmed(expression.substr(0, equals));
  const std::string_view text = expression.substr(equals + 1);

  Preset changed = preset;
  std::string_view layer_key;
  const int layer = layerOfKey(preset, key, layer_key);
  const Parameter* row = layer >= 0 ? findParameter(Scope::layer, layer_key) : findParameter(Scope::burst, key);
  if (row == nullptr) return noSuchParameter(preset, expression, key);

  const auto value = parseValue(*row, text);
  if (!value) return refuse(expression, value.error().faults.front().what, "`npsee params " + std::string(row->key) + "` says what it does.");
  if (layer >= 0) row->assign(changed.layers[static_cast<std::size_t>(layer)], *value);
  else row->assign(changed, *value);

  preset = std::move(changed);
  return {};
}

}  // namespace npsee
