// Prints libFuzzer's dictionary: every key and choice of the parameter table, and a setting that works for each.
#include <npsee/parameters.h>

#include <cstdio>
#include <set>
#include <string>

namespace {

/// A dictionary entry; what is neither letter nor digit is written as \xNN.
std::string entry(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    char code[8];
    std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
    out += plain ? std::string(1, c) : std::string(code);
  }
  return out + "\"\n";
}

}  // namespace

int main() {
  std::set<std::string> entries{entry("npsee"), entry("\"npsee\": 1"), entry("layers"), entry("[[0,1],[1,0]]"), entry("#ff8800"), entry("1e308"), entry("deg")};
  for (const npsee::Parameter& row : npsee::parameters()) {
    const std::string key(row.key);
    entries.insert(entry(key.substr(key.rfind('.') + 1)));
    entries.insert(entry('\n' + std::string(row.scope == npsee::Scope::layer ? "a." : "") + key + '=' + valueText(row, row.initial)));
    for (const std::string_view choice : row.choices) entries.insert(entry(std::string(choice)));
  }
  for (const std::string& line : entries) std::fputs(line.c_str(), stdout);
}
