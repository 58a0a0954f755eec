#include "sim/preset/validate.h"

#include "sim/core/text.h"

#include <npsee/fragments.h>
#include <npsee/parameters.h>

#include <algorithm>
#include <cmath>

namespace npsee {
namespace {

/// What the pieces of one model take at most: 600,000 triangles with their points.
constexpr double kPiecesMemory = 48.0 * 1024 * 1024;

std::string at(std::size_t layer, std::string_view key = {}) {
  std::string out = "/layers/" + std::to_string(layer);
  if (!key.empty()) {
    out += '/';
    for (const char c : key) out += c == '.' ? '/' : c;
  }
  return out;
}

bool fitName(const std::string& name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' || c == '-' || c == '_';
  };
  return !name.empty() && std::ranges::all_of(name, fits) && name.front() != ' ' && name.back() != ' ';
}

void checkNames(const Preset& preset, std::vector<PresetFault>& faults) {
  for (std::size_t i = 0; i < preset.layers.size(); ++i) {
    const std::string& name = preset.layers[i].name;
    if (!fitName(name)) faults.push_back({at(i, "name"), at(i), "the name \"" + name + "\" does not fit.", "Use letters, digits, inner spaces, - and _."});
    for (std::size_t j = 0; j < i; ++j)
      if (preset.layers[j].name == name) {
        faults.push_back({at(i, "name"), at(i), "the name \"" + name + "\" is taken by layer " + std::to_string(j) + ".", "Give each layer a name of its own, e.g. \"" + freeLayerName(preset, name) + "\"."});
        break;
      }
  }
}

/// True if following parents from `start` comes back to it.
bool inCycle(const Preset& preset, std::size_t start) {
  std::size_t at_layer = start;
  for (std::size_t hop = 0; hop < preset.layers.size(); ++hop) {
    const int parent = findLayer(preset, preset.layers[at_layer].parent);
    if (parent < 0) return false;
    at_layer = static_cast<std::size_t>(parent);
    if (at_layer == start) return true;
  }
  return false;
}

void checkParents(const Preset& preset, std::vector<PresetFault>& faults) {
  const auto names = namesOf(preset.layers, &Layer::name);
  for (std::size_t i = 0; i < preset.layers.size(); ++i) {
    const Layer& layer = preset.layers[i];
    if (layer.parent.empty()) {
      if (layer.trigger != Trigger::none)
        faults.push_back({at(i, "trigger"), at(i), "a layer without a parent has no events to be triggered by.", "Name a parent, or set trigger to none."});
      continue;
    }
    if (findLayer(preset, layer.parent) < 0) {
      const auto near = nearest(layer.parent, names);
      faults.push_back({at(i, "parent"), at(i), "there is no layer \"" + layer.parent + "\" to hang on.", near ? "Did you mean " + std::string(*near) + "?" : ""});
    } else if (inCycle(preset, i)) {
      faults.push_back({at(i, "parent"), at(i), "layer \"" + layer.name + "\" hangs on itself.", "Let one layer of the ring hang on the burst."});
    } else if (layer.trigger == Trigger::none) {
      faults.push_back({at(i, "trigger"), at(i, "parent"), "the layer hangs on \"" + layer.parent + "\", but nothing triggers it.", "Set trigger to birth, path, bounce or death."});
    }
  }
}

void checkDirections(const Preset& preset, std::vector<PresetFault>& faults) {
  for (std::size_t i = 0; i < preset.layers.size(); ++i)
    if (!(length(preset.layers[i].direction) > 1e-6))
      faults.push_back({at(i, "direction"), at(i), "the direction has no length.", "Straight up is [0, 1, 0]."});
}

void checkPieces(const Preset& preset, std::vector<PresetFault>& faults) {
  for (std::size_t i = 0; i < preset.layers.size(); ++i) {
    const Layer& layer = preset.layers[i];
    if (layer.form != Form::pieces) continue;
    if (std::string wrong = wrongModelName(layer.pieces_model); !wrong.empty()) faults.push_back({at(i, "pieces.model"), at(i, "form"), std::move(wrong), "Name a shipped model, such as tank, or an OBJ file beside the preset."});
    if (const std::int64_t count = particleCount(layer); count < 1 || count > kMaxPieces)
      faults.push_back({at(i, "count"), at(i, "form"), "the model would come apart into " + std::to_string(count) + " pieces, " + (count < 1 ? "which is none." : "above the limit of " + std::to_string(kMaxPieces) + "."), "Set count to 1 up to " + std::to_string(kMaxPieces) + "."});
  }
}

}  // namespace

namespace {

/// Particles of one layer at most: per event, times the events of all parent particles along the chain of parents. The chain's length
/// is bounded against cycles.
double mostParticles(const Preset& preset, const Layer& layer) {
  double count = static_cast<double>(particleCount(layer));
  const Layer* child = &layer;
  for (std::size_t hop = 0; hop < preset.layers.size() && !child->parent.empty(); ++hop) {
    const int index = findLayer(preset, child->parent);
    if (index < 0) break;
    const Layer& parent = preset.layers[static_cast<std::size_t>(index)];
    const double events = child->trigger == Trigger::bounce ? static_cast<double>(parent.collide && !parent.follow_ground ? parent.bounce_limit + 1 : 0) : 1.0;
    count *= events * static_cast<double>(particleCount(parent));
    child = &parent;
  }
  return layer.enabled ? count : 0.0;
}

}  // namespace

double particleBudget(const Preset& preset) {
  double total = 0.0;
  for (const Layer& layer : preset.layers) total += mostParticles(preset, layer);
  return total;
}

double mostArcs(const Layer& layer, bool flat) {
  if (layer.follow_ground) return flat ? 1.0 : kMostArcsAlongGround;
  return layer.collide ? static_cast<double>(layer.bounce_limit) + 2.0 : 1.0;
}

double memoryBudget(const Preset& preset, bool flat) {
  // 32 bytes an arc, 4 for finding it, and 4 for its height where the ground is uneven; 60 for what a particle draws. Pieces of a model have a pose
  // each, and a mesh that is bounded.
  const double arc = flat ? 36.0 : 40.0;
  double total = 0.0;
  for (const Layer& layer : preset.layers) {
    const bool pieces = layer.form == Form::pieces;
    total += mostParticles(preset, layer) * (60.0 + (pieces ? 48.0 : 0.0) + arc * mostArcs(layer, flat));
    if (pieces && layer.enabled) total += kPiecesMemory;
  }
  return total;
}

std::vector<PresetFault> relationFaults(const Preset& preset) {
  std::vector<PresetFault> faults;
  if (preset.layers.size() > kMaxLayers)
    faults.push_back({"/layers", "", "there are " + std::to_string(preset.layers.size()) + " layers, above the limit of " + std::to_string(kMaxLayers) + ".", ""});
  checkNames(preset, faults);
  checkParents(preset, faults);
  checkDirections(preset, faults);
  checkPieces(preset, faults);
  if (faults.empty()) {
    if (const double budget = particleBudget(preset); budget > static_cast<double>(kMaxParticles))
      faults.push_back({"/layers", "", "the layers start " + shortest(budget) + " particles, above the limit of " + std::to_string(kMaxParticles) + ".",
                        "Lower a density or count; children are counted once per event of each parent particle."});
    else if (const double bytes = memoryBudget(preset); bytes > kMaxMemory)
      faults.push_back({"/layers", "", "the layers may take " + shortest(std::ceil(bytes / (1 << 20))) + " MiB with all their bounces, above the limit of " + shortest(kMaxMemory / (1 << 20)) + " MiB.",
                        "Lower a bounce_limit, density or count."});
  }
  return faults;
}

std::vector<Fault> validate(const Preset& preset) {
  std::vector<Fault> faults;
  const auto add = [&](std::string pointer, std::string what, std::string remedy) {
    faults.push_back({.what = std::move(what), .remedy = std::move(remedy), .file = {}, .line = 0, .pointer = std::move(pointer)});
  };
  for (const Parameter& row : parameters(Scope::burst))
    if (std::string wrong = checkValue(row, row.get(preset)); !wrong.empty()) add('/' + std::string(row.key), std::move(wrong), "");
  for (std::size_t i = 0; i < preset.layers.size(); ++i)
    for (const Parameter& row : parameters(Scope::layer))
      if (std::string wrong = checkValue(row, row.get(preset.layers[i])); !wrong.empty()) add(at(i, row.key), std::move(wrong), "");
  if (faults.empty())
    for (PresetFault& fault : relationFaults(preset)) add(std::move(fault.pointer), std::move(fault.what), std::move(fault.remedy));
  return faults;
}

}  // namespace npsee
