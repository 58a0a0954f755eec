// Flights, batches and elevation solutions of the M107. Run by hand: bench_ballistics.

#include <npsee/aiming.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

namespace {

using namespace npsee;

double mil(double value) { return value * kTwoPi / 6400.0; }

Ballistics model(double tolerance_m) {
  Integration integration;
  integration.tolerance_m = tolerance_m;
  return *Ballistics::make(*findProjectile("m107"), {}, FlightModel::modified_point_mass, integration);
}

Shot charge7(double elevation_mil) {
  Shot shot;
  shot.speed_mps = 568.0;
  shot.elevation_rad = mil(elevation_mil);
  return shot;
}

/// Distance of the impact from that at a tolerance of a nanometre, m.
double error(const Ballistics& ballistics, const Shot& shot) {
  const Flight here = ballistics.fly(shot), exact = model(1e-9).fly(shot);
  return std::hypot(here.range_m - exact.range_m, here.drift_m - exact.drift_m);
}

/// One 7W flight at 533.33 mil; argument: tolerance in micrometres.
void OneFlight(benchmark::State& state) {
  const Ballistics ballistics = model(1e-6 * static_cast<double>(state.range(0)));
  const Shot shot = charge7(533.33);
  for (auto _ : state) benchmark::DoNotOptimize(ballistics.fly(shot));
  state.counters["error_m"] = error(ballistics, shot);
  state.counters["evaluations"] = ballistics.fly(shot).evaluations;
}
BENCHMARK(OneFlight)->Arg(300)->Arg(1000)->Unit(benchmark::kMicrosecond);

/// A batch of 7W flights from 300 to 900 mil on one thread; argument: tolerance in micrometres.
void Batch(benchmark::State& state) {
  const Ballistics ballistics = model(1e-6 * static_cast<double>(state.range(0)));
  std::vector<Shot> shots;
  for (int i = 0; i < 4096; ++i) shots.push_back(charge7(300.0 + 600.0 * i / 4096));
  std::vector<Flight> flights(shots.size());
  for (auto _ : state) {
    ballistics.flyMany(shots, flights, 1);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(shots.size()) * state.iterations());
  double worst = 0.0;
  for (std::size_t i = 0; i < shots.size(); i += 256) worst = std::max(worst, error(ballistics, shots[i]));
  state.counters["worst_error_m"] = worst;
}
BENCHMARK(Batch)->Arg(300)->Arg(1000)->Unit(benchmark::kMillisecond);

/// The same batch on all cores.
void BatchOnAllCores(benchmark::State& state) {
  const Ballistics ballistics = model(1e-3);
  std::vector<Shot> shots;
  for (int i = 0; i < 16384; ++i) shots.push_back(charge7(300.0 + 600.0 * i / 16384));
  std::vector<Flight> flights(shots.size());
  for (auto _ : state) ballistics.flyMany(shots, flights, 0);
  state.SetItemsProcessed(static_cast<std::int64_t>(shots.size()) * state.iterations());
}
BENCHMARK(BatchOnAllCores)->Unit(benchmark::kMillisecond)->UseRealTime();

AimRequest request(double speed_mps) {
  AimRequest out;
  out.speed_mps = speed_mps;
  return out;
}

/// An elevation for a range from nothing: the maximum is found first. Argument: muzzle velocity.
void ElevationFromNothing(benchmark::State& state) {
  const Ballistics ballistics = model(1e-3);
  const AimRequest aim = request(static_cast<double>(state.range(0)));
  const double range = 0.7 * Aimer::make(ballistics, aim)->maxRange();
  for (auto _ : state) benchmark::DoNotOptimize(Aimer::make(ballistics, aim)->low(range));
}
BENCHMARK(ElevationFromNothing)->Arg(297)->Arg(568)->Unit(benchmark::kMicrosecond);

/// Further ranges with the same charge.
void ElevationWithKnownMaximum(benchmark::State& state) {
  const Ballistics ballistics = model(1e-3);
  const Aimer aimer = *Aimer::make(ballistics, request(static_cast<double>(state.range(0))));
  double share = 0.3, worst = 0.0;
  for (auto _ : state) {
    share = share > 0.98 ? 0.3 : share + 0.0173;
    const auto solution = aimer.low(share * aimer.maxRange());
    worst = std::max(worst, solution->miss_m);
  }
  state.counters["worst_miss_m"] = worst;
}
BENCHMARK(ElevationWithKnownMaximum)->Arg(297)->Arg(568)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
