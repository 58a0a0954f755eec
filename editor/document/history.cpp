#include "editor/document/history.h"

#include <utility>

namespace npsee::editor {

void History::clear() {
  undo_.clear();
  redo_.clear();
  merge_key_.clear();
}

void History::record(Snapshot before, std::string_view label, std::string_view merge_key) {
  redo_.clear();
  const bool merges = !merge_key.empty() && merge_key == merge_key_ && !undo_.empty();
  merge_key_ = merge_key;
  if (merges) return;
  undo_.push_back({std::string(label), std::move(before)});
  if (undo_.size() > kMaxSteps) undo_.pop_front();
}

void History::endMerge(const Preset& now) {
  if (merge_key_.empty()) return;
  merge_key_.clear();
  if (!undo_.empty() && *undo_.back().state.preset == now) undo_.pop_back();
}

Snapshot History::undo(Snapshot now) {
  merge_key_.clear();
  Step step = std::move(undo_.back());
  undo_.pop_back();
  std::swap(step.state, now);
  redo_.push_back(std::move(step));
  return now;
}

Snapshot History::redo(Snapshot now) {
  merge_key_.clear();
  Step step = std::move(redo_.back());
  redo_.pop_back();
  std::swap(step.state, now);
  undo_.push_back(std::move(step));
  return now;
}

}  // namespace npsee::editor
