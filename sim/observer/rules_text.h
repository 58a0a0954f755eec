#pragma once

#include <npsee/error.h>

#include <string_view>
#include <vector>

namespace npsee::observer {

/// A rules file read as what it is to CLIPS's scanner: lists of words. Views point into the text, which must outlive them.
struct RuleNode {
  enum class Kind {
    list,
    word,  ///< symbol, number, variable, or one of & | ~
    text,  ///< "..." with its quotes
  } kind = Kind::word;
  std::string_view text;       ///< as it stands in the file
  int line = 0;
  std::size_t begin = 0, end = 0;  ///< byte offsets
  std::vector<RuleNode> items; ///< of a list

  bool isList() const { return kind == Kind::list; }
  bool isWord(std::string_view word) const { return kind == Kind::word && text == word; }
  /// First word of a list; empty if there is none.
  std::string_view head() const { return isList() && !items.empty() && items.front().kind == Kind::word ? items.front().text : std::string_view(); }
};

inline constexpr std::size_t kMaxRulesText = 64u << 10;
inline constexpr int kMaxRulesNesting = 64;

/// The forms of a file. Error kind input, with file and line: too long, nested too deep, not text, brackets or quotes left open.
Expected<std::vector<RuleNode>> readRules(std::string_view text, std::string_view file);

}  // namespace npsee::observer
