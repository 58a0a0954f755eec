#include "sim/observer/clips_host.h"

#include "sim/core/memory_room.h"
#include "sim/observer/clips_text.h"
#include "sim/observer/rules_guard.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <deque>
#include <map>
#include <mutex>
#include <new>
#include <stdexcept>
#include <thread>

#include <locale.h>

extern "C" {
#include <clips/miscfun.h>
#include <clips/multifun.h>
}

namespace npsee::observer {
namespace {

constexpr std::size_t kMaxPrinted = 8192, kMaxTextLength = 4096, kMaxFields = 1024;

/// CPU time of this thread: a machine that is busy with other things must not end a mission.
double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// CLIPS reads numbers with strtod and writes them with sprintf, which a host may have told to expect commas. As long as this lives, this
/// thread, and no other, reads and writes as C does.
class CNumbers {
 public:
  CNumbers() : before_(uselocale(plain())) {}
  ~CNumbers() { uselocale(before_); }
  CNumbers(const CNumbers&) = delete;
  CNumbers& operator=(const CNumbers&) = delete;

 private:
  static locale_t plain() {
    static const locale_t c = newlocale(LC_ALL_MASK, "C", nullptr);
    return c;
  }
  locale_t before_;
};

}  // namespace

struct ClipsHost::State {
  struct Defined {
    State* host = nullptr;
    std::string name, restrictions;  ///< CLIPS keeps pointers to both
    Function function;
  };
  struct Place {
    std::string file;
    int line = 0;
  };

  explicit State(const HostLimits& given) : limits(given) {}

  void* env = nullptr;
  HostLimits limits;
  std::deque<Defined> functions;           ///< addresses are contexts of CLIPS functions and must stay
  std::map<std::string, Place, std::less<>> places;
  long long steps = 0, joins = 0;
  double started_s = 0.0;
  std::string printed;                     ///< errors as CLIPS printed them
  std::string stopped;                     ///< why a limit or function of ours stopped the run; the first reason stays
  std::string failing_rule;
  const defrule* last_rule = nullptr;      ///< that fired
  std::vector<Fault> parse_faults;
  std::string file;                        ///< loaded last
  bool out_of_memory = false;              ///< it works on the reserve
  int waits = 0;                           ///< for memory, one after the other

  void stop(std::string why);
  void blame(int line);
  void watch();
  std::string ruleNow() const;
  /// Throws std::bad_alloc if CLIPS was in want of memory.
  void checkMemory() const {
    if (out_of_memory) throw std::bad_alloc();
  }
};

using State = ClipsHost::State;

namespace {

State& stateOf(void* env) { return *static_cast<State*>(GetEnvironmentContext(env)); }

// ----- what CLIPS calls; nothing may throw through it -----

int wantsOutput(void*, const char* name) {
  static constexpr std::array kNames = std::to_array<std::string_view>({"stdout", "werror", "wwarning", "wdisplay", "wdialog", "wtrace", "wprompt", "wclips"});
  return std::ranges::find(kNames, std::string_view(name)) != kNames.end() ? 1 : 0;
}

int takeOutput(void* env, const char* name, const char* text) noexcept {
  try {
    State& state = stateOf(env);
    if (std::string_view(name) == "werror" && state.printed.size() < kMaxPrinted) state.printed += text;
  } catch (...) {
    SetHaltExecution(env, 1);
  }
  return 1;
}

void takeParseError(void* env, const char*, const char*, const char* error, long line) noexcept {
  try {
    State& state = stateOf(env);
    if (error == nullptr || state.parse_faults.size() >= 50) return;
    std::string what = sentence(error);
    if (what.find_first_not_of(" .") == std::string::npos) return;
    state.parse_faults.push_back({std::move(what), "docs/rules.md shows how rules are written.", state.file, static_cast<int>(line), {}});
  } catch (...) {
    SetHaltExecution(env, 1);
  }
}

void everyStep(void* env) noexcept {
  try {
    State& state = stateOf(env);
    ++state.steps;
    state.watch();
  } catch (...) {
    SetHaltExecution(env, 1);
  }
}

void noteFiring(void* env, void* fired) { stateOf(env).last_rule = static_cast<const activation*>(fired)->theRule; }

/// CLIPS needs what it asks for here, or would end the process by itself; nothing may be thrown through it. So it goes on with the
/// reserve, and whoever called it throws. Where others have used that up too, they are waited for: what they end with is memory.
int outOfMemory(void* env, std::size_t) noexcept {
  constexpr int kGoOn = 0, kMostWaits = 500;
  State& state = stateOf(env);
  SetEvaluationError(env, 1);
  SetHaltExecution(env, 1);
  if (!std::exchange(state.out_of_memory, true)) state.waits = 0;
  if (MemoryReserve::release()) return kGoOn;
  if (++state.waits > kMostWaits) {
    std::fputs("There is no memory left, not even to end the rules.\n", stderr);
    std::abort();
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return kGoOn;
}

/// An environment of CLIPS. While it is made CLIPS does not look whether it was given memory.
void* newEnvironment() {
  constexpr std::size_t kPlenty = 32u << 20;  // it takes less than one of these
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  MemoryReserve::hold();
  if (!hasRoom(kPlenty)) throw std::bad_alloc();
  void* const env = CreateEnvironment();
  if (env == nullptr) throw std::bad_alloc();
  return env;
}

/// (npsee-join LINE): true until something is used up; false lets no further combination of facts through. The argument, the line
/// of the rule, is only looked at then.
int countJoin(void* env) noexcept {
  try {
    State& state = stateOf(env);
    if (!state.stopped.empty()) return 0;
    ++state.joins;
    if (state.joins > state.limits.joins)
      state.stop("Its conditions are tried on more than " + std::to_string(state.limits.joins) + " combinations of facts in one run.");
    else if (state.joins % 1024 == 0)
      state.watch();
    if (state.stopped.empty()) return 1;
    state.blame(static_cast<int>(EnvRtnLong(env, 1)));
    return 0;
  } catch (...) {
    return 0;
  }
}

void callFunction(void* env) noexcept {
  std::string failed;
  try {
    auto& defined = *static_cast<State::Defined*>(GetEnvironmentFunctionContext(env));
    if (!defined.host->stopped.empty()) return;
    std::vector<RuleValue> arguments;
    const int count = EnvRtnArgCount(env);
    for (int i = 1; i <= count; ++i) {
      dataObject argument{};
      EnvRtnUnknown(env, i, &argument);
      if (GetEvaluationError(env) || GetHaltExecution(env)) return;
      try {
        arguments.push_back(valueOf(argument.type, argument.value));
      } catch (const std::invalid_argument& wrong) {
        defined.host->stop("(" + defined.name + " ...): argument " + std::to_string(i) + ": " + wrong.what() + ".");
        return;
      }
    }
    try {
      defined.function(arguments);
    } catch (const std::exception& wrong) {
      defined.host->stop("(" + defined.name + " ...): " + wrong.what() + ".");
    }
  } catch (...) {
    // Out of memory while saying so: the flags alone end the run.
    SetEvaluationError(env, 1);
    SetHaltExecution(env, 1);
  }
}

/// Functions of CLIPS that build longer values from shorter ones. Doubling a value a few dozen times would fill any memory between
/// two looks of the watchdog, so each result is bounded.
template <void (*Build)(void*, dataObject*)>
void bounded(void* env, dataObject* result) noexcept {
  try {
    Build(env, result);
    const bool fields = result->type == MULTIFIELD;
    const bool text = result->type == STRING || result->type == SYMBOL;
    const bool too_long = (fields && static_cast<std::size_t>(result->end - result->begin + 1) > kMaxFields) ||
                          (text && std::string_view(ValueToString(result->value)).size() > kMaxTextLength);
    if (!too_long) return;
    stateOf(env).stop(fields ? "A list grows beyond " + std::to_string(kMaxFields) + " values." : "A text grows beyond " + std::to_string(kMaxTextLength) + " bytes.");
    result->type = SYMBOL;
    result->value = EnvFalseSymbol(env);
  } catch (...) {
    SetHaltExecution(env, 1);
  }
}

template <void (*Build)(void*, dataObject*)>
void boundResult(void* env, const char* name) {
  using Raw = int (*)();
  if (FunctionDefinition* found = FindFunction(env, name)) found->functionPointer = reinterpret_cast<Raw>(reinterpret_cast<void*>(&bounded<Build>));
}

}  // namespace

void State::stop(std::string why) {
  if (stopped.empty()) {
    stopped = std::move(why);
    failing_rule = ruleNow();
  }
  SetEvaluationError(env, 1);
  SetHaltExecution(env, 1);
  EnvSetHaltRules(env, 1);
}

/// The rule on this line of the rules that are not ours.
void State::blame(int line) {
  failing_rule.clear();
  for (const auto& [name, place] : places)
    if (place.line == line && place.file == file) failing_rule = name;
}

/// Looks whether anything is used up. Time is asked seldom, it is a system call.
void State::watch() {
  if (!stopped.empty()) return stop({});
  if (steps > limits.steps) return stop("The rules loop: more than " + std::to_string(limits.steps) + " steps in one run.");
  if (EnvMemUsed(env) > limits.memory_bytes) return stop("The rules use more than " + std::to_string(limits.memory_bytes >> 20) + " MiB of memory.");
  if (static_cast<long>(GetNumberOfFacts(env)) > limits.facts) return stop("The rules hold more than " + std::to_string(limits.facts) + " facts.");
  if ((steps + joins) % 1024 == 0 && threadSeconds() - started_s > limits.cpu_s)
    stop("The rules run for more than " + numberText(limits.cpu_s) + " s; the watchdog stopped them.");
}

std::string State::ruleNow() const {
  const auto* rule = EngineData(env)->ExecutingRule;
  return rule != nullptr ? ValueToString(rule->header.name) : std::string();
}

ClipsHost::ClipsHost(const HostLimits& limits) : state_(std::make_unique<State>(limits)) {
  const CNumbers c;
  state_->env = newEnvironment();
  SetEnvironmentContext(state_->env, state_.get());
  EnvSetOutOfMemoryFunction(state_->env, &outOfMemory);
  // Below the router that collects parse errors (40), above the terminal (0).
  EnvAddRouter(state_->env, "npsee", 10, &wantsOutput, &takeOutput, nullptr, nullptr, nullptr);
  EnvSetParserErrorCallback(state_->env, &takeParseError);
  EnvAddPeriodicFunction(state_->env, "npsee", &everyStep, 0);
  EnvAddBeforeRunFunction(state_->env, "npsee", &noteFiring, 0);
  // 'b': the predicate is evaluated for every combination, so it must cost next to nothing.
  EnvDefineFunction2(state_->env, std::string(kJoinCounter).c_str(), 'b', PTIEF & countJoin, "countJoin", "11");
  begin();
}

ClipsHost::~ClipsHost() { DestroyEnvironment(state_->env); }

void ClipsHost::define(std::string_view name, int least, int most, Function function) {
  State::Defined& defined = state_->functions.emplace_back(State::Defined{state_.get(), std::string(name), std::to_string(least) + (most < 0 ? "*" : std::to_string(most)), std::move(function)});
  using Raw = int (*)(void*);
  EnvDefineFunction2WithContext(state_->env, defined.name.c_str(), 'v', reinterpret_cast<Raw>(reinterpret_cast<void*>(&callFunction)), "callFunction",
                                defined.restrictions.c_str(), &defined);
}

void ClipsHost::removeOtherFunctions() {
  std::vector<std::string> gone;
  for (FunctionDefinition* at = GetFunctionList(state_->env); at != nullptr; at = at->next) {
    const std::string_view name = at->callFunctionName->contents;
    // Names in brackets are the interpreter's own: no text can call them. expand$ is what $?x in a call becomes.
    if (name.starts_with('(') || name == "expand$" || name == kJoinCounter) continue;
    const auto known = [name](std::span<const std::string_view> names) { return std::ranges::find(names, name) != names.end(); };
    if (!known(allowedFunctions()) && !known(decisionFunctions())) gone.emplace_back(name);
  }
  for (const std::string& name : gone) UndefineFunction(state_->env, name.c_str());
  boundResult<StrCatFunction>(state_->env, "str-cat");
  boundResult<SymCatFunction>(state_->env, "sym-cat");
  boundResult<CreateFunction>(state_->env, "create$");
  boundResult<InsertFunction>(state_->env, "insert$");
}

Expected<void> ClipsHost::load(const std::string& text, const std::string& file) {
  const CNumbers c;
  begin();
  state_->file = file;
  state_->parse_faults.clear();
  EnvSetParsingFileName(state_->env, file.c_str());
  SetLineCount(state_->env, 1);
  OpenTextSource(state_->env, "npsee-rules", text.data(), 0, text.size());
  const int loaded = LoadConstructsFromLogicalName(state_->env, "npsee-rules");
  CloseStringSource(state_->env, "npsee-rules");
  state_->checkMemory();
  EnvSetParsingFileName(state_->env, nullptr);
  if (loaded == 1 && state_->parse_faults.empty() && state_->stopped.empty()) return {};
  if (state_->parse_faults.empty()) {
    std::string what = !state_->stopped.empty() ? state_->stopped : sentence(state_->printed);
    state_->parse_faults.push_back({what.empty() ? "The rules cannot be read." : std::move(what), "docs/rules.md shows how rules are written.", file, 0, {}});
  }
  return tl::unexpected(Error{ErrorKind::input, state_->parse_faults});
}

void ClipsHost::place(std::string_view rule, std::string_view file, int line) { state_->places.insert_or_assign(std::string(rule), State::Place{std::string(file), line}); }

void ClipsHost::reset() {
  const CNumbers c;
  EnvReset(state_->env);
  state_->checkMemory();
}

FactHandle ClipsHost::assertFact(const char* name, const std::vector<SlotValue>& slots) {
  const CNumbers c;
  void* found = EnvFindDeftemplate(state_->env, name);
  if (found == nullptr) return nullptr;
  fact* made = EnvCreateFact(state_->env, found);
  if (made == nullptr) return nullptr;
  for (const SlotValue& slot : slots) {
    dataObject value;
    setValue(state_->env, value, slot.value);
    EnvPutFactSlot(state_->env, made, slot.slot, &value);
  }
  EnvAssignFactSlotDefaults(state_->env, made);
  state_->checkMemory();
  void* asserted = EnvAssert(state_->env, made);
  if (asserted != nullptr) EnvIncrementFactCount(state_->env, asserted);
  state_->watch();
  return asserted;
}

FactHandle ClipsHost::assertOrdered(const char* name, const std::vector<RuleValue>& values) {
  const CNumbers c;
  std::string text = std::string("(") + name;
  for (const RuleValue& value : values) text += ' ' + plainText(value);
  void* asserted = EnvAssertString(state_->env, (text + ')').c_str());
  if (asserted != nullptr) EnvIncrementFactCount(state_->env, asserted);
  return asserted;
}

void ClipsHost::retract(FactHandle handle) {
  const CNumbers c;
  if (handle == nullptr) return;
  EnvDecrementFactCount(state_->env, handle);
  if (EnvFactExistp(state_->env, handle)) EnvRetract(state_->env, handle);
}

bool ClipsHost::exists(FactHandle fact) const { return fact != nullptr && EnvFactExistp(state_->env, fact); }

void ClipsHost::begin() {
  state_->steps = state_->joins = 0;
  state_->started_s = threadSeconds();
  state_->printed.clear();
  state_->stopped.clear();
  state_->failing_rule.clear();
  SetEvaluationError(state_->env, 0);
  SetHaltExecution(state_->env, 0);
  EnvSetHaltRules(state_->env, 0);
}

Expected<void> ClipsHost::run() {
  const CNumbers c;
  State& state = *state_;
  state.checkMemory();
  // What failed while facts were asserted (conditions of rules are evaluated then) is kept in `printed` and `stopped`.
  SetEvaluationError(state.env, 0);
  SetHaltExecution(state.env, 0);
  EnvSetHaltRules(state.env, 0);
  if (state.stopped.empty() && state.printed.empty()) {
    EnvRun(state.env, state.limits.firings);
    state.checkMemory();
    if (state.stopped.empty() && state.printed.empty() && EnvGetNextActivation(state.env, nullptr) != nullptr) {
      state.stopped = "The rules fired more than " + std::to_string(state.limits.firings) + " times in one run.";
      state.failing_rule = EnvGetActivationName(state.env, EnvGetNextActivation(state.env, nullptr));
    }
  }
  return outcome();
}

Expected<void> ClipsHost::outcome() const {
  State& state = *state_;
  if (state.stopped.empty() && state.printed.empty()) return {};
  Fault fault;
  if (state.failing_rule.empty()) {
    // "... Execution halted during the actions of defrule NAME." or "... in rule NAME".
    for (const std::string_view mark : {std::string_view("of defrule "), std::string_view("in rule ")})
      if (const auto at = state.printed.rfind(mark); at != std::string::npos && state.failing_rule.empty()) {
        const auto from = at + mark.size();
        const auto to = state.printed.find_first_of(" .\n", from);
        state.failing_rule = state.printed.substr(from, to == std::string::npos ? to : to - from);
      }
  }
  if (const auto found = state.places.find(state.failing_rule); found != state.places.end()) {
    fault.file = found->second.file;
    fault.line = found->second.line;
  }
  fault.what = state.failing_rule.empty() ? "" : "The rule " + printable(state.failing_rule) + " failed: ";
  fault.what += !state.stopped.empty() ? state.stopped : sentence(state.printed);
  fault.remedy = "Mend the rule; docs/rules.md tells what rules may do.";
  return fail(ErrorKind::input, std::move(fault));
}

std::string ClipsHost::firingRule() const { return state_->last_rule != nullptr ? ValueToString(state_->last_rule->header.name) : std::string(); }

std::vector<std::string> ClipsHost::firingFacts() const {
  std::vector<std::string> out;
  const partialMatch* basis = EngineData(state_->env)->GlobalLHSBinds;
  if (basis == nullptr) return out;
  for (unsigned i = 0; i < basis->bcount; ++i) {
    const alphaMatch* match = basis->binds[i].gm.theMatch;
    if (match != nullptr && match->matchingItem != nullptr) {
      std::string text = factText(*reinterpret_cast<const fact*>(match->matchingItem));
      if (text != "(initial-fact)") out.push_back(std::move(text));
    }
  }
  return out;
}

std::vector<std::string> ClipsHost::facts() const {
  std::vector<std::string> out;
  for (void* at = EnvGetNextFact(state_->env, nullptr); at != nullptr; at = EnvGetNextFact(state_->env, at)) {
    std::string text = factText(*static_cast<const fact*>(at));
    if (text != "(initial-fact)") out.push_back(std::move(text));
  }
  return out;
}

long ClipsHost::memoryUsed() const { return EnvMemUsed(state_->env); }

}  // namespace npsee::observer
