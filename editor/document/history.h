#pragma once

#include <npsee/preset.h>

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <string_view>

namespace npsee::editor {

/// A moment of the edited preset: the immutable value and what was selected in it.
struct Snapshot {
  std::shared_ptr<const Preset> preset;
  int layer = 0;
};

/// Undo and redo by snapshots. Bounded: the oldest step is forgotten when there are more than `kMaxSteps`.
class History {
 public:
  static constexpr std::size_t kMaxSteps = 400;

  /// Starts over; nothing can be undone.
  void clear();

  /// Notes the state before a change. Changes with the same nonempty `merge_key` become one step until endMerge().
  void record(Snapshot before, std::string_view label, std::string_view merge_key);

  /// Ends a running merge (the mouse button was released). Drops the step when the drag came back to where it started.
  void endMerge(const Preset& now);

  bool canUndo() const { return !undo_.empty(); }
  bool canRedo() const { return !redo_.empty(); }
  std::size_t undoSteps() const { return undo_.size(); }
  std::size_t redoSteps() const { return redo_.size(); }
  /// What undo or redo would change, e.g. "Ejection angle"; empty if nothing.
  std::string_view undoLabel() const { return undo_.empty() ? std::string_view() : undo_.back().label; }
  std::string_view redoLabel() const { return redo_.empty() ? std::string_view() : redo_.back().label; }

  /// The state to go back (forward) to, `now` being kept for the way back. Only if canUndo() (canRedo()).
  Snapshot undo(Snapshot now);
  Snapshot redo(Snapshot now);

 private:
  struct Step {
    std::string label;
    Snapshot state;
  };
  std::deque<Step> undo_, redo_;
  std::string merge_key_;
};

}  // namespace npsee::editor
