#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace npsee::editor {

/// Undo and redo by snapshots: small values that hold the immutable document and what was selected in it. `sameContent(a, b)`,
/// found beside the snapshot's type, tells whether two of them differ in what is saved. Bounded: the oldest step is forgotten when
/// there are more than `kMaxSteps`.
template <class State>
class BasicHistory {
 public:
  static constexpr std::size_t kMaxSteps = 400;

  /// Starts over; nothing can be undone.
  void clear() {
    undo_.clear();
    redo_.clear();
    merge_key_.clear();
  }

  /// Notes the state before a change. Changes with the same nonempty `merge_key` become one step until endMerge().
  void record(State before, std::string_view label, std::string_view merge_key) {
    redo_.clear();
    const bool merges = !merge_key.empty() && merge_key == merge_key_ && !undo_.empty();
    merge_key_ = merge_key;
    if (merges) return;
    undo_.push_back({std::string(label), std::move(before)});
    if (undo_.size() > kMaxSteps) undo_.pop_front();
  }

  /// Ends a running merge (the mouse button was released). Drops the step when the drag came back to where it started.
  void endMerge(const State& now) {
    if (merge_key_.empty()) return;
    merge_key_.clear();
    if (!undo_.empty() && sameContent(undo_.back().state, now)) undo_.pop_back();
  }

  bool canUndo() const { return !undo_.empty(); }
  bool canRedo() const { return !redo_.empty(); }
  std::size_t undoSteps() const { return undo_.size(); }
  std::size_t redoSteps() const { return redo_.size(); }
  /// What undo or redo would change, e.g. "Ejection angle"; empty if nothing.
  std::string_view undoLabel() const { return undo_.empty() ? std::string_view() : undo_.back().label; }
  std::string_view redoLabel() const { return redo_.empty() ? std::string_view() : redo_.back().label; }

  /// What each step changed: those that can be undone, oldest first, and those that can be redone, next first.
  std::vector<std::string> undoLabels() const {
    std::vector<std::string> out;
    for (const Step& step : undo_) out.push_back(step.label);
    return out;
  }
  std::vector<std::string> redoLabels() const {
    std::vector<std::string> out;
    for (auto step = redo_.rbegin(); step != redo_.rend(); ++step) out.push_back(step->label);
    return out;
  }

  /// The state that `back` undos lead to, 1 to undoSteps(), without going there.
  const State& undoState(std::size_t back) const { return undo_[undo_.size() - back].state; }

  /// The state to go back (forward) to, `now` being kept for the way back. Only if canUndo() (canRedo()).
  State undo(State now) { return step(undo_, redo_, std::move(now)); }
  State redo(State now) { return step(redo_, undo_, std::move(now)); }

 private:
  struct Step {
    std::string label;
    State state;
  };

  State step(std::deque<Step>& from, std::deque<Step>& to, State now) {
    merge_key_.clear();
    Step step = std::move(from.back());
    from.pop_back();
    std::swap(step.state, now);
    to.push_back(std::move(step));
    return now;
  }

  std::deque<Step> undo_, redo_;
  std::string merge_key_;
};

}  // namespace npsee::editor
