#include "editor/document/shelf.h"

namespace npsee::editor {

Shelf::~Shelf() = default;

void Shelf::request(const Presets& presets) {
  if (presets == asked_) return;
  asked_ = presets;
  shown_.assign(presets.size(), nullptr);
  faults_.assign(presets.size(), {});
  {
    const std::lock_guard lock(mutex_);
    wanted_ = presets;
    done_.assign(presets.size(), nullptr);
    failed_.assign(presets.size(), {});
    next_ = 0;
    ++generation_;
  }
  if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
  changed_.notify_all();
}

void Shelf::poll(bool wait) {
  std::unique_lock lock(mutex_);
  if (wait) changed_.wait(lock, [this] { return next_ >= wanted_.size() && !computing_; });
  shown_ = done_;
  faults_ = failed_;
}

bool Shelf::busy() const {
  const std::lock_guard lock(mutex_);
  return next_ < wanted_.size() || computing_;
}

const std::shared_ptr<const Explosion>& Shelf::at(std::size_t index) const {
  static const std::shared_ptr<const Explosion> kNone;
  return index < shown_.size() ? shown_[index] : kNone;
}

const std::string& Shelf::fault(std::size_t index) const {
  static const std::string kNone;
  return index < faults_.size() ? faults_[index] : kNone;
}

void Shelf::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return next_ < wanted_.size(); }) && !stop.stop_requested()) {
    const std::size_t index = next_++, generation = generation_;
    const auto preset = wanted_[index];
    computing_ = true;
    lock.unlock();
    auto explosion = preset != nullptr ? Explosion::compile(*preset) : Expected<std::shared_ptr<const Explosion>>(nullptr);
    lock.lock();
    computing_ = false;
    if (generation == generation_ && explosion) done_[index] = std::move(*explosion);
    else if (generation == generation_) failed_[index] = explosion.error().text();
    changed_.notify_all();
  }
}

}  // namespace npsee::editor
