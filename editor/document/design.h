#pragma once

#include "editor/document/launch_probe.h"
#include "editor/document/moments.h"
#include "editor/document/past.h"
#include "editor/document/template_ease.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace npsee::editor {

/// What a designer looks at beside the preset itself: neither saved with it nor undone.
struct Design {
  TemplateEase ease;

  /// The selected layer's launch, kept until layer or preset change.
  LaunchProbe probe;
  /// How the values of a parameter are spread over the particles, by the parameter's key; no entry where nothing is known or nothing spreads.
  std::map<std::string, Histogram, std::less<>> histograms;
  const Histogram* histogram(std::string_view key) const {
    const auto found = histograms.find(key);
    return found == histograms.end() ? nullptr : &found->second;
  }

  Moments moments;
  Past skins, trails;  ///< for the overlays of the same names
  bool show_onion = false, show_trails = false, show_speed = false, show_figures = false;

  double amount = 0.2;            ///< how far randomising goes
  std::uint64_t draws = 0;        ///< how often it was done
  std::set<std::string> locked;   ///< "LAYER.key" of what randomising leaves as it is

  /// Layers shown alone; all are shown where it is empty. By name.
  std::set<std::string> solo;
  bool shows(const std::string& layer) const { return solo.empty() || solo.contains(layer); }

  /// A layer has another name now. Session sees to it.
  void rename(const std::string& from, const std::string& to);
};

}  // namespace npsee::editor
