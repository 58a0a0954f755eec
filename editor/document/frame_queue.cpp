#include "editor/document/frame_queue.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace npsee::editor {

FrameQueue::FrameQueue(unsigned fields) : fields_(fields), thread_([this](const std::stop_token& stop) { work(stop); }) {}

FrameQueue::~FrameQueue() = default;

void FrameQueue::plan(std::shared_ptr<const Explosion> explosion, const std::vector<double>& times_s) {
  {
    const std::lock_guard lock(mutex_);
    const bool other = explosion != explosion_;
    explosion_ = std::move(explosion);
    // What is being evaluated stays until it is finished; its result is dropped then, if nobody wants it.
    std::erase_if(slots_, [&](std::unique_ptr<Slot>& slot) {
      const bool wanted = !other && std::ranges::find(times_s, slot->time_s) != times_s.end();
      if (wanted || slot->state == Slot::State::working) return false;
      spare_.push_back(std::move(slot->frame));
      return true;
    });
    for (const double time : times_s) {
      if (std::ranges::any_of(slots_, [&](const auto& slot) { return slot->time_s == time; })) continue;
      auto slot = std::make_unique<Slot>();
      slot->time_s = time;
      if (!spare_.empty()) {
        slot->frame = std::move(spare_.back());
        spare_.pop_back();
      }
      slots_.push_back(std::move(slot));
    }
    if (spare_.size() > kFramesAhead) spare_.resize(kFramesAhead);
  }
  changed_.notify_all();
}

bool FrameQueue::take(const Explosion* explosion, double time_s, Frame& frame) {
  std::unique_lock lock(mutex_);
  if (explosion_.get() != explosion) return false;
  const auto mine = [&] { return std::ranges::find_if(slots_, [&](const auto& slot) { return slot->time_s == time_s; }); };
  auto slot = mine();
  // What has not been begun is faster done by whoever asks.
  if (slot == slots_.end() || (*slot)->state == Slot::State::wanted) return false;
  changed_.wait(lock, [&] { return (slot = mine()) == slots_.end() || (*slot)->state == Slot::State::done; });
  if (slot == slots_.end()) return false;
  std::swap(frame, (*slot)->frame);
  spare_.push_back(std::move((*slot)->frame));
  slots_.erase(slot);
  return true;
}

FrameQueue::Slot* FrameQueue::next() {
  const auto slot = std::ranges::find_if(slots_, [](const auto& s) { return s->state == Slot::State::wanted; });
  return slot == slots_.end() ? nullptr : slot->get();
}

void FrameQueue::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return next() != nullptr; })) {
    Slot* const slot = next();
    slot->state = Slot::State::working;
    const auto explosion = explosion_;
    lock.unlock();
    explosion->at(slot->time_s, slot->frame, fields_, 1);
    lock.lock();
    // Of another explosion by now: nobody may take it for one of the new.
    if (explosion != explosion_) std::erase_if(slots_, [&](const auto& held) { return held.get() == slot; });
    else slot->state = Slot::State::done;
    changed_.notify_all();
  }
}

double onGrid(double time_s, double step_s) { return step_s > 0.0 ? std::round(time_s / step_s) * step_s : time_s; }

}  // namespace npsee::editor
