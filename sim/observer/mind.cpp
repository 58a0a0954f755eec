#include "sim/observer/mind.h"

#include "sim/core/text.h"
#include "sim/observer/child.h"
#include "sim/observer/mind_data.h"
#include "sim/observer/shipped_rules.h"

#include <charconv>

namespace npsee::observer {
namespace {

// Between the fields of a fault on its way from the child process, and between faults.
constexpr char kField = '\x1f', kFault = '\x1e';

std::string faultsAsText(const std::vector<Fault>& faults) {
  std::string out;
  for (const Fault& fault : faults) out += printable(fault.what) + kField + printable(fault.remedy) + kField + printable(fault.file) + kField + std::to_string(fault.line) + kFault;
  return out;
}

std::vector<Fault> faultsOf(std::string_view text) {
  std::vector<Fault> out;
  for (const std::string_view line : splitAt(text, kFault)) {
    const auto fields = splitAt(line, kField);
    if (fields.size() != 4) continue;
    int number = 0;
    std::from_chars(fields[3].data(), fields[3].data() + fields[3].size(), number);
    out.push_back({std::string(fields[0]), std::string(fields[1]), std::string(fields[2]), number, {}});
  }
  return out;
}

}  // namespace

std::vector<ShippedFile> shippedFiles(bool with_rules) {
  std::vector<ShippedFile> out{{"assets/rules/templates.clp", shippedTemplates()}};
  if (!with_rules) return out;
  out.push_back({"assets/rules/observer.clp", shippedObserver()});
  out.push_back({"assets/rules/adjustment.clp", shippedAdjustment()});
  out.push_back({"assets/rules/effect.clp", shippedEffect()});
  return out;
}

KnownRules shippedNames(bool with_rules) {
  KnownRules out;
  for (const ShippedFile& file : shippedFiles(with_rules))
    if (const auto forms = readRules(file.text, file.name)) collectNames(*forms, out);
  return out;
}

Mind::Data::Data(const MindSetup& given) : setup(given) {
  setup.rules.clear();  // loaded once, not kept
  defineDecisions();
  host.removeOtherFunctions();
}

Expected<void> Mind::Data::load(const std::optional<GuardedRules>& own) {
  // Shipped files are part of the program and tested with it; only their places are taken here, for messages.
  for (const ShippedFile& file : shippedFiles(setup.shipped_rules)) {
    const std::string text(file.text), name(file.name);
    if (auto loaded = host.load(text, name); !loaded) return loaded;
    if (const auto forms = readRules(text, name))
      for (const RuleNode& form : *forms)
        if (form.head() == "defrule" && form.items.size() > 1) host.place(form.items[1].text, name, form.line);
  }
  if (own) {
    for (const GuardedRules::Rule& rule : own->rules) host.place(rule.name, setup.rules_name, rule.line);
    if (auto loaded = host.load(own->text, setup.rules_name); !loaded) return loaded;
  }
  host.begin();
  host.reset();
  tellSettings();
  return host.outcome();
}

Mind::Mind(std::unique_ptr<Data> data) : data_(std::move(data)) {}
Mind::~Mind() = default;
Mind::Mind(Mind&&) noexcept = default;
Mind& Mind::operator=(Mind&&) noexcept = default;

Expected<Mind> Mind::make(const MindSetup& setup) {
  std::optional<GuardedRules> own;
  if (!setup.rules.empty()) {
    auto guarded = guardRules(setup.rules, setup.rules_name, shippedNames(setup.shipped_rules));
    if (!guarded) return tl::unexpected(std::move(guarded.error()));
    own = std::move(*guarded);
    // Facts alone need no trial: they run nothing.
    if (!own->only_facts) {
      const auto report = runInChild("The rules of " + setup.rules_name, [&setup, &own]() -> std::string {
        auto data = std::make_unique<Data>(setup);
        if (const auto loaded = data->load(own); !loaded) return faultsAsText(loaded.error().faults);
        Mind mind(std::move(data));
        const auto rehearsed = rehearse(mind, setup);
        return rehearsed ? std::string() : faultsAsText(rehearsed.error().faults);
      });
      if (!report) {
        Error error = report.error();
        for (Fault& fault : error.faults) {
          fault.file = setup.rules_name;
          fault.line = 1;
        }
        return tl::unexpected(std::move(error));
      }
      if (!report->empty()) return tl::unexpected(Error{ErrorKind::input, faultsOf(*report)});
    }
  }
  auto data = std::make_unique<Data>(setup);
  if (const auto loaded = data->load(own); !loaded) return tl::unexpected(loaded.error());
  return Mind(std::move(data));
}

Expected<void> Mind::think(std::vector<Decision>& decisions) {
  Data& data = *data_;
  data.decisions.clear();
  data.host.begin();
  data.tellChanges();
  auto ran = data.host.run();
  data.forgetPassing();
  if (!ran) return ran;
  decisions.insert(decisions.end(), std::make_move_iterator(data.decisions.begin()), std::make_move_iterator(data.decisions.end()));
  return {};
}

std::vector<std::string> Mind::facts() const {
  data_->host.begin();
  data_->tellChanges();
  return data_->host.facts();
}

std::string Mind::lastRule() const { return data_->host.firingRule(); }

}  // namespace npsee::observer
