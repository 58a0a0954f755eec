#include "editor/document/compiler.h"

#include <utility>

namespace npsee::editor {

Compiler::Compiler() : thread_([this](const std::stop_token& stop) { work(stop); }) {}

Compiler::~Compiler() = default;

void Compiler::request(std::shared_ptr<const Preset> preset) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = std::move(preset);
  }
  changed_.notify_all();
}

void Compiler::requestProbe(std::shared_ptr<const Preset> preset, int layer, std::size_t most) {
  {
    const std::lock_guard lock(mutex_);
    probe_wanted_ = ProbeWish{std::move(preset), layer, most};
  }
  changed_.notify_all();
}

std::optional<Compiler::Result> Compiler::poll(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience, [this] { return done_ || (!wanted_ && !compiling_); });
  return std::exchange(done_, std::nullopt);
}

std::optional<Compiler::Result> Compiler::pollAll() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return done_ || idle(); });
  return std::exchange(done_, std::nullopt);
}

bool Compiler::busy() const {
  const std::lock_guard lock(mutex_);
  return wanted_ != nullptr || compiling_;
}

void Compiler::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  const auto result = [this]() -> Result& { return done_ ? *done_ : done_.emplace(); };
  while (changed_.wait(lock, stop, [this] { return wanted_ || probe_wanted_ || moments_of_; })) {
    if (wanted_) {
      const auto preset = std::exchange(wanted_, nullptr);
      compiling_ = true;
      lock.unlock();
      auto explosion = Explosion::compile(*preset);
      lock.lock();
      compiling_ = false;
      moments_of_ = explosion ? *explosion : nullptr;
      result().explosion = std::move(explosion);
      result().moments.reset();
    } else {
      const auto wish = std::exchange(probe_wanted_, std::nullopt);
      const auto explosion = wish ? nullptr : std::exchange(moments_of_, nullptr);
      working_ = true;
      lock.unlock();
      std::optional<LaunchProbe> probe;
      std::optional<Moments> moments;
      if (wish) probe = probeLaunch(*wish->preset, wish->layer, wish->most);
      else moments = momentsOf(*explosion);
      lock.lock();
      working_ = false;
      // What is wanted anew by now is not worth showing.
      if (probe && !probe_wanted_) result().probe = std::move(probe);
      if (moments && !wanted_) result().moments = moments;
    }
    changed_.notify_all();
  }
}

}  // namespace npsee::editor
