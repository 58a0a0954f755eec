#include "sim/observer/rules_text.h"

#include "sim/core/text.h"

#include <string>

namespace npsee::observer {
namespace {

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// Where CLIPS's scanner ends a word. `<` begins a word but does not stand inside one.
bool endsWord(char c) {
  return isSpace(c) || c == '(' || c == ')' || c == '&' || c == '|' || c == '~' || c == '"' || c == ';' || c == '<';
}

class Reader {
 public:
  Reader(std::string_view text, std::string_view file) : text_(text), file_(file) {}

  Expected<std::vector<RuleNode>> read() {
    std::vector<RuleNode> forms;
    // Open lists from the outermost in; a list moves into its parent when it is closed, so that no pointer ever dangles.
    std::vector<RuleNode> open;
    while (skipToToken()) {
      const char c = text_[at_];
      if (c == '(') {
        if (open.size() >= static_cast<std::size_t>(kMaxRulesNesting))
          return fault(line_, "Lists are nested deeper than " + std::to_string(kMaxRulesNesting) + ".", "Write the rule as several rules or functions.");
        open.push_back({RuleNode::Kind::list, {}, line_, at_, 0, {}});
        ++at_;
        continue;
      }
      RuleNode node;
      if (c == ')') {
        if (open.empty()) return fault(line_, "A closing bracket has no opening one.", "Remove it.");
        ++at_;
        node = std::move(open.back());
        open.pop_back();
        node.end = at_;
        node.text = text_.substr(node.begin, node.end - node.begin);
      } else if (c == '"') {
        auto quoted = readText();
        if (!quoted) return tl::unexpected(quoted.error());
        node = std::move(*quoted);
      } else {
        node = readWord();
      }
      (open.empty() ? forms : open.back().items).push_back(std::move(node));
    }
    if (!open.empty()) return fault(open.back().line, "A bracket opened here is never closed.", "Close it with ).");
    return forms;
  }

 private:
  tl::unexpected<Error> fault(int line, std::string what, std::string remedy) const {
    return fail(ErrorKind::input, Fault{std::move(what), std::move(remedy), std::string(file_), line, {}});
  }

  bool skipToToken() {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '\n') {
        ++line_;
      } else if (c == ';') {
        while (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
      } else if (!isSpace(c)) {
        return true;
      }
    }
    return false;
  }

  Expected<RuleNode> readText() {
    RuleNode node{RuleNode::Kind::text, {}, line_, at_, 0, {}};
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      if (text_[at_] == '\\') ++at_;
      if (at_ < text_.size() && text_[at_] == '\n') ++line_;
    }
    if (at_ >= text_.size()) return fault(node.line, "A text opened here with \" is never closed.", "Close it with \".");
    node.end = ++at_;
    node.text = text_.substr(node.begin, node.end - node.begin);
    return node;
  }

  RuleNode readWord() {
    RuleNode node{RuleNode::Kind::word, {}, line_, at_, 0, {}};
    const char c = text_[at_++];
    if (c != '&' && c != '|' && c != '~')
      while (at_ < text_.size() && !endsWord(text_[at_])) ++at_;
    node.end = at_;
    node.text = text_.substr(node.begin, node.end - node.begin);
    return node;
  }

  std::string_view text_, file_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace

Expected<std::vector<RuleNode>> readRules(std::string_view text, std::string_view file) {
  const auto whole = [file](std::string what, std::string remedy, int line = 1) {
    return fail(ErrorKind::input, Fault{std::move(what), std::move(remedy), std::string(file), line, {}});
  };
  if (text.size() > kMaxRulesText)
    return whole("The rules are " + std::to_string(text.size()) + " bytes long, above the limit of " + std::to_string(kMaxRulesText) + ".", "Shorten them.");
  if (!validUtf8(text)) return whole("The file is not text in UTF-8.", "Save it as UTF-8.");
  int line = 1;
  for (const char c : text) {
    if (c == '\n') ++line;
    if ((static_cast<unsigned char>(c) < 0x20 && !isSpace(c)) || c == 0x7f)
      return whole("The file holds a control character; it is not plain text.", "Save it as plain text.", line);
  }
  return Reader(text, file).read();
}

}  // namespace npsee::observer
