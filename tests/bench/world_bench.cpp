#include "sim/world/vehicles.h"

#include <npsee/terrain.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

namespace {

using namespace npsee;

TerrainSource hills(double cell_m) {
  TerrainSource source;
  source.kind = TerrainKind::hills;
  source.cell_m = cell_m;
  return source;
}

/// Eyes and targets up to 4 km apart, as observers test them.
std::vector<std::pair<Vec3, Vec3>> rays(const Terrain& ground, double size) {
  std::vector<std::pair<Vec3, Vec3>> out;
  std::uint64_t state = 1;
  const auto next = [&] {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state >> 11) / 9007199254740992.0;
  };
  while (out.size() < 4096) {
    Vec3 a{next() * size, 0.0, next() * size}, b{a.x + 8000.0 * next() - 4000.0, 0.0, a.z + 8000.0 * next() - 4000.0};
    if (length(b - a) > 4000.0 || !ground.inside(b.x, b.z)) continue;
    a.y = ground.height(a.x, a.z) + 2.5;
    b.y = ground.height(b.x, b.z) + 2.2;
    out.emplace_back(a, b);
  }
  return out;
}

/// One exact line of sight, up to 4 km; argument: cell in metres.
void ExactSight(benchmark::State& state) {
  const double size = state.range(0) < 20 ? 10000.0 : 20000.0;
  const Terrain ground = *Terrain::make(hills(static_cast<double>(state.range(0))), size, size, 0.0);
  const auto pairs = rays(ground, size);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [eye, target] = pairs[i++ & 4095];
    benchmark::DoNotOptimize(ground.sight(eye, target));
  }
}
BENCHMARK(ExactSight)->Arg(125)->Arg(30)->Arg(10);

/// Whether there is a line of sight, and no more.
void Sees(benchmark::State& state) {
  const Terrain ground = *Terrain::make(hills(30.0), 20000.0, 20000.0, 0.0);
  const auto pairs = rays(ground, 20000.0);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [eye, target] = pairs[i++ & 4095];
    benchmark::DoNotOptimize(ground.sees(eye, target));
  }
}
BENCHMARK(Sees);

/// The thesis's test with its 100 samples.
void SampledSight(benchmark::State& state) {
  const Terrain ground = *Terrain::make(hills(30.0), 20000.0, 20000.0, 0.0);
  const auto pairs = rays(ground, 20000.0);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [eye, target] = pairs[i++ & 4095];
    benchmark::DoNotOptimize(ground.sightSampled(eye, target));
  }
}
BENCHMARK(SampledSight);

/// A picking ray from 500 m up.
void Raycast(benchmark::State& state) {
  const Terrain ground = *Terrain::make(hills(30.0), 50000.0, 50000.0, 0.0);
  for (auto _ : state) benchmark::DoNotOptimize(ground.raycast({2000.0, 500.0, 2000.0}, {1.0, -0.015, 0.8}, 60000.0));
}
BENCHMARK(Raycast)->Unit(benchmark::kMicrosecond);

void Height(benchmark::State& state) {
  const Terrain ground = *Terrain::make(hills(30.0), 20000.0, 20000.0, 0.0);
  double x = 0.0;
  for (auto _ : state) {
    x = x > 19000.0 ? 0.0 : x + 37.7;
    benchmark::DoNotOptimize(ground.height(x, 0.7 * x));
  }
}
BENCHMARK(Height);

/// Making a 50 km world; argument: cell in metres, 0 for the chosen one.
void MakeHills(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(Terrain::make(hills(static_cast<double>(state.range(0))), 50000.0, 50000.0, 0.0));
}
BENCHMARK(MakeHills)->Arg(0)->Arg(30)->Arg(60)->Unit(benchmark::kMillisecond)->UseRealTime();

/// One tick of 1,000 meandering vehicles on hills with a sea.
void VehiclesTick(benchmark::State& state) {
  const Terrain ground = *Terrain::make(hills(0.0), 30000.0, 30000.0, 0.0);
  Scenario scenario;
  scenario.world.size_x_m = scenario.world.size_z_m = 30000.0;
  VehicleGroup group;
  group.id = "g";
  group.type = 51;
  group.count = 1000;
  group.to = {30000.0, 30000.0};
  scenario.groups = {group};
  std::vector<VehicleRecord> records;
  world::Vehicles vehicles = std::move(*world::Vehicles::make(scenario, ground, records));
  std::int64_t tick = 0;
  for (auto _ : state) vehicles.step(tick++);
  std::size_t legs = 0;
  for (const VehicleRecord& record : records) legs += record.track.legs.size();
  state.counters["legs_per_minute"] = static_cast<double>(legs) / 1000.0 / (static_cast<double>(tick) * kMissionTick_s / 60.0);
}
BENCHMARK(VehiclesTick)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
