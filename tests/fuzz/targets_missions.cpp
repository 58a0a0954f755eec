#include "sim/core/text.h"
#include "sim/observer/clips_host.h"
#include "sim/observer/mind.h"
#include "sim/observer/rules_guard.h"
#include "tests/fuzz/require.h"
#include "tests/fuzz/scratch_file.h"
#include "tests/fuzz/targets.h"

#include <npsee/mission.h>

#include <cmath>

namespace npsee::fuzz {
namespace {

void survivesAFile(const Scenario& scenario) {
  const std::string text = scenarioText(scenario);
  const auto again = parseScenario(text, "again");
  require(again.has_value(), "a mission that is written can be read", again ? text : again.error().text() + '\n' + text);
  require(scenarioText(*again) == text, "the text of a mission is the same when saved once more", text);
}

/// A mission with something to change.
Scenario small() {
  auto read = parseScenario(R"({"npsee_mission": 1, "name": "a", "duration": 10, "vehicles": [{"id": "v", "type": 51, "pos": [100, 100]}],
    "batteries": [{"id": "b", "guns": [{"id": "g", "pos": [200, 200]}]}], "observers": [{"id": "o", "pos": [300, 300]}]})", "small");
  return read ? *read : Scenario{};
}

}  // namespace

void missionFile(std::string_view bytes) {
  const auto scenario = parseScenario(bytes, "fuzz", "/nowhere");
  if (!scenario) return requireFaults(scenario.error());
  require(validate(*scenario).empty(), "a mission that is read is valid");
  survivesAFile(*scenario);
}

void missionSettings(std::string_view bytes) {
  static const Scenario start = small();
  Scenario scenario = start;
  int lines = 0;
  for (const std::string_view line : splitAt(bytes, '\n')) {
    if (++lines > 8) break;
    const Scenario before = scenario;
    if (const auto applied = applySetting(scenario, line); !applied) {
      require(scenario == before, "a refused setting changes nothing", std::string(line));
      require(applied.error().kind == ErrorKind::usage, "a refusal is a usage error");
      requireFaults(applied.error());
    }
  }
  if (validate(scenario).empty()) survivesAFile(scenario);
}

void rulesFile(std::string_view bytes) {
  if (const auto facts = observer::parseObserverFacts(bytes, "fuzz.clp"); !facts) requireFaults(facts.error());
  const auto guarded = observer::guardRules(bytes, "fuzz.clp", {});
  if (!guarded) return requireFaults(guarded.error());
  // In a host of its own, without the shipped templates: many files fail to load, none may do harm.
  observer::ClipsHost host;
  host.removeOtherFunctions();
  if (const auto loaded = host.load(guarded->text, "fuzz.clp"); !loaded) return requireFaults(loaded.error());
  host.begin();
  host.reset();
  if (const auto ran = host.run(); !ran) requireFaults(ran.error());
}

void recordingFile(std::string_view bytes) {
  const ScratchFile file(".rec", bytes);
  const auto recording = loadRecording(file.path());
  if (!recording) return requireFaults(recording.error());
  for (const double t_s : {0.0, 0.5 * recording->duration_s, recording->duration_s}) {
    for (std::size_t i = 0; i < recording->vehicles.size(); ++i) require(std::isfinite(recording->vehiclePlace(i, t_s).y), "a vehicle has a place");
    for (const ShellRecord& shell : recording->shells) require(std::isfinite(shell.at(t_s).y), "a shell has a place");
  }
  require(!eventLog(*recording).empty() || recording->events.empty(), "events have lines");
}

}  // namespace npsee::fuzz
