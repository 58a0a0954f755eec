#pragma once

#include <npsee/explosion.h>

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace npsee::editor {

/// The next frames of an explosion that is played, evaluated on a thread of its own while the present one is drawn: the thesis's producer and
/// consumer. A cache: what it hands out is what `Explosion::at` gives.
class FrameQueue {
 public:
  explicit FrameQueue(unsigned fields);
  ~FrameQueue();
  FrameQueue(const FrameQueue&) = delete;
  FrameQueue& operator=(const FrameQueue&) = delete;

  /// The moments that will be shown next, in order. What was asked for before and is not among them is dropped.
  void plan(std::shared_ptr<const Explosion> explosion, const std::vector<double>& times_s);
  /// Gives the frame of a moment, waiting while it is being evaluated, and takes the old one's memory. False if it is not in the queue.
  bool take(const Explosion* explosion, double time_s, Frame& frame);

 private:
  struct Slot {
    double time_s = 0.0;
    enum class State { wanted, working, done } state = State::wanted;
    Frame frame;
  };
  void work(const std::stop_token& stop);
  Slot* next();

  const unsigned fields_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::shared_ptr<const Explosion> explosion_;
  std::deque<std::unique_ptr<Slot>> slots_;
  std::vector<Frame> spare_;  ///< memory to be used again
  std::jthread thread_;       ///< last, so that it ends before what it uses
};

/// Frames that are worth keeping ahead of the one shown, and what they may hold in all.
inline constexpr int kFramesAhead = 3;
inline constexpr std::size_t kMostQueuedParticles = 600'000;

/// The moment shown while playing: on a grid of `step_s`, so that the next ones are known before.
double onGrid(double time_s, double step_s);

}  // namespace npsee::editor
