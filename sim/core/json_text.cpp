#include "sim/core/json_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace npsee {
namespace {

using nlohmann::ordered_json;

int lineAt(std::string_view text, std::size_t offset) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size())), '\n'));
}

/// A place where the text breaks a limit, found before it is parsed.
struct Excess {
  std::size_t offset;
  std::string what;
};

std::optional<Excess> firstExcess(std::string_view text) {
  std::vector<int> commas;  // per open bracket; -1 marks a list, whose length has no limit
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      else if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (commas.size() == kMaxJsonDepth) return Excess{i, "nests deeper than " + std::to_string(kMaxJsonDepth) + " levels."};
      commas.push_back(c == '[' ? -1 : 0);
    } else if ((c == '}' || c == ']') && !commas.empty()) {
      commas.pop_back();
    } else if (c == ',' && !commas.empty() && commas.back() >= 0 && ++commas.back() >= kMaxJsonKeys) {
      return Excess{i, "has an object with more than " + std::to_string(kMaxJsonKeys) + " keys."};
    }
  }
  return std::nullopt;
}

/// The parser's own words without its exception number and position, which we give ourselves.
std::string parserReason(std::string message) {
  // Parse errors have a colon before the reason, others only the bracket.
  if (const std::size_t colon = message.find(": "); message.starts_with("[json") && colon != std::string::npos) message.erase(0, colon + 2);
  else if (const std::size_t bracket = message.find("] "); message.starts_with("[json") && bracket != std::string::npos) message.erase(0, bracket + 2);
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

/// Walks well-formed JSON and notes on which line each value begins, and keys given twice. The parser keeps no places.
class JsonText::Scanner {
 public:
  Scanner(std::string_view text, std::vector<Place>& places) : text_(text), places_(places) {}

  void run() { value(); }
  /// Pointers and lines of keys given twice, the first hundred.
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
  void value() {
    const char first = peek();
    const std::size_t here = places_.size();
    places_.push_back({line_, 1});
    if (first == '{') {
      object();
    } else if (first == '[') {
      array();
    } else if (first == '"') {
      string();
    } else {
      while (at_ < text_.size() && std::string_view(",]} \t\r\n").find(text_[at_]) == std::string_view::npos) ++at_;
    }
    places_[here].values = static_cast<std::uint32_t>(places_.size() - here);
  }

  void object() {
    ++at_;
    std::vector<std::string> keys;
    const std::size_t parent = pointer_.size();
    while (peek() == '"') {
      keys.push_back(ordered_json::parse(string()).get<std::string>());
      pointer_ += '/' + pointerToken(keys.back());
      if (repeated_.size() < 100 && std::find(keys.begin(), keys.end() - 1, keys.back()) != keys.end() - 1) repeated_.emplace_back(pointer_, line_);
      peek();
      ++at_;  // the colon
      value();
      pointer_.resize(parent);
      if (peek() == ',') ++at_;
    }
    ++at_;
  }

  void array() {
    ++at_;
    const std::size_t parent = pointer_.size();
    for (std::size_t index = 0; peek() != ']' && peek() != '\0'; ++index) {
      pointer_ += '/' + std::to_string(index);
      value();
      pointer_.resize(parent);
      if (peek() == ',') ++at_;
    }
    ++at_;
  }

  std::string_view text_;
  std::vector<Place>& places_;
  std::vector<std::pair<std::string, int>> repeated_;
  std::string pointer_;
  std::size_t at_ = 0;
  int line_ = 1;
};

JsonText::JsonText() : root_(std::make_unique<ordered_json>()) {}
JsonText::~JsonText() = default;
JsonText::JsonText(JsonText&&) noexcept = default;

Expected<JsonText> JsonText::parse(std::string_view text, std::string_view file) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  if (auto excess = firstExcess(text))
    return fail(ErrorKind::input, faultAt(file, lineAt(text, excess->offset), std::move(excess->what), "No file of npsee needs that; check what wrote it."));
  JsonText out;
  out.file_ = std::string(file);
  try {
    *out.root_ = ordered_json::parse(text);
  } catch (const ordered_json::parse_error& error) {
    return fail(ErrorKind::input, faultAt(file, lineAt(text, error.byte > 0 ? error.byte - 1 : 0), "is not JSON: " + parserReason(error.what()) + ".",
                                          "Mend the text at this line; values are separated by commas and numbers must be finite."));
  } catch (const ordered_json::exception& error) {
    // The library names the number that is too large, and not where it stands.
    const std::string reason = parserReason(error.what());
    const std::size_t open = reason.find('\''), close = reason.rfind('\'');
    const std::size_t place = open < close ? text.find(std::string_view(reason).substr(open + 1, close - open - 1)) : std::string_view::npos;
    return fail(ErrorKind::input, faultAt(file, place == std::string_view::npos ? 0 : lineAt(text, place), "is not JSON: " + reason + ".", "Numbers must be finite and fit a double."));
  }

  Scanner scanner(text, out.places_);
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
  // Down the value and along the places side by side: both keep the order of the text.
  const ordered_json* value = root_.get();
  std::size_t at = 0;
  for (std::size_t begin = 0; begin < pointer.size();) {
    const std::size_t end = std::min(pointer.find('/', begin + 1), pointer.size());
    const std::string token = pointer.substr(begin + 1, end - begin - 1);
    const ordered_json* found = nullptr;
    std::size_t index = 0;
    ++at;  // the first value inside
    if (!value->is_structured()) return 0;
    for (auto child = value->begin(); child != value->end() && found == nullptr; ++child, ++index) {
      if (token == (value->is_object() ? pointerToken(child.key()) : std::to_string(index))) found = &*child;
      else at += places_[at].values;
    }
    if (found == nullptr) return 0;
    value = found;
    begin = end;
  }
  return places_[at].line;
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

std::string shownJson(const ordered_json& value) {
  constexpr std::size_t kLongest = 60;
  std::string shown = value.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  if (shown.size() <= kLongest) return shown;
  // Not in the middle of a letter.
  std::size_t end = kLongest - 3;
  while ((static_cast<unsigned char>(shown[end]) & 0xc0) == 0x80) --end;
  return shown.substr(0, end) + "...";
}

std::optional<std::int64_t> wholeNumber(const ordered_json& value) {
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > static_cast<std::uint64_t>(INT64_MAX)) return std::nullopt;
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (!value.is_number_float()) return std::nullopt;
  // 100.0 is a whole number too; 2^53 keeps the conversion exact.
  const double number = value.get<double>();
  if (number != std::floor(number) || std::fabs(number) > 9007199254740992.0) return std::nullopt;
  return static_cast<std::int64_t>(number);
}

}  // namespace npsee
