#pragma once

#include "editor/document/launch_probe.h"
#include "editor/document/template_ease.h"

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

  /// Layers shown alone; all are shown where it is empty. By name.
  std::set<std::string> solo;
  bool shows(const std::string& layer) const { return solo.empty() || solo.contains(layer); }
};

}  // namespace npsee::editor
