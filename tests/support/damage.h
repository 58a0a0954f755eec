#pragma once

#include <random>
#include <span>
#include <string>

namespace npsee::test {

/// A few random edits, at most `most`: bytes changed, cut, doubled, or replaced by one of `traps`, text that parsers stumble over.
inline std::string damaged(std::string text, std::mt19937& random, std::span<const char* const> traps, unsigned most) {
  const auto edits = 1 + random() % most;
  for (std::uint_fast32_t i = 0; i < edits && !text.empty(); ++i) {
    const std::size_t at = random() % text.size(), length = 1 + random() % 12;
    switch (random() % 4) {
      case 0: text[at] = static_cast<char>(random() % 256); break;
      case 1: text.erase(at, length); break;
      case 2: text.insert(at, text.substr(random() % text.size(), length)); break;
      default: text.replace(at, random() % 5, traps[random() % traps.size()]);
    }
  }
  return text;
}

}  // namespace npsee::test
