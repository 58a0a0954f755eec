#include "tests/fuzz/require.h"
#include "tests/fuzz/targets.h"

#include "sim/core/text.h"

#include <npsee/parameters.h>
#include <npsee/preset.h>


namespace npsee::fuzz {
namespace {

void survivesAFile(const Preset& preset) {
  const std::string text = presetText(preset);
  const auto again = parsePreset(text, "again");
  require(again.has_value(), "what is written can be read", again ? text : again.error().text() + text);
  require(*again == preset, "writing and reading changes nothing", text);
  require(presetText(*again) == text, "the text is the same when saved once more", text);
}

/// A layer with a parent, so that names, triggers and both scopes can be set.
Preset twoLayers() {
  Preset preset;
  preset.layers.resize(2);
  preset.layers[0].name = "a";
  preset.layers[1].name = "b";
  preset.layers[1].parent = "a";
  preset.layers[1].trigger = Trigger::death;
  preset.layers[0].count = preset.layers[1].count = 3;
  return preset;
}

}  // namespace

void presetFile(std::string_view bytes) {
  const auto preset = parsePreset(bytes, "fuzz");
  if (!preset) {
    requireFaults(preset.error());
    return;
  }
  const auto faults = validate(*preset);
  require(faults.empty(), "what is read is valid", faults.empty() ? "" : faults.front().text());
  survivesAFile(*preset);
}

void settings(std::string_view bytes) {
  Preset preset = twoLayers();
  int lines = 0;
  for (const std::string_view line : splitAt(bytes, '\n')) {
    // More lines find nothing new and make a run slow.
    if (++lines > 8) break;
    const Preset before = preset;
    if (const auto applied = applySetting(preset, line); !applied) {
      require(preset == before, "a refused setting changes nothing");
      require(applied.error().kind == ErrorKind::usage && !applied.error().text().empty(), "a refusal is a usage error with a text");
    }
  }
  if (validate(preset).empty()) survivesAFile(preset);
}

std::span<const NamedTarget> targets() {
  static constexpr NamedTarget all[] = {
      {"preset", presetFile, "presets .npsee.json"},
      {"setting", settings, ""},
      {"mission", missionFile, "assets/missions .mission.json"},
      {"mission_setting", missionSettings, ""},
      {"weapons", weaponsFile, "assets .dat"},
      {"rules", rulesFile, "assets/rules .clp"},
      {"projectile", projectileFile, "assets/projectiles .json"},
      {"aero", aeroTable, ""},
      {"recording", recordingFile, "tests/data/v1 .rec"},
      {"hgt", terrainHgt, ""},
      {"png", terrainPng, ""},
      {"script", uiScript, ""},
      {"picture", comparedPicture, "assets/desktop/icons 16.png"},
  };
  return all;
}

}  // namespace npsee::fuzz
