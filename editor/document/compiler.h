#pragma once

#include "editor/document/moments.h"

#include <npsee/explosion.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace npsee::editor {

/// Compiles presets on a thread of its own, the newest request first; requests overtaken meanwhile are dropped.
class Compiler {
 public:
  struct Result {
    std::uint64_t revision = 0;
    Expected<std::shared_ptr<const Explosion>> explosion;
    Moments moments;  ///< of the explosion
  };

  Compiler();
  ~Compiler();
  Compiler(const Compiler&) = delete;
  Compiler& operator=(const Compiler&) = delete;

  void request(std::shared_ptr<const Preset> preset, std::uint64_t revision);
  /// A finished result that was not handed out yet. Waits up to `patience` while one is being computed, so that a small
  /// preset is redrawn in the frame that changed it.
  std::optional<Result> poll(std::chrono::milliseconds patience);
  /// True while a request is waiting or being computed.
  bool busy() const;

 private:
  void work(const std::stop_token& stop);

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::shared_ptr<const Preset> wanted_;
  std::uint64_t wanted_revision_ = 0;
  bool computing_ = false;
  std::optional<Result> done_;
  std::jthread thread_;  ///< last, so that it ends before what it uses
};

}  // namespace npsee::editor
