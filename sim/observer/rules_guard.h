#pragma once

#include "sim/observer/rules_text.h"

#include <npsee/error.h>

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace npsee::observer {

/// What rules may use: everything else of CLIPS is refused by name before the text is parsed and removed from the environment.
std::span<const std::string_view> allowedFunctions();
/// Functions of ours that rules decide with: call-for-fire, correct, ...
std::span<const std::string_view> decisionFunctions();
std::span<const std::string_view> allowedConstructs();

/// Names that other files have defined already.
struct KnownRules {
  std::set<std::string, std::less<>> templates, functions, globals;
};
/// Adds what a file defines.
void collectNames(const std::vector<RuleNode>& forms, KnownRules& known);

struct GuardedRules {
  struct Rule {
    std::string name;
    int line = 0;
  };
  std::string text;             ///< to be loaded: bare facts wrapped in deffacts, join counters between patterns; lines as before
  std::vector<Rule> rules;
  std::vector<Fault> warnings;
  bool only_facts = true;       ///< nothing but deffacts and bare facts
};

/// Checks foreign rules before anything parses them. The error lists every fault with file and line: what is not allowed, recursion
/// of deffunctions (direct or mutual), names that are taken. Memory and time are bounded by the limits of the text.
Expected<GuardedRules> guardRules(std::string_view text, std::string_view file, const KnownRules& known);

/// The facts of the thesis's file that may stand bare: location, mountedon, mission.
bool isThesisFact(const RuleNode& node);

}  // namespace npsee::observer
