#include "sim/core/elementary.h"
#include "sim/core/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace npsee {
namespace {

TEST(Elementary, ExponentialIsGoodToTwoUnitsInTheLastPlace) {
  for (double x = -699.0; x < 700.0; x += 0.0937) EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 4.5e-16) << x;
  EXPECT_EQ(exponential(0.0), 1.0);
}

TEST(Elementary, LogarithmIsGoodToRounding) {
  for (double x = 1e-300; x < 1e300; x *= 1.37) EXPECT_NEAR(logarithm(x), std::log(x), 4.5e-16 * std::max(1.0, std::fabs(std::log(x)))) << x;
  EXPECT_EQ(logarithm(1.0), 0.0);
}

TEST(Elementary, SineAndCosineAreGoodToRounding) {
  for (double x = -100.0; x < 100.0; x += 0.0173) {
    double s = 0.0, c = 0.0;
    sineCosine(x, s, c);
    EXPECT_NEAR(s, std::sin(x), 4e-16) << x;
    EXPECT_NEAR(c, std::cos(x), 4e-16) << x;
  }
}

TEST(Elementary, LanesGiveTheBitsOfSingleNumbers) {
  for (double x = -30.0; x < 30.0; x += 0.37) {
    const double numbers[8] = {x, x + 0.1, -x, 3 * x, x * x, 0.0, x / 7, 1.0};
    const lanes::Eight eight = lanes::loadEight(numbers);
    const lanes::Eight e = exponential(eight);
    lanes::Eight s, c;
    sineCosine(eight, s, c);
    for (int i = 0; i < 8; ++i) {
      double si = 0.0, ci = 0.0;
      sineCosine(numbers[i], si, ci);
      EXPECT_EQ(e[i], exponential(numbers[i]));
      EXPECT_EQ(s[i], si);
      EXPECT_EQ(c[i], ci);
    }
  }
}

TEST(Random, InverseNormalInvertsTheDistributionFunction) {
  for (double z = -6.0; z <= 6.0; z += 0.01) EXPECT_NEAR(inverseNormal(0.5 * std::erfc(-z / std::sqrt(2.0))), z, z > 4 ? 1e-6 : 1e-11) << z;
  EXPECT_EQ(inverseNormal(0.5), 0.0);
}

TEST(Random, DrawsDependOnEveryPartOfTheIdentityAndOnNothingElse) {
  const ParticleIdentity base{1, 2, 3, 4, 5};
  const auto draws = uniformBlock(base, 0);
  EXPECT_EQ(uniformBlock(base, 0), draws);
  for (const ParticleIdentity& other : {ParticleIdentity{9, 2, 3, 4, 5}, ParticleIdentity{1, 9, 3, 4, 5}, ParticleIdentity{1, 2, 9, 4, 5}, ParticleIdentity{1, 2, 3, 9, 5},
                                        ParticleIdentity{1, 2, 3, 4, 9}, ParticleIdentity{1 + (1ull << 40), 2, 3, 4, 5}})
    EXPECT_NE(uniformBlock(other, 0), draws);
  EXPECT_NE(uniformBlock(base, 1), draws);
}

}  // namespace
}  // namespace npsee
