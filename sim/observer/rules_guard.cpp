#include "sim/observer/rules_guard.h"

#include "sim/core/text.h"
#include "sim/observer/clips_host.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace npsee::observer {
namespace {

// Left out on purpose: what reads clocks or draws at random, files, the system, the interpreter itself (eval, build, run, undefrule),
// transcendental functions (their last bits differ between machines), div and mod (the least integer divided by -1 ends the
// process), and loops over all facts, which no limit sees.
constexpr std::array kFunctions = std::to_array<std::string_view>({
    "!=", "*", "+", "-", "/", "<", "<=", "<>", "=", ">", ">=", "abs", "and", "assert", "bind", "break", "create$", "duplicate", "eq",
    "evenp", "first$", "float", "floatp", "foreach", "if", "insert$", "integer", "integerp", "length$", "lexemep", "loop-for-count",
    "lowcase", "max", "member$", "min", "modify", "multifieldp", "neq", "not", "nth$", "numberp", "oddp", "or", "progn", "progn$",
    "rest$", "retract", "return", "round", "sqrt", "str-cat", "str-compare", "str-index", "str-length", "stringp", "sub-string",
    "subseq$", "sym-cat", "symbolp", "upcase", "while"});
constexpr std::array kDecisions = std::to_array<std::string_view>({"call-for-fire", "correct", "end-of-mission", "fire-for-effect", "warn", "withdraw"});
constexpr std::array kConstructs = std::to_array<std::string_view>({"deffacts", "deffunction", "defglobal", "defrule", "deftemplate"});
constexpr std::size_t kMaxArguments = 64, kMaxPatterns = 24, kMaxWildcards = 2, kMaxFunctions = 200, kMaxFaults = 50;

bool isAllowed(std::string_view name) {
  return std::ranges::find(kFunctions, name) != kFunctions.end() || std::ranges::find(kDecisions, name) != kDecisions.end();
}
bool isVariable(std::string_view word) { return word.starts_with("?") || word.starts_with("$?"); }

class Guard {
 public:
  Guard(std::string_view text, std::string_view file, const KnownRules& known) : text_(text), file_(file), known_(known) {}

  Expected<GuardedRules> check(const std::vector<RuleNode>& forms) {
    collectNames(forms, own_);
    for (const RuleNode& form : forms) construct(form);
    findRecursion();
    if (!faults_.empty()) {
      std::ranges::stable_sort(faults_, {}, &Fault::line);
      return tl::unexpected(Error{ErrorKind::input, std::move(faults_)});
    }
    if (bare_ > 0)
      out_.warnings.push_back({std::to_string(bare_) + (bare_ == 1 ? " bare fact was" : " bare facts were") + " taken as if a deffacts construct stood around them.",
                               "Write (deffacts forward-observer ...) around the facts.", std::string(file_), first_bare_, {}});
    out_.text = rewritten();
    return std::move(out_);
  }

 private:
  bool full() const { return faults_.size() >= kMaxFaults; }
  void fault(const RuleNode& node, std::string what, std::string remedy) {
    if (!full()) faults_.push_back({std::move(what), std::move(remedy), std::string(file_), node.line, {}});
  }
  static std::string shown(std::string_view word) {
    return printable(word.size() <= 60 ? word : word.substr(0, 60)) + (word.size() > 60 ? "..." : "");
  }

  void construct(const RuleNode& form) {
    const std::string_view head = form.head();
    if (!form.isList()) return fault(form, shown(form.text) + " stands outside of any construct.", "Remove it, or put it into a rule or fact.");
    if (isThesisFact(form)) return bareFact(form);
    if (std::ranges::find(kConstructs, head) == kConstructs.end()) return unknownConstruct(form, head);
    if (head != "deffacts") out_.only_facts = false;
    if (head != "defglobal" && (form.items.size() < 2 || form.items[1].kind != RuleNode::Kind::word))
      return fault(form, "A " + std::string(head) + " has no name.", "Write (" + std::string(head) + " NAME ...).");
    if (head != "defglobal" && form.items[1].text.find("::") != std::string_view::npos)
      return fault(form, shown(form.items[1].text) + " names a module; rules of an observer have none.", "Leave out what stands before the ::.");
    if (head == "defrule") rule(form);
    if (head == "deffunction") function(form);
    if (head == "deffacts") facts(form, 2);
    if (head == "deftemplate") deftemplate(form);
    if (head == "defglobal") globals(form);
  }

  void unknownConstruct(const RuleNode& form, std::string_view head) {
    if (head.empty()) return fault(form, "A list at the outermost level does not begin with a word.", "Begin it with defrule, deffacts, deftemplate, deffunction or defglobal.");
    std::string remedy = "Allowed are " + listed({kConstructs.begin(), kConstructs.end()}) + ", and the facts location, mountedon and mission.";
    if (const auto near = nearest(head, {kConstructs.begin(), kConstructs.end()})) remedy = "Did you mean " + std::string(*near) + "? " + remedy;
    fault(form, shown(head) + " is not allowed at the outermost level.", std::move(remedy));
  }

  void bareFact(const RuleNode& form) {
    factValues(form);
    insertions_.emplace_back(form.begin, "(deffacts npsee-bare-" + std::to_string(++bare_) + " ");
    insertions_.emplace_back(form.end, ")");
    if (bare_ == 1) first_bare_ = form.line;
  }

  // ----- facts -----

  bool isTemplate(std::string_view name) const { return own_.templates.contains(name) || known_.templates.contains(name); }

  /// The values of a fact: of the slots of a template, or of an ordered fact.
  void factValues(const RuleNode& fact) {
    const bool slots = isTemplate(fact.head());
    for (std::size_t i = 1; i < fact.items.size(); ++i) {
      const RuleNode& item = fact.items[i];
      if (!item.isList()) continue;
      if (slots)
        values(item, 1);
      else
        expression(item);
    }
  }

  bool isFunction(std::string_view name) const { return own_.functions.contains(name) || known_.functions.contains(name) || isAllowed(name); }

  /// `(NAME (slot ...))` without such a template: meant was one that has another name.
  /// `sure`: nothing else can have been meant.
  bool meantTemplate(const RuleNode& fact, bool sure) {
    if (isTemplate(fact.head()) || fact.items.size() < 2 || !fact.items[1].isList() || isFunction(fact.items[1].head())) return false;
    std::vector<std::string_view> candidates(own_.templates.begin(), own_.templates.end());
    candidates.insert(candidates.end(), known_.templates.begin(), known_.templates.end());
    const auto near = nearest(fact.head(), candidates);
    if (!near && !sure) return false;
    fault(fact, "There is no template " + shown(fact.head()) + " with a slot " + shown(fact.items[1].head()) + ".",
          (near ? "Did you mean " + std::string(*near) + "? " : "") + "docs/rules.md lists the templates; a deftemplate makes others.");
    return true;
  }

  void facts(const RuleNode& list, std::size_t from) {
    for (std::size_t i = from; i < list.items.size(); ++i) {
      const RuleNode& item = list.items[i];
      if (item.isList()) {
        if (!meantTemplate(item, false)) factValues(item);
      } else if (item.kind != RuleNode::Kind::text || i != from) {
        fault(item, shown(item.text) + " is not a fact.", "Write (NAME value ...).");
      }
    }
  }

  void deftemplate(const RuleNode& form) {
    const std::string_view name = form.items[1].text;
    if (known_.templates.contains(name)) fault(form, "There is a template " + shown(name) + " already.", "Choose another name; docs/rules.md lists the templates.");
    if (name == "location" || name == "mountedon" || name == "mission") fault(form, shown(name) + " is an ordered fact of the thesis's file.", "Choose another name.");
    for (const RuleNode& slot : form.items) {
      if (!slot.isList()) continue;
      if (slot.head() != "slot" && slot.head() != "multislot" && slot.head() != "field" && slot.head() != "multifield")
        fault(slot, shown(slot.head()) + " is no slot.", "Write (slot NAME) or (multislot NAME).");
      for (const RuleNode& attribute : slot.items) {
        if (!attribute.isList()) continue;
        if (attribute.head() == "default-dynamic") fault(attribute, "default-dynamic is not allowed.", "Use (default VALUE).");
        values(attribute, 1);
      }
    }
  }

  void globals(const RuleNode& form) {
    for (std::size_t i = 1; i < form.items.size(); ++i) {
      const RuleNode& item = form.items[i];
      if (item.isList()) expression(item);
      if (known_.globals.contains(item.text)) fault(item, "There is a global variable " + shown(item.text) + " already.", "Choose another name.");
    }
  }

  // ----- expressions -----

  void values(const RuleNode& list, std::size_t from) {
    for (std::size_t i = from; i < list.items.size(); ++i)
      if (list.items[i].isList()) expression(list.items[i]);
  }

  void expression(const RuleNode& call) {
    const std::string_view name = call.head();
    if (name.empty()) return fault(call, "A function call does not begin with the name of a function.", "Write (FUNCTION argument ...).");
    if (call.items.size() > kMaxArguments + 1)
      fault(call, shown(name) + " is called with " + std::to_string(call.items.size() - 1) + " arguments, above the limit of " + std::to_string(kMaxArguments) + ".", "Write it as several calls.");
    if (own_.functions.contains(name) || known_.functions.contains(name))
      calls_[function_].insert(std::string(name));
    else if (!isAllowed(name))
      return notAllowed(call, name);
    if (name == "assert") return facts(call, 1);
    if (name == "modify" || name == "duplicate") return changedSlots(call);
    if (name == "loop-for-count" || name == "progn$" || name == "foreach") return loop(call);
    values(call, 1);
  }

  void notAllowed(const RuleNode& call, std::string_view name) {
    if (full()) return;
    std::vector<std::string_view> candidates(kFunctions.begin(), kFunctions.end());
    candidates.insert(candidates.end(), kDecisions.begin(), kDecisions.end());
    const std::vector<std::string> own(own_.functions.begin(), own_.functions.end());
    candidates.insert(candidates.end(), own.begin(), own.end());
    std::string remedy = name == "printout" ? "Use (warn \"text\" ...): it writes into the event log." : "docs/rules.md lists the functions rules may use.";
    if (const auto near = nearest(name, candidates)) remedy = "Did you mean " + std::string(*near) + "? " + remedy;
    fault(call, "Rules may not use the function " + shown(name) + ".", std::move(remedy));
  }

  void changedSlots(const RuleNode& call) {
    for (std::size_t i = 1; i < call.items.size(); ++i) {
      const RuleNode& item = call.items[i];
      if (!item.isList()) continue;
      if (i == 1)
        expression(item);
      else
        values(item, 1);
    }
  }

  /// (loop-for-count (?i 1 n) ...), (progn$ (?x list) ...): the first list declares.
  void loop(const RuleNode& call) {
    for (std::size_t i = 1; i < call.items.size(); ++i) {
      const RuleNode& item = call.items[i];
      if (!item.isList()) continue;
      if (i == 1 && isVariable(item.head()))
        values(item, 1);
      else
        expression(item);
    }
  }

  // ----- functions -----

  void function(const RuleNode& form) {
    const std::string_view name = form.items[1].text;
    if (known_.functions.contains(name)) fault(form, "There is a function " + shown(name) + " already.", "Choose another name.");
    if (isAllowed(name) || name == kJoinCounter) fault(form, shown(name) + " is a function of the rule engine.", "Choose another name.");
    function_ = std::string(name);
    lines_.emplace(function_, form.line);
    calls_[function_];
    bool parameters = false;
    for (std::size_t i = 2; i < form.items.size(); ++i) {
      if (!form.items[i].isList()) continue;
      if (parameters) expression(form.items[i]);
      parameters = true;
    }
    function_.clear();
  }

  /// Follows calls from each function; a way back to it is recursion. Iterative: the file may chain many functions.
  void findRecursion() {
    if (lines_.size() > kMaxFunctions)
      return faults_.push_back({"The file has " + std::to_string(lines_.size()) + " functions, above the limit of " + std::to_string(kMaxFunctions) + ".", "Use fewer.", std::string(file_), 1, {}});
    for (const auto& [start, line] : lines_) {
      std::set<std::string, std::less<>> seen;
      std::vector<std::string> open(calls_[start].begin(), calls_[start].end());
      while (!open.empty()) {
        const std::string at = std::move(open.back());
        open.pop_back();
        if (at == start) {
          RuleNode node;
          node.line = line;
          fault(node, "The function " + shown(start) + " calls itself, directly or through others.", "Use a loop: (while ...), (loop-for-count ...).");
          break;
        }
        if (!seen.insert(at).second) continue;
        if (const auto found = calls_.find(at); found != calls_.end()) open.insert(open.end(), found->second.begin(), found->second.end());
      }
    }
  }

  // ----- rules -----

  void rule(const RuleNode& form) {
    out_.rules.push_back({std::string(form.items[1].text), form.line});
    const auto arrow = std::ranges::find_if(form.items, [](const RuleNode& item) { return item.isWord("=>"); });
    if (arrow == form.items.end()) return fault(form, "The rule " + shown(form.items[1].text) + " has no =>.", "Write (defrule NAME conditions => actions).");
    patterns_ = 0;
    rule_line_ = form.line;
    for (auto item = form.items.begin() + 2; item != arrow; ++item)
      if (item->isList()) condition(*item, true);
    if (patterns_ > kMaxPatterns)
      fault(form, "The rule " + shown(form.items[1].text) + " has " + std::to_string(patterns_) + " patterns, above the limit of " + std::to_string(kMaxPatterns) + ".", "Write it as several rules.");
    for (auto item = arrow + 1; item != form.items.end(); ++item) {
      if (item->isList())
        expression(*item);
      else if (!isVariable(item->text))
        fault(*item, shown(item->text) + " stands among the actions of a rule.", "Actions are calls such as (assert ...).");
    }
  }

  /// `counted`: a join counter may stand after it.
  void condition(const RuleNode& node, bool counted) {
    const std::string_view head = node.head();
    if (head == "declare") return declaration(node);
    if (head == "test") return values(node, 1);
    if (head == "logical" || head == "forall" || head == "object")
      return fault(node, shown(head) + " conditions are not allowed.", "Use patterns, not, and, or, exists and test.");
    if (head == "not" || head == "or") {
      for (const RuleNode& item : node.items)
        if (item.isList()) condition(item, false);
      if (head == "or" && counted) count(node);
      return;
    }
    if (head == "and" || head == "exists") {
      const bool several = node.items.size() > 2;
      for (const RuleNode& item : node.items)
        if (item.isList()) condition(item, several);
      return;
    }
    pattern(node);
    if (counted) count(node);
  }

  void count(const RuleNode& node) { insertions_.emplace_back(node.end, " (test (" + std::string(kJoinCounter) + " " + std::to_string(rule_line_) + "))"); }

  void declaration(const RuleNode& node) {
    for (std::size_t i = 1; i < node.items.size(); ++i)
      if (node.items[i].head() != "salience" || node.items[i].items.size() != 2 || node.items[i].items[1].kind != RuleNode::Kind::word)
        fault(node.items[i], "Only (salience NUMBER) may be declared.", "Write (declare (salience 10)).");
  }

  void pattern(const RuleNode& node) {
    ++patterns_;
    if (node.head().empty()) return fault(node, "A pattern does not begin with the name of a fact.", "Write (NAME ...).");
    if (meantTemplate(node, true)) return;
    std::size_t wildcards = 0;
    for (const RuleNode& item : node.items) {
      wildcards += item.kind == RuleNode::Kind::word && item.text.starts_with("$?") ? 1 : 0;
      if (item.isList() && isTemplate(node.head())) constraint(item, wildcards);
    }
    if (!isTemplate(node.head())) {
      wildcards = 0;
      constraint(node, wildcards);
    }
    // Each wildcard for several values multiplies the ways a fact can match by its length.
    if (wildcards > kMaxWildcards)
      fault(node, "A pattern has " + std::to_string(wildcards) + " wildcards for several values ($?), above the limit of " + std::to_string(kMaxWildcards) + ".", "Use fewer.");
  }

  /// Lists among constraints are calls: `?x&:(> ?x 3)`, `=(+ ?x 1)`.
  void constraint(const RuleNode& node, std::size_t& wildcards) {
    for (const RuleNode& item : node.items) {
      if (item.kind == RuleNode::Kind::word && item.text.starts_with("$?")) ++wildcards;
      if (item.isList()) expression(item);
    }
  }

  std::string rewritten() {
    std::ranges::stable_sort(insertions_, {}, &std::pair<std::size_t, std::string>::first);
    std::string out;
    std::size_t at = 0;
    for (const auto& [place, piece] : insertions_) {
      out += text_.substr(at, place - at);
      out += piece;
      at = place;
    }
    return out += text_.substr(at);
  }

  std::string_view text_, file_;
  const KnownRules& known_;
  KnownRules own_;
  GuardedRules out_;
  std::vector<Fault> faults_;
  std::vector<std::pair<std::size_t, std::string>> insertions_;
  std::map<std::string, std::set<std::string>, std::less<>> calls_;  ///< of functions; "" = rules and facts
  std::map<std::string, int> lines_;                                 ///< of functions
  std::string function_;
  std::size_t patterns_ = 0;
  int bare_ = 0, first_bare_ = 0, rule_line_ = 0;
};

}  // namespace

std::span<const std::string_view> allowedFunctions() { return kFunctions; }
std::span<const std::string_view> decisionFunctions() { return kDecisions; }
std::span<const std::string_view> allowedConstructs() { return kConstructs; }

bool isThesisFact(const RuleNode& node) {
  const std::string_view head = node.head();
  return head == "location" || head == "mountedon" || head == "mission";
}

void collectNames(const std::vector<RuleNode>& forms, KnownRules& known) {
  for (const RuleNode& form : forms) {
    if (form.items.size() < 2) continue;
    const std::string name(form.items[1].text);
    if (form.head() == "deftemplate") known.templates.insert(name);
    if (form.head() == "deffunction") known.functions.insert(name);
    if (form.head() == "defglobal")
      for (const RuleNode& item : form.items)
        if (item.text.starts_with("?*")) known.globals.insert(std::string(item.text));
  }
}

Expected<GuardedRules> guardRules(std::string_view text, std::string_view file, const KnownRules& known) {
  const auto forms = readRules(text, file);
  if (!forms) return tl::unexpected(forms.error());
  return Guard(text, file, known).check(*forms);
}

}  // namespace npsee::observer
