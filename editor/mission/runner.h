#pragma once

#include <npsee/mission.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace npsee::editor {

/// Simulates missions on a thread of its own, the newest request first. A request that only goes on from where the last one
/// stopped (the same scenario, further commands that lie ahead, a later end) continues it; every other one starts from the
/// beginning, which is the same to the bit because a mission is a function of scenario and commands. The mission itself never
/// leaves the thread: what is handed out are copies, which nobody changes any more.
class MissionRunner {
 public:
  struct Request {
    std::uint64_t number = 0;  ///< handed back with the result
    std::shared_ptr<const Scenario> scenario;
    std::shared_ptr<const std::vector<MissionCommand>> commands;
    double until_s = 0.0;
  };
  struct Result {
    std::uint64_t number = 0;
    Expected<std::shared_ptr<const Recording>> recording;
    bool complete = false;  ///< reached its `until_s`, or failed
  };

  MissionRunner();
  ~MissionRunner();
  MissionRunner(const MissionRunner&) = delete;
  MissionRunner& operator=(const MissionRunner&) = delete;

  void request(Request request);
  /// A result not handed out yet: complete, or how far it has come. Waits up to `patience` for a complete one.
  std::optional<Result> poll(std::chrono::milliseconds patience);
  /// True while a request is waiting or being simulated.
  bool busy() const;
  /// How far the present simulation has come, s.
  double reached() const;

 private:
  void work(const std::stop_token& stop);
  bool continues(const Request& request) const;
  Expected<void> begin(const Request& request);
  void simulate(const Request& request, const std::stop_token& stop);
  void publish(const Request& request, bool complete);
  bool overtaken() const;

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::optional<Request> wanted_;
  bool computing_ = false;
  double reached_s_ = 0.0;
  std::optional<Result> done_;

  // Only the worker touches these.
  std::optional<Mission> mission_;
  std::shared_ptr<const Scenario> scenario_;
  std::vector<MissionCommand> given_;

  std::jthread thread_;  ///< last, so that it ends before what it uses
};

}  // namespace npsee::editor
