#include "sim/core/files.h"
#include "sim/observer/mind.h"
#include "tests/observer/observer_support.h"
#include "tests/support/process.h"

#include <algorithm>

namespace npsee::observer {
namespace {

std::string faultsOf(const std::string& rules) {
  std::string out;
  for (const Fault& fault : checkRules(rules, "own.clp")) out += fault.text() + "\n";
  return out;
}

/// The rules are refused with a message at the line that contains the words.
void expectRefused(const std::string& rules, int line, const std::string& words) {
  const auto faults = checkRules(rules, "own.clp");
  ASSERT_FALSE(faults.empty()) << rules.substr(0, 200);
  const bool found = std::ranges::any_of(faults, [&](const Fault& fault) { return fault.line == line && fault.what.find(words) != std::string::npos && !fault.remedy.empty() && fault.file == "own.clp"; });
  EXPECT_TRUE(found) << "wanted line " << line << ": " << words << "\n" << faultsOf(rules);
}
struct Refused {
  std::string rules;
  int line;
  std::string words;
};
void expectRefused(std::initializer_list<Refused> all) {
  for (const auto& [rules, line, words] : all) expectRefused(rules, line, words);
}

/// A rule with these actions.
std::string acting(const std::string& actions) { return "; a rule\n(defrule mine\n  =>\n  " + actions + ")\n"; }

std::string shipped(const std::string& name) {
  const auto text = readTextFile(std::string(NPSEE_SOURCE_DIR) + "/assets/rules/" + name + ".clp");
  EXPECT_TRUE(text) << name;
  return text.value_or("");
}

/// What an observer with that setup decides about a T-72 at 2 km.
std::string decided(const MindSetup& setup) {
  Observer observer(setup);
  observer.mind().contact(Observer::tank(3, 2000.0));
  return Observer::told(observer.think());
}

// ----- what is not allowed -----

TEST(RulesFile, WithForbiddenFunctionsIsRefusedAtTheirLine) {
  for (const std::string name : {"exit", "open", "close", "read", "readline", "printout", "system", "load", "load*", "bload", "save", "bsave", "batch", "batch*", "eval", "build", "run", "reset", "clear",
                                 "random", "seed", "time", "gensym", "gensym*", "setgen", "rename", "remove", "dribble-on", "undefrule", "set-strategy", "funcall", "sin", "exp", "log", "**", "div", "mod",
                                 "halt", "do-for-all-facts", "find-all-facts", "any-factp", "assert-string", "load-facts", "save-facts", "release-mem", "constructs-to-c", "operating-system", "npsee-join",
                                 "focus", "set-fact-duplication", "watch", "sort", "send", "make-instance", "timer"})
    expectRefused(acting("(" + name + " 1)"), 4, "may not use the function " + name + ".");
}

TEST(RulesFile, WithForbiddenFunctionsHiddenAnywhereIsRefused) {
  expectRefused({
      {"(defrule a (contact (id ?i&:(exit))) => )", 1, "exit"},
      {"(defrule a (contact (id =(exit))) => )", 1, "exit"},
      {"(defrule a (test (exit)) => )", 1, "exit"},
      {"(defrule a (not (and (contact) (test (or TRUE (exit))))) => )", 1, "exit"},
      {"(deffunction f () (exit))", 1, "exit"},
      {"(deffacts f (foo (exit)))", 1, "exit"},
      {"(defglobal ?*x* = (exit))", 1, "exit"},
      {"(deftemplate t (slot a (default (exit))))", 1, "exit"},
      {"(deftemplate t (slot a (default-dynamic 3)))", 1, "default-dynamic"},
      {acting("(assert (foo (exit)))"), 4, "exit"},
      {acting("(assert (spot (mission (exit))))"), 4, "exit"},
      {"(defrule a ?f <- (contact) => (modify ?f (id (exit))))", 1, "exit"},
      {acting("(loop-for-count (?i 1 (exit)) do (bind ?x 1))"), 4, "exit"},
      {acting("(progn$ (?x (exit)) (bind ?y 1))"), 4, "exit"},
      {acting("(if TRUE then (exit) else (exit))"), 4, "exit"},
      {"(defrule a (declare (salience (exit))) => )", 1, "salience"},
      {"(mission destroy (exit))", 1, "exit"},
  });
}

TEST(RulesFile, WithForbiddenConstructsIsRefused) {
  for (const std::string construct : {"defclass", "defmodule", "defgeneric", "defmethod", "definstances", "defmessage-handler", "exit", "run", "batch", "nonsense"})
    expectRefused("\n(" + construct + " a b)", 2, construct + " is not allowed");
  expectRefused("(defrul a => )", 1, "defrul is not allowed");
  EXPECT_NE(faultsOf("(defrul a => )").find("Did you mean defrule?"), std::string::npos);
  expectRefused({
      {"(defrule MAIN::a => )", 1, "module"},
      {"(defrule a (logical (contact)) => )", 1, "logical"},
      {"word", 1, "outside of any construct"},
      {"((a))", 1, "does not begin with a word"},
      {"(defrule a (declare (auto-focus TRUE)) => )", 1, "Only (salience NUMBER)"},
  });
}

TEST(RulesFile, SuggestsTheNearestFunction) { EXPECT_NE(faultsOf(acting("(call-for-fir 1 smoke)")).find("Did you mean call-for-fire?"), std::string::npos); }

TEST(RulesFile, WithRecursionIsRefused) {
  expectRefused({
      {"(deffunction f (?x)\n (f ?x))", 1, "f calls itself"},
      {"(deffunction g (?x) 1)\n(deffunction f (?x) (g ?x))\n(deffunction g (?x) (f ?x))", 1, "g calls itself"},
      {"(deffunction a () 1)\n(deffunction b () (a))\n(deffunction c () (b))\n(deffunction a () (if TRUE then (c)))", 2, "b calls itself"},
  });
  EXPECT_EQ(faultsOf("(deffunction a () 1)\n(deffunction b () (a))\n(deffunction c () (b) (a))\n(defrule r => (c))"), "");
}

TEST(RulesFile, WithNamesThatAreTakenIsRefused) {
  expectRefused({
      {"(deftemplate contact (slot id))", 1, "template contact already"},
      {"(deftemplate mission (slot id))", 1, "ordered fact of the thesis"},
      {"(deffunction grade (?x) 1)", 1, "function grade already"},
      {"(deffunction str-cat (?x) 1)", 1, "function of the rule engine"},
  });
}

// ----- damaged and enormous files -----

TEST(RulesFile, OfTooManyBytesIsRefused) {
  expectRefused({
      {std::string(70000, ' '), 1, "70000 bytes long"},
      {std::string(20u << 20, '('), 1, "bytes long"},
  });
}

TEST(RulesFile, NestedTooDeepIsRefused) {
  std::string deep = "(defrule a => ";
  for (int i = 0; i < 30000; ++i) deep += "(+";
  expectRefused(deep, 1, "nested deeper than 64");
  std::string lines = "(defrule a =>\n";
  for (int i = 0; i < 100; ++i) lines += "(+ 1\n";
  expectRefused(lines, 65, "nested deeper than 64");
}

TEST(RulesFile, ThatIsNotTextIsRefused) {
  expectRefused({
      {std::string("(deffacts a)\n\0(x)", 17), 2, "control character"},
      {"(deffacts a)\n\n\x1b[2J", 3, "control character"},
      {"\xff\xfe", 1, "UTF-8"},
  });
}

TEST(RulesFile, LeftOpenIsRefusedWhereItWasOpened) {
  expectRefused({
      {"(defrule a\n =>\n (warn \"hello)\n", 3, "never closed"},
      {"(deffacts a)\n(defrule a\n =>\n", 2, "never closed"},
      {"(deffacts a))\n", 1, "no opening one"},
  });
}

TEST(RulesFile, WithSyntaxTheEngineRefusesIsReportedWithItsLine) {
  expectRefused({
      {"(deffacts ok)\n(defrule a\n  (contact (nonsense 1))\n  =>\n  (warn x))", 3, "Invalid slot nonsense"},
      {"(defrule a\n  (contact (id ?i))\n  =>\n  (bind ?x (+ 1 two)))", 4, "Function + expected argument #2"},
      {"\n(defrule a)", 2, "has no =>"},
  });
  const auto faults = checkRules("(defrule a (contact (nope 1)) => )\n(defrule b (contact (neither 1)) => )", "own.clp");
  EXPECT_EQ(faults.size(), 2u) << "every fault is reported";
}

// ----- rules that use up what they can get -----

TEST(RulesFile, ThatLoopsForEverIsRefused) {
  expectRefused({
      {acting("(while TRUE do (bind ?x 1))"), 2, "steps in one run"},
      {acting("(loop-for-count (?i 1 1000000000) do (bind ?x 1))"), 2, "steps in one run"},
      {"(deffacts n (n 0))\n(defrule a ?f <- (n ?x) => (retract ?f) (assert (n (+ ?x 1))))", 2, "fired more than 20000 times"},
  });
  expectRefused("(deffunction f0 () 1)" + [] {
    std::string chain;
    for (int i = 1; i < 20; ++i) {
      chain += "\n(deffunction f" + std::to_string(i) + " ()";
      for (int k = 0; k < 10; ++k) chain += " (f" + std::to_string(i - 1) + ")";
      chain += ")";
    }
    return chain;
  }() + "\n(defrule a => (f19))",
                21, "steps in one run");
  expectRefused(acting("(bind ?m (create$ 1 2 3 4 5 6 7 8 9 10)) (progn$ (?a ?m) (progn$ (?b ?m) (progn$ (?c ?m) (progn$ (?d ?m) (progn$ (?e ?m) (progn$ (?f ?m) (progn$ (?g ?m) (bind ?x 1))))))))"), 2,
                "steps in one run");
}

TEST(RulesFile, ThatBuildsHugeValuesIsRefused) {
  expectRefused({
      {acting("(bind ?x \"0123456789\") (while TRUE do (bind ?x (str-cat ?x ?x)))"), 2, "A text grows beyond 4096 bytes"},
      {acting("(bind ?x (create$ 1 2 3)) (while TRUE do (bind ?x (create$ ?x ?x)))"), 2, "A list grows beyond 1024 values"},
      {acting("(bind ?x (create$ 1 2 3)) (while TRUE do (bind ?x (insert$ ?x 1 ?x)))"), 2, "A list grows beyond 1024 values"},
  });
  std::string doubling = "(bind ?x \"0123456789\")";
  for (int i = 0; i < 64; ++i) doubling += "(bind ?x (sym-cat ?x ?x))";
  expectRefused(acting(doubling), 2, "A text grows beyond 4096 bytes");
}

TEST(RulesFile, ThatAssertsWithoutEndIsRefused) {
  expectRefused({
      {acting("(loop-for-count (?i 1 1000000) do (assert (junk ?i)))"), 2, "facts"},
      {"(deffacts n (n 0))\n(defrule a (n ?x) => (assert (n (+ ?x 1))))", 2, "fired more than 20000 times"},
      {acting("(loop-for-count (?i 1 40000) do (assert (junk (str-cat ?i \"" + std::string(3000, 'x') + "\"))))"), 2, "MiB of memory"},
  });
}

TEST(RulesFile, WhoseConditionsMultiplyIsRefused) {
  // 40 made-up contacts to the sixth power.
  std::string rule = "(defrule bomb\n";
  for (const char name : {'a', 'b', 'c', 'd', 'e', 'f'}) rule += std::string("  (contact (x ?") + name + "))\n";
  expectRefused(rule + "  =>\n  (warn x))", 1, "");
  std::string facts = "(deffacts junk";
  for (int i = 0; i < 60; ++i) facts += " (junk " + std::to_string(i) + ")";
  expectRefused({
      {facts + ")\n(defrule bomb (go) (junk ?) (junk ?) (junk ?) (junk ?) (junk ?) (junk ?) (junk ?) (junk ?) => (warn x))\n(defrule go => (assert (go)))", 2, ""},
      {"(defrule wild (junk $? ?a $? ?b $? ?c $?) => )", 1, "wildcards"},
  });
}

TEST(RulesFile, ThatFailsWhenItRunsIsRefusedWithItsRule) {
  expectRefused({
      {"(deffacts z (z 0))\n(defrule a (z ?x) => (bind ?y (/ 1 ?x)))", 2, "The rule a failed: Attempt to divide by zero in / function."},
      {"(deffacts z (z 0))\n(defrule a (z ?x&:(> (/ 1 ?x) 0)) => (warn x))", 2, "The rule a failed: Attempt to divide by zero"},
      {acting("(correct 99 10 10)"), 2, "argument 1 is 99, which is no mission of his"},
      {acting("(call-for-fire 3 bombard)"), 2, "argument 2 is bombard, not adjust_fire"},
      {acting("(call-for-fire 3000 smoke)"), 2, "no contact of his"},
      {acting("(loop-for-count (?i 1 2000) do (warn x))"), 2, "more than 1000 decisions in one run"},
      {"(defrule a (fire-mission (mission ?m)) => (correct ?m 1e300 0))", 1, "beyond 10000 m"},
      {"(defrule a (fire-mission (mission ?m)) => (correct ?m left 0))", 1, "is not a number of metres"},
  });
}

// ----- good rules -----

TEST(RulesFile, OfTheProgramIsWithoutFault) {
  for (const char* name : {"templates", "observer", "adjustment", "effect", "forwardobserver"}) EXPECT_EQ(faultsOf(shipped(name)), "") << name;
}

TEST(RulesFile, MayUseEveryAllowedFunction) {
  EXPECT_EQ(faultsOf("(defglobal ?*limit* = 30)\n"
                     "(deftemplate note (slot text (default none)) (multislot list))\n"
                     "(deffunction twice (?x) (bind ?y (* ?x 2)) (return ?y))\n"
                     "(deffacts notes \"a comment\" (note (text \"hello\") (list 1 2 3)) (plain 1 two \"three\"))\n"
                     "(defrule all \"a comment\"\n"
                     "  (declare (salience 5))\n"
                     "  ?n <- (note (text ?t&~none) (list $?l&:(> (length$ ?l) 2)))\n"
                     "  (or (plain 1 ?p) (plain ?p 1))\n"
                     "  (exists (plain $?))\n"
                     "  (not (and (plain 9 ?q) (plain ?q 9)))\n"
                     "  (test (and (numberp 1) (symbolp a) (stringp \"s\") (lexemep a) (integerp 1) (floatp 1.0) (not (evenp 1)) (oddp 1) (multifieldp ?l)))\n"
                     "  =>\n"
                     "  (bind ?sum 0)\n"
                     "  (progn$ (?x ?l) (bind ?sum (+ ?sum ?x)))\n"
                     "  (foreach ?x ?l (bind ?sum (+ ?sum ?x)))\n"
                     "  (loop-for-count (?i 1 3) do (bind ?sum (max ?sum (min ?i (abs (- ?i 9))))))\n"
                     "  (while (> ?sum 3) do (bind ?sum (- ?sum 1)) (if (eq ?sum 5) then (break)))\n"
                     "  (bind ?s (str-cat (upcase \"a\") (lowcase B) (sub-string 1 2 \"hello\") (sym-cat a b) (sqrt 4.0) (round 2.6) (integer 2.6) (float 3) (/ 6 4)))\n"
                     "  (if (and (<> 1 2) (!= 1 2) (neq a b) (<= 1 2) (>= 2 1) (= 1 1) (or TRUE FALSE)) then (warn ?s \" \" (str-length ?s) (str-compare a b) (str-index \"l\" \"hello\")))\n"
                     "  (warn (nth$ 1 (first$ ?l)) (length$ (rest$ ?l)) (member$ 2 ?l) (length$ (subseq$ ?l 1 2)) (length$ (insert$ ?l 1 7)) (length$ (create$ 1 2)) (twice ?*limit*))\n"
                     "  (bind ?m (duplicate ?n (text other)))\n"
                     "  (modify ?n (text none))\n"
                     "  (retract ?m))\n"),
            "");
}

TEST(RulesFile, DecidesBesideTheShippedRules) {
  EXPECT_EQ(decided(Observer::withRules("(defrule greet (contact (id ?id) (name ?n)) => (warn \"I see a \" ?n \" at \" ?id))")), "warn I see a T-72 at 3\ncall 3 fire_for_effect\n");
}

TEST(RulesFile, ReplacesShippedRulesOfTheSameName) {
  EXPECT_EQ(decided(Observer::withRules("(defrule call-on-most-dangerous (target (id ?id)) => (call-for-fire ?id smoke))")), "call 3 smoke\n");
}

TEST(RulesFile, StandsAloneWithoutTheShippedRules) {
  MindSetup setup = Observer::withRules("(defrule shoot (contact (id ?id) (type ?t)) (mission ?a ?t) => (call-for-fire ?id fire_for_effect))");
  setup.shipped_rules = false;
  EXPECT_EQ(decided(setup), "call 3 fire_for_effect\n");
}

TEST(RulesFile, WithTheFactsOfTheThesisLoadsAsItStands) {
  MindSetup setup;
  setup.rules = shipped("forwardobserver");
  setup.rules_name = "forwardobserver.clp";
  Observer observer(setup);
  observer.mind().contact(Observer::tank(3, 2000.0));
  EXPECT_EQ(Observer::told(observer.think()), "call 3 fire_for_effect\n") << "his orders come from the file";
  const auto facts = observer.mind().facts();
  EXPECT_TRUE(std::ranges::any_of(facts, [](const std::string& fact) { return fact == "(location gun1 16000 16000)"; }));
}

TEST(RulesFile, ErrorWhileThinkingIsReportedEveryTimeAndHaltsNothing) {
  // A rule that fails only for a contact the rehearsal does not know.
  Observer observer(Observer::withRules("\n(defrule trap (contact (id 4711)) => (bind ?x (/ 1 0)))"));
  observer.mind().contact(Observer::tank(1, 2000.0));
  EXPECT_EQ(Observer::told(observer.think()), "call 1 fire_for_effect\n");
  observer.mind().contact(Observer::tank(4711, 2000.0));
  std::vector<Decision> decisions;
  const auto failed = observer.mind().think(decisions);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().text().substr(0, 72), "own.clp:2: The rule trap failed: Attempt to divide by zero in / function") << failed.error().text();
  observer.mind().forget(4711);
  observer.mind().incoming(100.0);
  EXPECT_EQ(Observer::told(observer.think()), "withdraw fire falls 100 m away\n") << "later runs are not halted";
}

TEST(RulesFile, ThatLoopsOnlyInTheMissionIsStoppedThere) {
  Observer observer(Observer::withRules("(defrule trap (contact (id 4711)) => (while TRUE do (bind ?x 1)))"));
  observer.mind().contact(Observer::tank(4711, 2000.0));
  std::vector<Decision> decisions;
  const auto failed = observer.mind().think(decisions);
  ASSERT_FALSE(failed);
  EXPECT_NE(failed.error().text().find("own.clp:1: The rule trap failed: The rules loop: more than 5000000 steps in one run."), std::string::npos) << failed.error().text();
}

// ----- facts -----

TEST(ObserverFacts, OfTheThesisAreRead) {
  const auto facts = parseObserverFacts(shipped("forwardobserver"), "forwardobserver.clp");
  ASSERT_TRUE(facts) << facts.error().text();
  EXPECT_TRUE(facts->has_observer);
  EXPECT_EQ(facts->observer, (Place{25000.0, 25000.0}));
  EXPECT_EQ(facts->mounted_on, 8);
  EXPECT_EQ(facts->missions, (std::vector<MissionOrder>{{MissionAction::destroy, 51}, {MissionAction::destroy, 52}, {MissionAction::destroy, 53}}));
  ASSERT_EQ(facts->guns.size(), 4u);
  EXPECT_EQ(facts->guns[1].id, "gun2");
  EXPECT_EQ(facts->guns[1].at, (Place{25505.0, 25506.0}));
  EXPECT_TRUE(facts->only_facts);
  EXPECT_TRUE(facts->warnings.empty());
}

TEST(ObserverFacts, AreTakenBareWithAWarning) {
  const auto facts = parseObserverFacts("; as printed in the thesis\n(location observer 1.5 2)\n(mission special 51)\n", "bare.clp");
  ASSERT_TRUE(facts) << facts.error().text();
  EXPECT_EQ(facts->observer, (Place{1.5, 2.0}));
  ASSERT_EQ(facts->warnings.size(), 1u);
  EXPECT_EQ(facts->warnings[0].text().substr(0, 32), "bare.clp:2: 2 bare facts were ta");
  EXPECT_EQ(faultsOf("(location observer 1.5 2)\n(mission special 51)"), "");
}

TEST(ObserverFacts, ThatAreWrongNameTheirLine) {
  expectRefused({
      {"\n(location observer here there)", 2, "A location is a name and two numbers."},
      {"(location observer 1)", 1, "A location is a name and two numbers."},
      {"(location observer 1 nan)", 1, "A location is a name and two numbers."},
      {"(location gun1 1 2)\n(location gun1 1 2)", 2, "given twice"},
      {"(deffacts a\n (mountedon eight))", 2, "mountedon takes the index"},
      {"(mission bombard 51)", 1, "A mission is an action"},
      {"(mission destroy -1)", 1, "A mission is an action"},
      {"(mission destroy 99999999999)", 1, "A mission is an action"},
  });
}

TEST(ObserverFacts, BesideRulesAreNotFactsAlone) {
  const auto facts = parseObserverFacts("(deffacts a (mission destroy 8))\n(defrule r => )", "own.clp");
  ASSERT_TRUE(facts) << facts.error().text();
  EXPECT_FALSE(facts->only_facts);
  EXPECT_EQ(facts->missions.size(), 1u);
}

// ----- through the command line -----

TEST(CheckCommand, ReportsFaultsOfRulesWithFileAndLine) {
  const test::TemporaryFolder folder;
  test::spill(folder / "broken.clp", "(defrule a\n  =>\n  (exit))\n");
  const auto bad = test::npseeRun({"check", folder / "broken.clp"});
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_NE(bad.out.find("broken.clp:3: Rules may not use the function exit."), std::string::npos) << bad.out;
  const auto good = test::npseeRun({"check", std::string(NPSEE_SOURCE_DIR) + "/assets/rules/forwardobserver.clp"});
  EXPECT_EQ(good.exit_code, 0) << good.out << good.err;
}

TEST(CheckCommand, SurvivesRulesThatExplode) {
  const test::TemporaryFolder folder;
  test::spill(folder / "bomb.clp", "(defrule a => (while TRUE do (bind ?x 1)))");
  const auto bomb = test::npseeRun({"check", folder / "bomb.clp"});
  EXPECT_EQ(bomb.exit_code, 1);
  EXPECT_NE(bomb.out.find("bomb.clp:1: The rule a failed: The rules loop"), std::string::npos) << bomb.out;
}

}  // namespace
}  // namespace npsee::observer
