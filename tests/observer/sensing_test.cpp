#include "sim/observer/sensing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace npsee::observer {
namespace {

TEST(Belief, CombinesByDempstersRule) {
  const Combined first = combine({0.6, 0.0, 0.4}, {0.5, 0.2, 0.3});
  EXPECT_NEAR(first.evidence.hostile, 0.7727, 5e-5);
  EXPECT_NEAR(first.evidence.friendly, 0.0909, 5e-5);
  EXPECT_NEAR(first.evidence.unknown, 0.1364, 5e-5);
  EXPECT_NEAR(first.conflict, 0.12, 1e-12);
  const Combined second = combine(first.evidence, {0.0, 0.9, 0.1});
  EXPECT_NEAR(second.evidence.hostile, 0.2537, 5e-5);
  EXPECT_NEAR(second.evidence.friendly, 0.7015, 5e-5);
  EXPECT_NEAR(second.conflict, 0.6955, 5e-5);
}

TEST(Belief, TotalConflictIsUndecidedAndNeverADivisionByZero) {
  const Combined out = combine({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
  EXPECT_TRUE(out.undecided);
  EXPECT_EQ(out.conflict, 1.0);
  EXPECT_EQ(out.evidence, (Evidence{0.0, 0.0, 1.0}));
  EXPECT_TRUE(combine({std::nan(""), 0.0, 0.0}, {0.0, 1.0, 0.0}).undecided);
}

TEST(Belief, CombiningIsSymmetricAndIgnoranceChangesNothing) {
  const Evidence a{0.3, 0.5, 0.2}, b{0.7, 0.1, 0.2};
  const Combined ab = combine(a, b), ba = combine(b, a);
  EXPECT_NEAR(ab.evidence.hostile, ba.evidence.hostile, 1e-15);
  EXPECT_NEAR(ab.evidence.hostile + ab.evidence.friendly + ab.evidence.unknown, 1.0, 1e-12);
  EXPECT_EQ(combine(a, Evidence{}).evidence, a);
}

TEST(Belief, FallsWithTheLogarithmOfRange) {
  Sensing s;
  EXPECT_EQ(beliefAt(s, 3000.0), 1.0) << "perfect sensing is the default";
  s.limited_belief = true;
  EXPECT_NEAR(beliefAt(s, 1000.0), 0.466, 5e-4);
  EXPECT_NEAR(beliefAt(s, 2000.0), 0.258, 5e-4);
  EXPECT_EQ(beliefAt(s, 10.0), 0.95);
  EXPECT_EQ(beliefAt(s, 0.0), 0.95);
  EXPECT_EQ(beliefAt(s, 9000.0), 0.05);
}

TEST(Fog, AContrastOfThreeTenthsIsSeenTo3460MetresWhereTheVisibilityIs5Kilometres) {
  Sensing s;
  Weather w;
  w.visibility_m = 5000.0;
  EXPECT_NEAR(fogRange(s, w), 3461.0, 2.0);
  EXPECT_TRUE(visibleThrough(s, w, 3450.0, 4000.0));
  EXPECT_FALSE(visibleThrough(s, w, 3470.0, 4000.0));
  s.fog = false;
  EXPECT_TRUE(visibleThrough(s, w, 3470.0, 4000.0));
  EXPECT_FALSE(visibleThrough(s, w, 4001.0, 4000.0));
}

TEST(Fog, NightScalesContrastAndRange) {
  Sensing s;
  Weather w;
  w.visibility_m = 5000.0;
  w.night = true;
  EXPECT_NEAR(fogRange(s, w), 5000.0 / 3.912 * std::log(0.09 / 0.02), 1.0);
  EXPECT_TRUE(visibleThrough(s, w, 1390.0, 4000.0));
  EXPECT_FALSE(visibleThrough(s, w, 1410.0, 4000.0)) << "0.35 of 4,000 m";
  s.contrast = 0.01;
  EXPECT_EQ(fogRange(s, w), 0.0);
}

TEST(Draws, DifferByEverythingTheyAreNamedByAndAreNormal) {
  std::set<double> seen;
  for (const std::int64_t seed : {1, 2})
    for (const std::uint32_t entity : {0u, 1u})
      for (const Purpose purpose : {Purpose::location, Purpose::spotting})
        for (const std::uint32_t count : {0u, 1u}) {
          seen.insert(normals(seed, entity, purpose, count).a);
          seen.insert(normals(seed, entity, purpose, count).b);
        }
  EXPECT_EQ(seen.size(), 32u);
  double sum = 0.0, squares = 0.0;
  constexpr int kDraws = 20000;
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    const Normals n = normals(1993, 3, Purpose::dispersion, i);
    sum += n.a + n.b;
    squares += n.a * n.a + n.b * n.b;
  }
  // Four standard errors of mean and variance of 2 x 20,000 draws.
  EXPECT_NEAR(sum / (2.0 * kDraws), 0.0, 4.0 / std::sqrt(2.0 * kDraws));
  EXPECT_NEAR(squares / (2.0 * kDraws), 1.0, 4.0 * std::sqrt(2.0 / (2.0 * kDraws)));
}

TEST(Draws, HalfOfACircularErrorFallsWithinItsProbableError) {
  int within = 0;
  constexpr int kDraws = 20000;
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    const Normals n = normals(7, i, Purpose::location, 0);
    within += std::hypot(n.a, n.b) * sigmaOfCep(200.0) < 200.0;
  }
  EXPECT_NEAR(static_cast<double>(within) / kDraws, 0.5, 4.0 * 0.5 / std::sqrt(kDraws));
}

TEST(Messages, ArePassedUnchangedByDefaultAndWhereReadingBackCatchesAll) {
  FdcSetup perfect;
  const Misheard heard = mishear(perfect, 1, 1, 0, 120.0, -400.0);
  EXPECT_FALSE(heard.changed);
  EXPECT_EQ(heard.right_m, 120.0);
  EXPECT_EQ(heard.add_m, -400.0);
  FdcSetup caught;
  caught.misunderstanding = 1.0;
  caught.read_back = 1.0;
  EXPECT_FALSE(mishear(caught, 1, 1, 0, 120.0, -400.0).changed);
}

TEST(Messages, AreMisheardAsOftenAsAskedAndOnlyInTheThreeWays) {
  FdcSetup fdc;
  fdc.misunderstanding = 0.4;
  fdc.read_back = 0.5;
  int changed = 0, lost = 0, sides = 0, swaps = 0;
  constexpr int kMessages = 10000;
  for (std::uint32_t i = 0; i < kMessages; ++i) {
    const Misheard heard = mishear(fdc, 1993, 1, i, 120.0, -400.0);
    if (!heard.changed) continue;
    ++changed;
    EXPECT_FALSE(heard.how.empty());
    if (heard.lost) ++lost;
    else if (heard.right_m == -120.0 && heard.add_m == -400.0) ++sides;
    else {
      EXPECT_TRUE((heard.right_m == 210.0 || heard.right_m == 102.0) && heard.add_m == -400.0) << heard.how << ": 400 has no pair of digits to swap without a zero in front";
      ++swaps;
    }
  }
  EXPECT_NEAR(changed, 0.2 * kMessages, 4.0 * std::sqrt(0.16 * kMessages));
  for (const int kind : {lost, sides, swaps}) EXPECT_NEAR(kind, changed / 3.0, 4.0 * std::sqrt(changed * 2.0 / 9.0));
  // A message in which nothing can be mistaken is lost.
  fdc.misunderstanding = 1.0;
  fdc.read_back = 0.0;
  EXPECT_TRUE(mishear(fdc, 1, 1, 0, 0.0, 0.0).lost);
}

}  // namespace
}  // namespace npsee::observer
