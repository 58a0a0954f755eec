#include <npsee/mission.h>

#include "sim/observer/engine.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace npsee {

using namespace observer;

namespace {

/// 64-bit FNV-1a of the log's lines. Source: Fowler, Noll, Vo; offset basis and prime as published.
std::string logHash(const std::vector<MissionEvent>& events) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const MissionEvent& event : events)
    for (const char c : eventJson(event) + "\n") hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace

Mission::Mission(std::unique_ptr<State> state) : state_(std::move(state)) {}
Mission::~Mission() = default;
Mission::Mission(Mission&&) noexcept = default;
Mission& Mission::operator=(Mission&&) noexcept = default;

Expected<Mission> Mission::make(const Scenario& scenario, const MissionLimits& limits) {
  auto state = std::make_unique<State>();
  state->limits = limits;
  if (auto done = state->setUp(scenario); !done) return tl::unexpected(done.error());
  return Mission(std::move(state));
}

void Mission::advance(double until_s) {
  State& s = *state_;
  const double end = s.rec.scenario.duration_s;
  // Half a tick of tolerance: 0.05 is no binary fraction.
  const auto last = static_cast<std::int64_t>(std::floor((std::clamp(until_s, 0.0, end) + 0.5 * kMissionTick_s) / kMissionTick_s));
  while (!s.rec.finished && s.tick <= last) s.step();
  if (!s.rec.finished && (s.failed || until_s >= end)) s.finish();
}

void Mission::command(const MissionCommand& command) {
  auto& list = state_->commands;
  MissionCommand timed = command;
  timed.t_s = std::max(timed.t_s, state_->now_s);
  const auto place = std::upper_bound(list.begin() + static_cast<std::ptrdiff_t>(state_->next_command), list.end(), timed,
                                      [](const MissionCommand& a, const MissionCommand& b) { return a.t_s < b.t_s; });
  list.insert(place, std::move(timed));
}

double Mission::now() const { return state_->now_s; }
bool Mission::finished() const { return state_->rec.finished; }
const Recording& Mission::recording() const { return state_->rec; }

Recording Mission::take() {
  if (!state_->rec.finished) state_->finish();
  return std::move(state_->rec);
}

void Mission::State::step() {
  const double before = now_s;
  now_s = static_cast<double>(tick) * kMissionTick_s;
  obeyCommands();
  vehicles->step(tick);
  flyShells(before, now_s);
  shootBack();
  if (!failed) sense();
  if (!failed) think();
  if (!failed) direct();
  if (!failed) fireGuns();
  if (!failed) keepLimits();
  rec.duration_s = now_s;
  ++tick;
  if (failed) finish();
}

void Mission::State::keepLimits() {
  // In every tick: the text is put together only where it is needed.
  const auto within = [&](std::size_t count, std::size_t most, std::string_view what, std::string_view remedy) {
    if (count > most && !failed) fail("The mission ends here: its recording would hold more than " + std::to_string(most) + " " + std::string(what) + ". " + std::string(remedy));
  };
  within(vehicles->legs(), limits.legs, "legs of vehicles", "Shorten its duration, or let fewer vehicles drive.");
  within(rec.shells.size(), limits.shells, "shells", "Shorten its duration, or give the guns fewer rounds.");
  within(rec.events.size(), limits.events, "events", "Shorten its duration, or take fewer observers and vehicles.");
  std::size_t beliefs = 0;
  for (const ObserverRecord& observer : rec.observers) beliefs += observer.beliefs.size();
  within(beliefs, limits.beliefs, "beliefs of observers", "Shorten its duration, or take fewer observers and vehicles.");
}

void Mission::State::finish() {
  rec.hash = logHash(rec.events);
  std::int64_t destroyed = 0;
  for (const VehicleRecord& vehicle : rec.vehicles) destroyed += vehicle.destroyedAt(now_s);
  log(EventKind::end, now_s).fields = {{"hash", rec.hash}, {"events", static_cast<std::int64_t>(rec.events.size())}, {"shells", static_cast<std::int64_t>(rec.shells.size())}, {"destroyed", destroyed}};
  rec.finished = true;
}

Expected<Recording> runMission(const Scenario& scenario, std::optional<double> until_s, const std::vector<MissionCommand>& commands, const MissionLimits& limits) {
  auto mission = Mission::make(scenario, limits);
  if (!mission) return tl::unexpected(mission.error());
  for (const MissionCommand& command : commands) mission->command(command);
  mission->advance(until_s.value_or(scenario.duration_s));
  return mission->take();
}

}  // namespace npsee
