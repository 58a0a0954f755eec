#include "sim/observer/mind.h"
#include "sim/world/scenario_files.h"

namespace npsee::world {
namespace {

using observer::ObserverFacts;

/// Facts of a file; those of a file named twice are read once.
class FactsFiles {
 public:
  FactsFiles(const Scenario& scenario, std::vector<Fault>* warnings) : folder_(scenario.folder), warnings_(warnings) {}

  /// Error kind input.
  Expected<const ObserverFacts*> read(const std::filesystem::path& name) {
    for (const auto& [known, facts] : read_)
      if (known == name) return facts.get();
    const auto text = readNamed(folder_, name);
    if (!text) return tl::unexpected<Error>(text.error());
    auto facts = observer::parseObserverFacts(text->text, text->name);
    if (!facts) return tl::unexpected<Error>(facts.error());
    if (warnings_ != nullptr) warnings_->insert(warnings_->end(), facts->warnings.begin(), facts->warnings.end());
    read_.emplace_back(name, std::make_unique<ObserverFacts>(std::move(*facts)));
    return read_.back().second.get();
  }

 private:
  std::filesystem::path folder_;
  std::vector<Fault>* warnings_;
  std::vector<std::pair<std::filesystem::path, std::unique_ptr<ObserverFacts>>> read_;
};

/// What the facts fill in.
void fill(Scenario& scenario, const ObserverFacts& facts) {
  if (scenario.observers.empty() && facts.has_observer) {
    ObserverSetup& observer = scenario.observers.emplace_back();
    observer.id = "fo1";
    observer.at = facts.observer;
    observer.type = facts.mounted_on;
  }
  if (scenario.batteries.empty() && !facts.guns.empty()) {
    BatterySetup& battery = scenario.batteries.emplace_back();
    battery.id = "battery";
    battery.guns = facts.guns;
  }
}

}  // namespace

Expected<Scenario> resolved(const Scenario& scenario, std::vector<Fault>* warnings) {
  Scenario out = scenario;
  FactsFiles files(scenario, warnings);
  const ObserverFacts* shared = nullptr;
  if (!scenario.facts.empty()) {
    const auto facts = files.read(scenario.facts);
    if (!facts) return tl::unexpected<Error>(facts.error());
    shared = *facts;
    fill(out, *shared);
  }
  for (std::size_t i = 0; i < out.observers.size(); ++i) {
    const bool without_orders = out.observers[i].missions.empty();
    if (!out.observers[i].rules.empty() && (without_orders || out.batteries.empty())) {
      const auto own = files.read(out.observers[i].rules);
      if (!own) return tl::unexpected<Error>(own.error());
      fill(out, **own);
      if (without_orders) out.observers[i].missions = (*own)->missions;
    }
    if (out.observers[i].missions.empty() && shared != nullptr) out.observers[i].missions = shared->missions;
  }
  if (warnings != nullptr) addDoubts(out, *warnings);
  return out;
}

}  // namespace npsee::world
