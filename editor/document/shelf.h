#pragma once

#include <npsee/explosion.h>

#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace npsee::editor {

/// Compiles a set of presets on a thread of its own, one after the other; a new set replaces the one under way. The thread starts with the first
/// request.
class Shelf {
 public:
  using Presets = std::vector<std::shared_ptr<const Preset>>;
  Shelf() = default;
  ~Shelf();
  Shelf(const Shelf&) = delete;
  Shelf& operator=(const Shelf&) = delete;

  /// The same presets again change nothing.
  void request(const Presets& presets);
  /// Takes what is finished; `wait` until all is.
  void poll(bool wait);
  bool busy() const;
  /// What became of a preset; null while it is not finished, or where it cannot be compiled.
  const std::shared_ptr<const Explosion>& at(std::size_t index) const;
  /// Why a preset cannot be compiled; empty while it is not known.
  const std::string& fault(std::size_t index) const;

 private:
  void work(const std::stop_token& stop);

  Presets asked_;
  std::vector<std::shared_ptr<const Explosion>> shown_;
  std::vector<std::string> faults_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  Presets wanted_;
  std::size_t next_ = 0;           ///< of what is wanted, still to be compiled
  std::size_t generation_ = 0;
  bool computing_ = false;
  std::vector<std::shared_ptr<const Explosion>> done_;
  std::vector<std::string> failed_;  ///< reasons
  std::jthread thread_;  ///< last, so that it ends before what it uses
};

}  // namespace npsee::editor
