// What CLIPS does where the process has no memory left: it would end it with a code and words of its own.

#include "sim/observer/clips_host.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <new>
#include <optional>
#include <string>

#include <sys/resource.h>
#include <unistd.h>

namespace npsee::observer {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// Many facts, each with a text of its own: some twenty mebibytes.
std::string growing() {
  return "(deftemplate grown (slot number) (slot text))(defrule grow => (loop-for-count (?i 1 40000) (assert (grown (number ?i) (text (str-cat \"" + std::string(400, 'x') + "\" ?i))))))";
}

/// Lets this process have so much more than it has.
void allowOnly(std::size_t more) {
  long pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t bytes = static_cast<rlim_t>(pages) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + more;
  const rlimit limit{bytes, bytes};
  if (setrlimit(RLIMIT_AS, &limit) != 0) std::exit(9);
}

/// 0 if the rules ran to their end, 5 if memory did not suffice and all went on after it; anything else is wrong.
int grown(ClipsHost* given) {
  try {
    std::optional<ClipsHost> own;
    ClipsHost& host = given != nullptr ? *given : own.emplace();
    if (!host.load(growing(), "growing.clp")) return 7;
    host.begin();
    host.reset();
    return host.run() ? 0 : 8;
  } catch (const std::bad_alloc&) {
    return 5;
  }
}

class LittleMemory : public testing::TestWithParam<int> {};

TEST_P(LittleMemory, IsThrownWithAFewMebibytes) {
  if (kSanitized) GTEST_SKIP() << "sanitizers take addresses of their own";
  GTEST_FLAG_SET(death_test_style, "threadsafe");  // a process of its own: what other tests have given back would do for the rules
  const auto more = static_cast<std::size_t>(GetParam()) << 20;
  EXPECT_EXIT(
      {
        allowOnly(more);
        std::exit(grown(nullptr));
      },
      testing::ExitedWithCode(5), "")
      << "before the environment is made";
  EXPECT_EXIT(
      {
        ClipsHost host;
        allowOnly(more);
        std::exit(grown(&host));
      },
      testing::ExitedWithCode(5), "")
      << "while rules run";
}
INSTANTIATE_TEST_SUITE_P(Mebibytes, LittleMemory, testing::Values(0, 1, 2, 4, 6));

TEST(Memory, SufficesWhereThereIsRoom) {
  ClipsHost host;
  EXPECT_EQ(grown(&host), 0);
  EXPECT_EQ(host.facts().size(), 40000u);
}

}  // namespace
}  // namespace npsee::observer
