#pragma once

#include "editor/document/launch_probe.h"
#include "editor/document/moments.h"

#include <npsee/explosion.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace npsee::editor {

/// Compiles presets on a thread of its own, the newest request first; requests overtaken meanwhile are dropped. What is only shown beside the
/// picture (a layer's launch, the marks of the time line) is found after the explosion was handed out, and given up for a newer one.
class Compiler {
 public:
  /// What has been found since the last one.
  struct Result {
    std::optional<Expected<std::shared_ptr<const Explosion>>> explosion;
    std::optional<LaunchProbe> probe;  ///< as wanted last
    std::optional<Moments> moments;    ///< of the explosion handed out last
  };

  Compiler();
  ~Compiler();
  Compiler(const Compiler&) = delete;
  Compiler& operator=(const Compiler&) = delete;

  void request(std::shared_ptr<const Preset> preset);
  /// The first `most` particles of a layer; it may be another preset's than the one compiled.
  void requestProbe(std::shared_ptr<const Preset> preset, int layer, std::size_t most);
  /// A finished result that was not handed out yet. Waits up to `patience` while an explosion is being compiled, so that a small preset is
  /// redrawn in the frame that changed it.
  std::optional<Result> poll(std::chrono::milliseconds patience);
  /// The same for whoever wants all there is: waits until something is finished or nothing is left to do.
  std::optional<Result> pollAll();
  /// True while an explosion is wanted or being compiled.
  bool busy() const;

 private:
  struct ProbeWish {
    std::shared_ptr<const Preset> preset;
    int layer = 0;
    std::size_t most = 0;
  };
  void work(const std::stop_token& stop);
  bool idle() const { return !wanted_ && !compiling_ && !working_ && !probe_wanted_ && !moments_of_; }

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::shared_ptr<const Preset> wanted_;
  std::optional<ProbeWish> probe_wanted_;
  std::shared_ptr<const Explosion> moments_of_;  ///< still to be found
  bool compiling_ = false, working_ = false;     ///< at an explosion; at something else
  std::optional<Result> done_;
  std::jthread thread_;  ///< last, so that it ends before what it uses
};

}  // namespace npsee::editor
