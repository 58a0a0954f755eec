#include "sim/core/text.h"

#include <gtest/gtest.h>

namespace npsee {
namespace {

TEST(Text, TellsUtf8FromOtherBytes) {
  for (const char* good : {"", "plain", "\u00e9", "\u20ac", "\U0001f4a5", "\ud7ff\ue000\U0010ffff"}) EXPECT_TRUE(validUtf8(good)) << good;
  for (const char* bad : {"\x80", "\xff", "a\xc3", "\xc3(", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf", "\xf4\x90\x80\x80", "\xe2\x82", "\xf0\x9f\x92"})
    EXPECT_FALSE(validUtf8(bad)) << bad;
}

TEST(Text, TheNearestWordIsFoundThroughTyposAndParts) {
  const std::vector<std::string_view> words{"speed_mean", "size_mean", "region.radius"};
  EXPECT_EQ(nearest("sped_mean", words), "speed_mean");
  EXPECT_EQ(nearest("radius", words), "region.radius");
  EXPECT_EQ(nearest("zzzzzz", words), std::nullopt);
  EXPECT_EQ(nearest(std::string(100, 'x'), words), std::nullopt);
}

}  // namespace
}  // namespace npsee
