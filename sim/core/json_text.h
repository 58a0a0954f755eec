#pragma once

#include <npsee/error.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace npsee {

/// Deepest nesting of a file, and most keys of one object (the parser compares each with all others).
inline constexpr int kMaxJsonDepth = 64;
inline constexpr int kMaxJsonKeys = 256;

/// A parsed file that still knows on which line each value stands.
class JsonText {
 public:
  /// Error kind input with file and line: malformed text, nesting too deep, too many keys, a key given twice, a number beyond
  /// double. Memory stays in proportion to the text.
  static Expected<JsonText> parse(std::string_view text, std::string_view file);
  ~JsonText();
  JsonText(JsonText&&) noexcept;

  const nlohmann::ordered_json& root() const;
  const std::string& file() const { return file_; }
  /// 1-based line of the value at a JSON pointer ("" is the root), 0 if there is none.
  int line(const std::string& pointer) const;
  /// A fault at a pointer, with file and line filled in.
  Fault fault(const std::string& pointer, std::string what, std::string remedy = {}) const;

 private:
  JsonText();
  /// Where a value begins, and how many values it is with all inside it.
  struct Place {
    int line = 0;
    std::uint32_t values = 1;
  };
  class Scanner;
  std::string file_;
  std::unique_ptr<nlohmann::ordered_json> root_;
  std::vector<Place> places_;  ///< of every value in the order of the text
};

/// Escapes a key for use in a JSON pointer (RFC 6901).
std::string pointerToken(std::string_view key);

/// "number", "text", "true or false", ... for messages.
std::string_view jsonTypeName(const nlohmann::ordered_json& value);

/// A value as messages show it, cut to 60 characters.
std::string shownJson(const nlohmann::ordered_json& value);

/// The whole number that a value is, 100.0 as well as 100; nothing for other values and those beyond 64 bits (with a decimal point
/// beyond 2^53).
std::optional<std::int64_t> wholeNumber(const nlohmann::ordered_json& value);

}  // namespace npsee
