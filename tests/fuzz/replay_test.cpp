// A short run of every fuzz target: what once broke a promise, the shipped files, and some hundred damaged ones.

#include "tests/fuzz/targets.h"
#include "tests/support/damage.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

namespace npsee {
namespace {

namespace fs = std::filesystem;

/// Regular files of a folder whose names end so, by name.
std::vector<std::string> filesIn(const std::string& folder, std::string_view ending) {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(std::string(NPSEE_SOURCE_DIR) + "/" + folder))
    if (entry.is_regular_file() && entry.path().string().ends_with(ending)) out.push_back(entry.path().string());
  std::sort(out.begin(), out.end());
  return out;
}

/// What a target starts from: its corpus, and the shipped files of its kind.
std::vector<std::string> startsOf(const fuzz::NamedTarget& target) {
  std::vector<std::string> out = filesIn("tests/fuzz/corpus/" + std::string(target.name), "");
  EXPECT_FALSE(out.empty()) << target.name << " has no corpus";
  if (const std::size_t blank = target.seeds.find(' '); blank != std::string_view::npos) {
    const auto shipped = filesIn(std::string(target.seeds.substr(0, blank)), target.seeds.substr(blank + 1));
    EXPECT_FALSE(shipped.empty()) << target.seeds;
    out.insert(out.end(), shipped.begin(), shipped.end());
  }
  return out;
}

// A broken promise aborts: the targets say which.
TEST(FuzzReplay, WhatOnceBrokeAPromiseAndWhatIsShippedKeepIt) {
  for (const fuzz::NamedTarget& target : fuzz::targets())
    for (const std::string& file : startsOf(target)) {
      SCOPED_TRACE(file);
      target.run(test::slurp(file));
    }
}

TEST(FuzzReplay, DamagedFilesKeepThePromisesToo) {
  static const char* const kTraps[] = {"1e308", "-1", "null", "[", "}", "\"", "\\u0000", "NaN", "99999999999999999999", "\xff", "\n", "("};
  for (const fuzz::NamedTarget& target : fuzz::targets()) {
    SCOPED_TRACE(std::string(target.name));
    std::mt19937 random(7);
    for (const std::string& file : startsOf(target)) {
      const std::string whole = test::slurp(file);
      if (whole.size() > 20000) continue;
      for (int i = 0; i < 12; ++i) target.run(test::damaged(whole, random, kTraps, 4));
    }
  }
}

TEST(FuzzReplay, EveryTargetIsBuilt) {
  const std::string cmake = test::slurp(std::string(NPSEE_SOURCE_DIR) + "/tests/fuzz/CMakeLists.txt");
  for (const fuzz::NamedTarget& target : fuzz::targets()) EXPECT_NE(cmake.find(std::string(target.name) + ":"), std::string::npos) << target.name;
}

}  // namespace
}  // namespace npsee
