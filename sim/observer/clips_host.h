#pragma once

#include <npsee/error.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace npsee::observer {

/// CLIPS 6.30 behind one hardened wrapper: its own environment, functions it does not need removed, errors as values, and limits on
/// everything that rules can use up. Where the process has no memory left its functions throw std::bad_alloc. clips_host.cpp is the only file that knows CLIPS.

/// A word of CLIPS without quotes, as against a string.
struct Symbol {
  std::string text;
  friend bool operator==(const Symbol&, const Symbol&) = default;
};
using RuleValue = std::variant<std::int64_t, double, Symbol, std::string>;
/// The value as it is shown to people: whole numbers without a fraction, text without quotes.
std::string plainText(const RuleValue& value);

/// A value for a slot of a fact.
struct SlotValue {
  const char* slot;
  RuleValue value;
};

/// A fact of the environment; null if there is none. Only the host that made it may be given it.
using FactHandle = void*;

struct HostLimits {
  int firings = 20000;                    ///< rules fired per run: the limit rules are written against
  long long steps = 5'000'000;            ///< turns of loops, calls and firings per run
  long long joins = 20'000'000;           ///< combinations of facts tried per run by rules that count them (`kJoinCounter`)
  long memory_bytes = 64L << 20;          ///< of the environment
  long facts = 50'000;
  double cpu_s = 10.0;                    ///< of this thread per run: a watchdog for what the counts above do not see
};

/// Name of the predicate that rules_guard adds between the patterns of foreign rules; it stops joins that explode.
inline constexpr std::string_view kJoinCounter = "npsee-join";

class ClipsHost {
 public:
  /// Called by rules. What it throws becomes an error of the rule and stops the run.
  using Function = std::function<void(const std::vector<RuleValue>&)>;

  explicit ClipsHost(const HostLimits& limits = {});
  ~ClipsHost();
  ClipsHost(const ClipsHost&) = delete;
  ClipsHost& operator=(const ClipsHost&) = delete;

  /// Adds a function for rules with a number of arguments; before `load`.
  void define(std::string_view name, int least, int most, Function function);
  /// Removes every function of CLIPS that is not allowed (rules_guard.h); before `load`.
  void removeOtherFunctions();
  /// Loads constructs. The error lists every fault with file and line; the environment is then of no further use.
  Expected<void> load(const std::string& text, const std::string& file);
  /// Where rules stand, for messages.
  void place(std::string_view rule, std::string_view file, int line);
  /// Removes all facts and asserts those of deffacts constructs.
  void reset();

  /// Null if an equal fact is there already.
  FactHandle assertFact(const char* name, const std::vector<SlotValue>& slots);
  /// An ordered fact such as (mission destroy 51).
  FactHandle assertOrdered(const char* name, const std::vector<RuleValue>& values);
  /// Retracts unless rules have done so; the handle is then void.
  void retract(FactHandle fact);
  /// Whether no rule has retracted it.
  bool exists(FactHandle fact) const;

  /// Starts counting anew: forgets errors and what has been used up. Then facts are asserted, then `run`.
  void begin();
  /// Fires rules until none is left. Error kind input: a rule failed or a limit was met since `begin`, with file and line.
  Expected<void> run();
  /// The same of what has happened since `begin`, without running.
  Expected<void> outcome() const;

  /// The rule that is firing (inside a Function), or fired last.
  std::string firingRule() const;
  /// The facts it fires on, in the order of its patterns.
  std::vector<std::string> firingFacts() const;
  std::vector<std::string> facts() const;
  long memoryUsed() const;

  struct State;  ///< known to clips_host.cpp only

 private:
  std::unique_ptr<State> state_;
};

}  // namespace npsee::observer
