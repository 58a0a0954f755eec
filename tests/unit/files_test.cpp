#include "sim/core/files.h"

#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace {

std::atomic<int> asked_for_umask = 0;

}  // namespace

/// In place of the C library's in this program: to ask for the umask is to set it for every thread, and a test that waits for two of them to meet
/// would seldom see it.
extern "C" mode_t umask(mode_t mask) noexcept {
  ++asked_for_umask;
  return static_cast<mode_t>(::syscall(SYS_umask, mask));
}

namespace npsee {
namespace {

namespace fs = std::filesystem;

unsigned modeOf(const std::string& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0) << path;
  return status.st_mode & 07777;
}

/// The process's umask for the length of a test.
class Umask {
 public:
  explicit Umask(mode_t mask) : before_(::umask(mask)) {}
  ~Umask() { ::umask(before_); }
  /// What it is now.
  static mode_t now() {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return mask;
  }

 private:
  mode_t before_;
};

/// Both ways to write: a file without a name until it is whole, and one that another program fills.
Expected<void> write(const std::string& path, bool with_name) {
  if (!with_name) return writeFileAtomically(path, std::string_view("text"));
  auto file = TemporaryFile::beside(path);
  if (!file) return tl::unexpected<Error>(file.error());
  test::spill(file->path(), "text");
  return file->publish();
}

TEST(Files, SavingFromManyThreadsKeepsTheUmask) {
  const test::TemporaryFolder folder;
  const Umask umask(027);
  const int calls = asked_for_umask;
  std::vector<std::jthread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&folder, t] {
      for (int i = 0; i < 20; ++i) EXPECT_TRUE(write(folder / (std::to_string(t) + "_" + std::to_string(i)), i % 3 == 0));
    });
  threads.clear();
  EXPECT_EQ(asked_for_umask, calls);
  EXPECT_EQ(Umask::now(), 027u);
  for (const auto& file : fs::directory_iterator(folder.path())) EXPECT_EQ(modeOf(file.path().string()), 0640u) << file.path();
}

TEST(Files, ANewOneGetsWhatTheUmaskLeavesAndAReplacedOneKeepsItsMode) {
  for (const bool with_name : {false, true})
    for (const mode_t mask : {000u, 022u, 077u, 0777u}) {
      const test::TemporaryFolder folder;
      const Umask umask(mask);
      ASSERT_TRUE(write(folder / "new", with_name));
      EXPECT_EQ(modeOf(folder / "new"), 0666u & ~mask);
      ::chmod((folder / "new").c_str(), 0604);
      ASSERT_TRUE(write(folder / "new", with_name));
      EXPECT_EQ(modeOf(folder / "new"), 0604u);
    }
}

TEST(Files, WhatAnotherProgramFillsIsPrivateUntilItIsWhole) {
  const test::TemporaryFolder folder;
  const auto file = TemporaryFile::beside(folder / "film.mp4");
  ASSERT_TRUE(file);
  EXPECT_EQ(modeOf(file->path().string()), 0600u);
}

TEST(Files, ALegalNameOfAnyLengthIsWritten) {
  const test::TemporaryFolder folder;
  // 255 bytes is the most that Linux allows; the letter of two bytes is cut nowhere in its middle.
  for (const std::string& name : {std::string(255, 'a'), std::string(241, 'b'), "c" + std::string(99, 'c') + std::string("\u00e4\u00e4") + std::string(150, 'd'), std::string("e")})
    for (const bool with_name : {false, true}) {
      EXPECT_TRUE(write(folder / name, with_name)) << name.size();
      EXPECT_EQ(test::slurp(folder / name), "text");
    }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 4) << "nothing is left beside them";
  EXPECT_FALSE(write(folder / std::string(256, 'a'), false));
  EXPECT_FALSE(write(folder / std::string(256, 'a'), true));
}

}  // namespace
}  // namespace npsee
