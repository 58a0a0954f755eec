#pragma once

#include <npsee/error.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace npsee::editor {

/// How the files of each kind end: by that they are listed, and opened as what they are.
inline constexpr std::string_view kPresetEnding = ".npsee.json", kMissionEnding = ".mission.json";

/// What the session does with any document, whatever is in it: file, unsaved work, undo and redo.
class FileDocument {
 public:
  /// `what` names the kind in messages ("preset"), `ending` its files (".npsee.json").
  FileDocument(std::string_view what, std::string_view ending) : what_(what), ending_(ending) {}
  virtual ~FileDocument() = default;

  /// Path of the file, empty for a document never saved.
  const std::filesystem::path& path() const { return path_; }
  /// File name without its ending, or "untitled".
  std::string name() const;
  std::string_view ending() const { return ending_; }
  /// The file that saving as `path` writes. It has the kind's ending, whatever is typed: with another one it could not be opened again.
  std::filesystem::path fileFor(const std::filesystem::path& path) const;

  /// True if the content differs from what the file holds.
  virtual bool dirty() const = 0;
  virtual bool canUndo() const = 0;
  virtual bool canRedo() const = 0;
  /// False if there was nothing to undo or redo.
  virtual bool undo() = 0;
  virtual bool redo() = 0;
  /// What undo or redo would change, e.g. "Ejection angle"; empty if nothing.
  virtual std::string_view undoLabel() const = 0;
  virtual std::string_view redoLabel() const = 0;
  /// What can be undone, oldest first, and redone, next first.
  virtual std::vector<std::string> undoLabels() const = 0;
  virtual std::vector<std::string> redoLabels() const = 0;
  /// Goes back (negative) or forward by so many steps, as far as there are any.
  void jump(int steps);
  /// A drag is over: what it changed is one step.
  virtual void endMerge() = 0;

  /// Differs after every change, undo and load included.
  virtual std::uint64_t revision() const = 0;
  /// The content as a file holds it.
  virtual std::string text() const = 0;
  /// Takes over the content of such a text as one step, named `label`. What it names lies beside `file`, or beside the document's own where that
  /// is empty. Error kinds input and usage.
  virtual Expected<void> takeText(std::string_view text, std::string_view label, const std::filesystem::path& file = {}) = 0;

  /// True if the file on the disk holds something else than what was last read from it or written to it.
  virtual bool changedOutside() = 0;
  /// Reads the file again, as a step that can be undone. Errors leave the document as it was.
  virtual Expected<void> reload() = 0;
  /// The document stays as it is; the file as it now is counts as known, and saving replaces it.
  virtual void keepOwn() = 0;

  virtual void startNew() = 0;
  /// Errors leave the document as it was. Kinds input and output.
  virtual Expected<void> load(const std::filesystem::path& path) = 0;
  virtual Expected<void> save() = 0;
  /// Saves to fileFor(path), to which the document then belongs.
  virtual Expected<void> saveAs(const std::filesystem::path& path) = 0;

 protected:
  Expected<void> missingFile() const;
  static Expected<void> missingName();

  std::filesystem::path path_;

 private:
  std::string_view what_, ending_;
};

}  // namespace npsee::editor
