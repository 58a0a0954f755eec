#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace npsee::test {

/// A fenced block of a Markdown text.
struct Block {
  std::string info;  ///< what stands after the three backticks
  std::string text;
};

inline std::vector<Block> fencedBlocks(const std::string& markdown) {
  std::vector<Block> blocks;
  std::istringstream lines(markdown);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) blocks.push_back({line.substr(3), {}});
    } else if (inside) {
      blocks.back().text += line + '\n';
    }
  }
  return blocks;
}

}  // namespace npsee::test
