#include "sim/core/parallel.h"

#include "tests/support/no_threads.h"

#include <npsee/ballistics.h>

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <vector>

namespace npsee {
namespace {

TEST(Parallel, WhereNoThreadIsGivenTheCallerDoesAllTheWork) {
  const test::NoThreads none;
  EXPECT_THROW(std::jthread([] {}), std::system_error) << "the test itself";
  std::vector<int> done(1000, 0);
  std::vector<std::thread::id> by(done.size());
  parallelFor(64, done.size(), [&](std::size_t i) {
    ++done[i];
    by[i] = std::this_thread::get_id();
  });
  EXPECT_EQ(done, std::vector<int>(1000, 1));
  EXPECT_EQ(by, std::vector<std::thread::id>(1000, std::this_thread::get_id()));
}

TEST(Parallel, WhatAWorkerThrowsReachesTheCaller) {
  for (const int threads : {1, 5})
    EXPECT_THROW(parallelFor(threads, 100, [](std::size_t i) {
      if (i == 40) throw std::bad_alloc();
    }), std::bad_alloc);
}

TEST(Parallel, ShotsAreFlownAlikeWhereNoThreadIsGiven) {
  const auto projectile = findProjectile("m107");
  ASSERT_TRUE(projectile);
  const auto ballistics = Ballistics::make(*projectile);
  ASSERT_TRUE(ballistics);
  std::vector<Shot> shots(600);
  for (std::size_t i = 0; i < shots.size(); ++i) {
    shots[i].speed_mps = 300.0;
    shots[i].elevation_rad = 0.001 * static_cast<double>(i);
  }
  std::vector<Flight> alone(shots.size()), many(shots.size());
  ballistics->flyMany(shots, alone, 1);
  const test::NoThreads none;
  ballistics->flyMany(shots, many, 8);
  for (std::size_t i = 0; i < shots.size(); ++i) ASSERT_EQ(many[i].range_m, alone[i].range_m) << i;
}

}  // namespace
}  // namespace npsee
