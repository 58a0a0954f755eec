#pragma once

#include "sim/observer/clips_host.h"
#include "sim/observer/mind.h"
#include "sim/observer/rules_guard.h"

#include <map>
#include <optional>

namespace npsee::observer {

/// Inside of a mind: the environment, what it has been told, and what it has not told the rules yet. Changes wait for `think`, which
/// tells them in order of their ids: the order of calls in between makes no difference.
struct Mind::Data {
  struct KnownContact {
    Contact value;
    FactHandle fact = nullptr;
    bool dismissed = false;                             ///< rules have retracted it
  };
  struct KnownMission {
    MissionFact value;
    FactHandle fact = nullptr;
  };

  explicit Data(const MindSetup& given);

  MindSetup setup;
  ClipsHost host;
  std::optional<SelfFacts> self, new_self;
  FactHandle self_fact = nullptr;
  std::map<int, KnownContact> contacts;
  std::map<int, std::optional<Contact>> new_contacts;   ///< no value = forgotten
  std::vector<int> told_contacts;                       ///< in the run under way
  std::map<int, KnownMission> missions;
  std::map<int, MissionFact> new_missions;
  std::vector<Spot> new_spots;
  std::vector<double> new_incoming;
  std::vector<FactHandle> passing;                      ///< spots and noticed fire: known for one run
  std::vector<Decision> decisions;                      ///< of the run under way

  /// Loads the rules and asserts what never changes. The error names file and line.
  Expected<void> load(const std::optional<GuardedRules>& own);
  void tellSettings();
  void tellChanges();
  void forgetPassing();
  void defineDecisions();
  void decide(Decision decision);
};

/// As rules are told it.
Contact rounded(const Contact& contact);

/// Words of rules for the values of enumerations.
std::string_view conditionWord(Contact::Condition condition);
std::string_view stateWord(MissionFact::State state);
std::string_view methodWord(FireMethod method);
std::optional<FireMethod> methodOf(std::string_view word);
std::string_view actionWord(MissionAction action);

struct ShippedFile {
  std::string_view name, text;
};
/// The rules that are part of the program, in the order they are loaded.
std::vector<ShippedFile> shippedFiles(bool with_rules);
/// Names the shipped files define, of those that are loaded.
KnownRules shippedNames(bool with_rules);

/// Makes a mind think about made-up contacts, missions and spots, so that rules fail before a mission rather than in it.
Expected<void> rehearse(Mind& mind, const MindSetup& setup);

}  // namespace npsee::observer
