#include "sim/core/json_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace npsee {
namespace {

using nlohmann::ordered_json;

int lineAt(std::string_view text, std::size_t offset) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size())), '\n'));
}

/// Walks well-formed JSON and notes on which line each value begins, and keys given twice. The parser keeps no places.
class Scanner {
 public:
  Scanner(std::string_view text, std::unordered_map<std::string, int>& lines) : text_(text), lines_(lines) {}

  void run() { value(""); }
  const std::vector<std::pair<std::string, int>>& repeated() const { return repeated_; }

 private:
  void space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r' || text_[at_] == '\n')) {
      if (text_[at_] == '\n') ++line_;
      ++at_;
    }
  }

  char peek() {
    space();
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  std::string_view string() {
    const std::size_t begin = at_++;
    while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    if (at_ < text_.size()) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  // Recursion is bounded: the nesting was checked before.
  void value(const std::string& pointer) {
    const char first = peek();
    lines_.emplace(pointer, line_);
    if (first == '{') {
      object(pointer);
    } else if (first == '[') {
      array(pointer);
    } else if (first == '"') {
      string();
    } else {
      while (at_ < text_.size() && std::string_view(",]} \t\r\n").find(text_[at_]) == std::string_view::npos) ++at_;
    }
  }

  void object(const std::string& pointer) {
    ++at_;
    while (peek() == '"') {
      const int key_line = line_;
      const std::string key = ordered_json::parse(string()).get<std::string>();
      const std::string child = pointer + '/' + pointerToken(key);
      if (lines_.contains(child)) repeated_.emplace_back(child, key_line);
      peek();
      ++at_;  // the colon
      value(child);
      if (peek() == ',') ++at_;
    }
    ++at_;
  }

  void array(const std::string& pointer) {
    ++at_;
    for (std::size_t index = 0; peek() != ']' && peek() != '\0'; ++index) {
      value(pointer + '/' + std::to_string(index));
      if (peek() == ',') ++at_;
    }
    ++at_;
  }

  std::string_view text_;
  std::unordered_map<std::string, int>& lines_;
  std::vector<std::pair<std::string, int>> repeated_;
  std::size_t at_ = 0;
  int line_ = 1;
};

/// Offset at which the nesting first exceeds the limit, or npos.
std::size_t tooDeepAt(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      else if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kMaxJsonDepth) return i;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return std::string_view::npos;
}

/// The parser's own words without its exception number and position, which we give ourselves.
std::string parserReason(std::string message) {
  if (const std::size_t colon = message.find(": "); message.starts_with("[json") && colon != std::string::npos) message.erase(0, colon + 2);
  if (const std::size_t last_read = message.find("; last read: "); last_read != std::string::npos) {
    const std::string rest = message.substr(last_read + 13);
    message.erase(last_read);
    message += " near " + rest.substr(0, 60);
  }
  return message;
}

Fault faultAt(std::string_view file, int line, std::string what, std::string remedy) {
  return {.what = std::move(what), .remedy = std::move(remedy), .file = std::string(file), .line = line, .pointer = {}};
}

}  // namespace

JsonText::JsonText() : root_(std::make_unique<ordered_json>()) {}
JsonText::~JsonText() = default;
JsonText::JsonText(JsonText&&) noexcept = default;

Expected<JsonText> JsonText::parse(std::string_view text, std::string_view file) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  if (const std::size_t deep = tooDeepAt(text); deep != std::string_view::npos)
    return fail(ErrorKind::input, faultAt(file, lineAt(text, deep), "nests deeper than " + std::to_string(kMaxJsonDepth) + " levels.",
                                          "No file of npsee needs that; check what wrote it."));
  JsonText out;
  out.file_ = std::string(file);
  try {
    *out.root_ = ordered_json::parse(text);
  } catch (const ordered_json::parse_error& error) {
    return fail(ErrorKind::input, faultAt(file, lineAt(text, error.byte > 0 ? error.byte - 1 : 0), "is not JSON: " + parserReason(error.what()) + ".",
                                          "Mend the text at this line; values are separated by commas and numbers must be finite."));
  } catch (const ordered_json::exception& error) {
    return fail(ErrorKind::input, faultAt(file, 0, "is not JSON: " + parserReason(error.what()) + ".", "Numbers must be finite and fit a double."));
  }

  Scanner scanner(text, out.lines_);
  scanner.run();
  if (!scanner.repeated().empty()) {
    Error error{ErrorKind::input, {}};
    for (const auto& [pointer, line] : scanner.repeated()) {
      Fault fault = faultAt(file, line, "is given twice.", "Keep one of the two.");
      fault.pointer = pointer;
      error.faults.push_back(std::move(fault));
    }
    return tl::unexpected<Error>(std::move(error));
  }
  return out;
}

const ordered_json& JsonText::root() const { return *root_; }

int JsonText::line(const std::string& pointer) const {
  const auto found = lines_.find(pointer);
  return found == lines_.end() ? 0 : found->second;
}

Fault JsonText::fault(const std::string& pointer, std::string what, std::string remedy) const {
  return {.what = std::move(what), .remedy = std::move(remedy), .file = file_, .line = line(pointer), .pointer = pointer};
}

std::string pointerToken(std::string_view key) {
  std::string out;
  for (const char c : key) {
    if (c == '~') out += "~0";
    else if (c == '/') out += "~1";
    else out += c;
  }
  return out;
}

std::string_view jsonTypeName(const ordered_json& value) {
  if (value.is_null()) return "null";
  if (value.is_boolean()) return "true or false";
  if (value.is_number()) return "a number";
  if (value.is_string()) return "a text";
  if (value.is_array()) return "a list";
  return "an object";
}

}  // namespace npsee
