#include "sim/observer/mind.h"
#include "sim/observer/mind_data.h"
#include "sim/observer/rules_guard.h"

#include <charconv>
#include <cmath>

namespace npsee::observer {
namespace {

template <class Number>
std::optional<Number> numberOf(std::string_view text) {
  Number out{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return out;
}

/// Takes the thesis's facts out of a file; everything else is left to the rule engine.
class FactsReader {
 public:
  explicit FactsReader(std::string_view file) : file_(file) {}

  void form(const RuleNode& form) {
    if (isThesisFact(form)) return fact(form);
    if (form.head() != "deffacts") return;
    for (const RuleNode& item : form.items)
      if (isThesisFact(item)) fact(item);
  }

  ObserverFacts out;
  std::vector<Fault> faults;

 private:
  void fault(const RuleNode& node, std::string what, std::string remedy) { faults.push_back({std::move(what), std::move(remedy), std::string(file_), node.line, {}}); }

  void fact(const RuleNode& node) {
    for (const RuleNode& item : node.items)
      if (item.kind != RuleNode::Kind::word) return fault(node, std::string(node.head()) + " takes words and numbers only.", usage(node.head()));
    if (node.head() == "location") return location(node);
    if (node.head() == "mountedon") return mountedOn(node);
    mission(node);
  }

  static std::string usage(std::string_view head) {
    if (head == "location") return "Write (location observer X Z) or (location gun1 X Z), in metres.";
    if (head == "mountedon") return "Write (mountedon TYPE) with the index of a vehicle type, such as 8.";
    return "Write (mission destroy TYPE), (mission neutralize TYPE) or (mission special TYPE).";
  }

  void location(const RuleNode& node) {
    const auto x = node.items.size() == 4 ? numberOf<double>(node.items[2].text) : std::nullopt;
    const auto z = node.items.size() == 4 ? numberOf<double>(node.items[3].text) : std::nullopt;
    if (!x || !z || !std::isfinite(*x) || !std::isfinite(*z)) return fault(node, "A location is a name and two numbers.", usage("location"));
    const std::string name(node.items[1].text);
    if (name == "observer") {
      out.has_observer = true;
      out.observer = {*x, *z};
      return;
    }
    for (const GunSetup& gun : out.guns)
      if (gun.id == name) return fault(node, "The location of " + printable(name) + " is given twice.", "Remove one.");
    out.guns.push_back({name, {*x, *z}});
  }

  void mountedOn(const RuleNode& node) {
    const int type = node.items.size() == 2 ? numberOf<int>(node.items[1].text).value_or(-1) : -1;
    if (type < 0) return fault(node, "mountedon takes the index of a vehicle type.", usage("mountedon"));
    out.mounted_on = type;
  }

  void mission(const RuleNode& node) {
    const int type = node.items.size() == 3 ? numberOf<int>(node.items[2].text).value_or(-1) : -1;
    std::optional<MissionAction> action;
    for (const auto candidate : {MissionAction::destroy, MissionAction::neutralize, MissionAction::special})
      if (node.items.size() == 3 && node.items[1].text == actionWord(candidate)) action = candidate;
    if (type < 0 || !action) return fault(node, "A mission is an action and the index of a vehicle type.", usage("mission"));
    out.missions.push_back({*action, type});
  }

  std::string_view file_;
};

}  // namespace

Expected<ObserverFacts> parseObserverFacts(std::string_view text, std::string_view file) {
  const auto guarded = guardRules(text, file, shippedNames(true));
  if (!guarded) return tl::unexpected(guarded.error());
  const auto forms = readRules(text, file);
  if (!forms) return tl::unexpected(forms.error());
  FactsReader reader(file);
  for (const RuleNode& form : *forms) reader.form(form);
  if (!reader.faults.empty()) return tl::unexpected(Error{ErrorKind::input, std::move(reader.faults)});
  reader.out.only_facts = guarded->only_facts;
  reader.out.warnings = guarded->warnings;
  return std::move(reader.out);
}

}  // namespace npsee::observer
