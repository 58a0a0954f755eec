#pragma once

#include "editor/document/file_document.h"
#include "editor/document/file_stamp.h"
#include "editor/document/history.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

namespace npsee::editor {

/// A document whose content is an immutable value, edited by replacing it and undone by going back to the one before. The content is
/// valid at every moment: an edit that would break one of its rules is refused and changes nothing.
///
/// `State` is a moment of it: a small value with `content`, a shared_ptr<const Content>, and what goes with it, such as what is
/// selected. It also says how that kind of document is made and filed: types and functions `Content`, `kWhat`, `kEnding`, `fresh()`,
/// `read(path)`, `write(content, path)`, `text(content)`, `parse(text, path)`, `folderOf(content)` (where the files lie that it names), and `settle()`, which makes the rest fit a new content.
template <class State>
class EditedDocument : public FileDocument {
 public:
  using Content = typename State::Content;

  /// New and unsaved.
  EditedDocument() : FileDocument(State::kWhat, State::kEnding) { become(State::fresh(), {}); }

  const Content& content() const { return *now_.content; }
  std::shared_ptr<const Content> snapshot() const { return now_.content; }
  std::uint64_t revision() const override { return revision_; }
  std::string text() const override { return State::text(content()); }

  /// Applies `change` to a copy and takes it over if it is valid and differs. `label` names the undo step; edits with the same
  /// nonempty `merge_key` are one step until endMerge(). Error kind usage: why the change was refused.
  Expected<void> edit(std::string_view label, std::string_view merge_key, const std::function<void(Content&)>& change) {
    Content changed = content();
    change(changed);
    if (changed == content()) return {};
    if (const auto faults = validate(changed); !faults.empty()) return fail(ErrorKind::usage, faults.front());
    record(label, merge_key);
    take(with(std::move(changed)));
    return {};
  }

  Expected<void> takeText(std::string_view text, std::string_view label, const std::filesystem::path& file = {}) override {
    auto read = State::parse(text, file.empty() ? path_ : file);
    if (!read) return tl::unexpected<Error>(std::move(read.error()));
    return edit(label, {}, [&](Content& changed) { changed = std::move(*read); });
  }

  bool dirty() const override { return now_.content != saved_ && (saved_ == nullptr || *now_.content != *saved_); }
  const BasicHistory<State>& history() const { return history_; }
  bool canUndo() const override { return history_.canUndo(); }
  bool canRedo() const override { return history_.canRedo(); }
  std::string_view undoLabel() const override { return history_.undoLabel(); }
  std::string_view redoLabel() const override { return history_.redoLabel(); }
  std::vector<std::string> undoLabels() const override { return history_.undoLabels(); }
  std::vector<std::string> redoLabels() const override { return history_.redoLabels(); }
  void endMerge() override { history_.endMerge(now_); }
  bool undo() override {
    if (!history_.canUndo()) return false;
    endMerge();
    if (history_.canUndo()) take(history_.undo(now_));
    return true;
  }
  bool redo() override {
    if (!history_.canRedo()) return false;
    take(history_.redo(now_));
    return true;
  }

  void startNew() override { become(State::fresh(), {}); }
  Expected<void> load(const std::filesystem::path& path) override {
    const FileStamp stamp = stampOf(path);  // before reading: what is written meanwhile is noticed later
    auto content = State::read(path);
    if (!content) return tl::unexpected<Error>(std::move(content.error()));
    become(std::move(*content), path);
    stamp_ = stamp;
    return {};
  }
  Expected<void> save() override {
    if (path_.empty()) return missingFile();
    return writeTo(path_);
  }
  Expected<void> saveAs(const std::filesystem::path& path) override {
    std::filesystem::path target = fileFor(path);
    if (target.filename().empty()) return missingName();
    return writeTo(std::move(target));
  }

  bool changedOutside() override {
    if (path_.empty()) return false;
    const FileStamp now = stampOf(path_);
    if (now == stamp_) return false;
    const auto held = State::read(path_);
    const bool same = held && saved_ != nullptr && *held == *saved_;
    if (same) stamp_ = now;
    return !same;
  }
  Expected<void> reload() override {
    const FileStamp now = stampOf(path_);
    auto held = State::read(path_);
    if (!held) return tl::unexpected<Error>(std::move(held.error()));
    endMerge();
    if (*held != content()) {
      record("Read from disk", {});
      take(with(std::move(*held)));
    }
    isSaved(now);
    return {};
  }
  void keepOwn() override {
    stamp_ = stampOf(path_);
    const auto held = State::read(path_);
    // A file that is gone or cannot be read holds nothing of this document.
    saved_ = held ? std::make_shared<const Content>(*held) : nullptr;
  }

 protected:
  /// The content as a file in that folder holds it, after what it needs beside it was put there. Error kind output.
  virtual Expected<Content> broughtTo(const std::filesystem::path&) const { return content(); }

  /// The present state with another content.
  State with(Content content) const {
    State out = now_;
    out.content = std::make_shared<const Content>(std::move(content));
    return out;
  }
  void record(std::string_view label, std::string_view merge_key) { history_.record(now_, label, merge_key); }
  void take(State state) {
    now_ = std::move(state);
    now_.settle();
    ++revision_;
  }

  State now_;

 private:
  void become(Content content, std::filesystem::path path) {
    now_ = {};
    take(with(std::move(content)));
    path_ = std::move(path);
    isSaved();
    history_.clear();
  }
  /// The file then holds the content, the document belongs to it, and what the content names lies beside it: what was taken from a document
  /// of another folder may not have lain there before.
  Expected<void> writeTo(std::filesystem::path target) {
    auto moved = broughtTo(target.parent_path());
    if (!moved) return tl::unexpected<Error>(std::move(moved.error()));
    if (auto done = State::write(*moved, target); !done) return done;
    if (*moved != content() || State::folderOf(*moved) != State::folderOf(content())) take(with(std::move(*moved)));
    path_ = std::move(target);
    isSaved();
    return {};
  }
  void isSaved() { isSaved(stampOf(path_)); }
  void isSaved(const FileStamp& stamp) {
    saved_ = now_.content;
    stamp_ = stamp;
  }

  std::shared_ptr<const Content> saved_;  ///< what the file holds; null once it is gone
  FileStamp stamp_;                       ///< of the file when it was last read or written
  BasicHistory<State> history_;
  std::uint64_t revision_ = 0;
};

}  // namespace npsee::editor
