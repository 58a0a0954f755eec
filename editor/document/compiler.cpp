#include "editor/document/compiler.h"

#include <utility>

namespace npsee::editor {

Compiler::Compiler() : thread_([this](const std::stop_token& stop) { work(stop); }) {}

Compiler::~Compiler() = default;

void Compiler::request(std::shared_ptr<const Preset> preset, std::uint64_t revision) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = std::move(preset);
    wanted_revision_ = revision;
  }
  changed_.notify_all();
}

std::optional<Compiler::Result> Compiler::poll(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience, [this] { return done_ || (!wanted_ && !computing_); });
  return std::exchange(done_, std::nullopt);
}

bool Compiler::busy() const {
  const std::lock_guard lock(mutex_);
  return wanted_ != nullptr || computing_;
}

void Compiler::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return wanted_ != nullptr; })) {
    const auto preset = std::exchange(wanted_, nullptr);
    const std::uint64_t revision = wanted_revision_;
    computing_ = true;
    lock.unlock();
    auto explosion = Explosion::compile(*preset);
    const Moments moments = explosion ? momentsOf(**explosion) : Moments();
    lock.lock();
    computing_ = false;
    done_ = Result{revision, std::move(explosion), moments};
    changed_.notify_all();
  }
}

}  // namespace npsee::editor
