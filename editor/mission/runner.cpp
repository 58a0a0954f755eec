#include "editor/mission/runner.h"

#include <algorithm>
#include <utility>

namespace npsee::editor {
namespace {

using Clock = std::chrono::steady_clock;

/// Simulated seconds between two looks for something newer.
constexpr double kSlice_s = 1.0;
/// A running simulation is shown now and then, seldom enough that copying it costs little beside simulating.
constexpr std::chrono::milliseconds kShowEvery{200};
constexpr int kCopyShare = 8;

}  // namespace

MissionRunner::MissionRunner() : thread_([this](const std::stop_token& stop) { work(stop); }) {}

MissionRunner::~MissionRunner() = default;

void MissionRunner::request(Request request) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = std::move(request);
  }
  changed_.notify_all();
}

std::optional<MissionRunner::Result> MissionRunner::poll(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience, [this] { return (done_ && done_->complete) || (!wanted_ && !computing_); });
  return std::exchange(done_, std::nullopt);
}

bool MissionRunner::busy() const {
  const std::lock_guard lock(mutex_);
  return wanted_.has_value() || computing_;
}

double MissionRunner::reached() const {
  const std::lock_guard lock(mutex_);
  return reached_s_;
}

bool MissionRunner::overtaken() const {
  const std::lock_guard lock(mutex_);
  return wanted_.has_value();
}

bool MissionRunner::continues(const Request& request) const {
  if (!mission_ || scenario_ != request.scenario || request.commands->size() < given_.size()) return false;
  if (!std::equal(given_.begin(), given_.end(), request.commands->begin())) return false;
  // A mission that has ended takes no more commands, and one that is ahead of a command has already lived without it.
  const bool more = request.commands->size() > given_.size();
  if (more && mission_->finished()) return false;
  return std::all_of(request.commands->begin() + static_cast<std::ptrdiff_t>(given_.size()), request.commands->end(),
                     [this](const MissionCommand& command) { return command.t_s > mission_->now(); });
}

Expected<void> MissionRunner::begin(const Request& request) {
  if (!continues(request)) {
    mission_.reset();
    given_.clear();
    scenario_ = request.scenario;
    auto made = Mission::make(*request.scenario);
    if (!made) return tl::unexpected<Error>(std::move(made.error()));
    mission_.emplace(std::move(*made));
  }
  for (std::size_t i = given_.size(); i < request.commands->size(); ++i) mission_->command((*request.commands)[i]);
  given_ = *request.commands;
  return {};
}

void MissionRunner::publish(const Request& request, bool complete) {
  auto copy = std::make_shared<const Recording>(mission_->recording());
  {
    const std::lock_guard lock(mutex_);
    done_ = Result{request.number, std::move(copy), complete};
  }
  changed_.notify_all();
}

void MissionRunner::simulate(const Request& request, const std::stop_token& stop) {
  auto shown = Clock::now();
  Clock::duration copying{};
  while (!stop.stop_requested() && !overtaken()) {
    mission_->advance(std::min(request.until_s, mission_->now() + kSlice_s));
    const bool complete = mission_->finished() || mission_->now() + 0.5 * kMissionTick_s >= request.until_s;
    {
      const std::lock_guard lock(mutex_);
      reached_s_ = mission_->now();
    }
    if (complete) return publish(request, true);
    const auto now = Clock::now();
    if (now - shown < std::max<Clock::duration>(kShowEvery, kCopyShare * copying)) continue;
    publish(request, false);
    shown = Clock::now();
    copying = shown - now;
  }
}

void MissionRunner::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return wanted_.has_value(); })) {
    const Request request = *std::exchange(wanted_, std::nullopt);
    computing_ = true;
    lock.unlock();
    auto begun = begin(request);
    if (begun) simulate(request, stop);
    lock.lock();
    if (!begun) done_ = Result{request.number, tl::unexpected<Error>(std::move(begun.error())), true};
    computing_ = false;
    changed_.notify_all();
  }
}

}  // namespace npsee::editor
