#include "editor/script/parser.h"

#include "sim/core/text.h"

#include <array>

namespace npsee::editor {
namespace {

constexpr std::array<ScriptCommandInfo, 23> kCommands{{
    {"set", "PARAM VALUE", 2, 2, "Types VALUE, with any fitting unit, into the parameter's row. PARAM is LAYER.key or a burst key; also `time`."},
    {"drag", "ITEM DX [DY]", 2, 3, "Presses on the item (a parameter: on its slider's thumb), moves by DX, DY pixels and releases."},
    {"click", "ITEM", 1, 1, "Clicks the middle of a named item."},
    {"doubleclick", "ITEM", 1, 1, "Clicks it twice."},
    {"rightclick", "ITEM", 1, 1, "Clicks it with the right button."},
    {"hover", "ITEM", 1, 1, "Moves the pointer onto it and waits for its tooltip."},
    {"key", "KEY[+KEY...]", 1, 1, "Presses a key with modifiers: Up, KP8, F, ctrl+shift+S."},
    {"hold", "ctrl|shift|alt", 1, 1, "Holds a modifier down over the following commands."},
    {"let", "ctrl|shift|alt", 1, 1, "Lets it go."},
    {"type", "TEXT", 1, 1, "Types the rest of the line."},
    {"clipboard", "TEXT", 0, 1, "Puts the rest of the line into the clipboard."},
    {"wait", "FRAMES", 1, 1, "Lets so many frames of 1/60 s pass."},
    {"mouse", "X Y", 2, 2, "Moves the pointer, pixels from the top left."},
    {"press", "[left|right|middle]", 0, 1, "Holds a mouse button down."},
    {"release", "[left|right|middle]", 0, 1, "Lets it go."},
    {"wheel", "STEPS", 1, 1, "Turns the wheel, up is positive."},
    {"drop", "FILE", 1, 1, "Drops a file or folder on the window."},
    {"settle", "", 0, 0, "Waits until thumbnails and exports are done."},
    {"save", "PICTURE.png", 1, 1, "Saves a picture of the whole window."},
    {"pictures", "on|off", 1, 1, "Leaves the pictures of explosions and missions out, for pictures of the panels alone."},
    {"note", "", 0, 0, "Remembers all facts, to be compared with later."},
    {"expect", "FACT OP VALUE | visible ITEM | hidden ITEM", 2, 3, "Ends the run with exit code 1 unless it holds. OP is = != < > <= >= or contains; `noted` stands for the fact's value at the last note."},
    {"print", "FACT", 1, 1, "Writes FACT=VALUE to standard output; `all` writes every fact, `items` the places and names of the items."},
}};

const ScriptCommandInfo* findCommand(std::string_view name) {
  for (const ScriptCommandInfo& command : kCommands)
    if (command.name == name) return &command;
  return nullptr;
}

/// Takes the next word off `text`; quotes hold it together. False if a quote is not closed.
bool takeWord(std::string_view& text, std::string& word) {
  text = trimmed(text);
  if (text.starts_with('"')) {
    const std::size_t end = text.find('"', 1);
    if (end == std::string_view::npos) return false;
    word = text.substr(1, end - 1);
    text.remove_prefix(end + 1);
    return true;
  }
  const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
  word = text.substr(0, end);
  text.remove_prefix(end);
  return true;
}

/// Arguments of one line; the last possible one takes the rest of it.
bool takeArguments(std::string_view rest, const ScriptCommandInfo& info, std::vector<std::string>& out) {
  for (rest = trimmed(rest); !rest.empty(); rest = trimmed(rest)) {
    const bool last = static_cast<int>(out.size()) + 1 >= info.most;
    std::string word;
    if (last && !rest.starts_with('"')) {
      word = rest;
      rest = {};
    } else if (!takeWord(rest, word)) {
      return false;
    }
    out.push_back(std::move(word));
  }
  return true;
}

Fault faultAt(std::string_view file, int line, std::string what, std::string remedy) {
  return {.what = std::move(what), .remedy = std::move(remedy), .file = std::string(file), .line = line, .pointer = {}};
}

}  // namespace

std::span<const ScriptCommandInfo> scriptCommands() { return kCommands; }

Expected<std::vector<ScriptCommand>> parseScript(std::string_view text, std::string_view file) {
  std::vector<ScriptCommand> out;
  std::vector<Fault> faults;
  int line_number = 0;
  for (const std::string_view raw : splitAt(text, '\n')) {
    ++line_number;
    std::string_view rest = trimmed(raw);
    if (rest.empty() || rest.starts_with('#')) continue;
    ScriptCommand command{.name = {}, .arguments = {}, .line = line_number};
    takeWord(rest, command.name);
    const ScriptCommandInfo* info = findCommand(command.name);
    if (info == nullptr) {
      const auto names = namesOf(kCommands, &ScriptCommandInfo::name);
      const auto near = nearest(command.name, names);
      faults.push_back(faultAt(file, line_number, "there is no command \"" + printable(command.name) + "\".", near ? "Did you mean " + std::string(*near) + "?" : "The commands are " + listed(names) + "."));
      continue;
    }
    const bool closed = takeArguments(rest, *info, command.arguments);
    const int count = static_cast<int>(command.arguments.size());
    if (!closed) faults.push_back(faultAt(file, line_number, "a quote is not closed.", ""));
    else if (count < info->least || count > info->most)
      faults.push_back(faultAt(file, line_number, command.name + " has " + std::to_string(count) + (count == 1 ? " argument." : " arguments."), "Write: " + command.name + ' ' + std::string(info->arguments)));
    else if (command.name == "key") {
      if (const auto stroke = parseKeyStroke(command.arguments.front()); !stroke) faults.push_back(faultAt(file, line_number, stroke.error().faults.front().what, stroke.error().faults.front().remedy));
    }
    out.push_back(std::move(command));
  }
  if (!faults.empty()) return tl::unexpected<Error>(Error{ErrorKind::input, std::move(faults)});
  return out;
}

}  // namespace npsee::editor
