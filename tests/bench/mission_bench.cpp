#include <npsee/mission.h>

#include <benchmark/benchmark.h>

#include <cmath>

namespace npsee {
namespace {

/// Vehicles on hills, half of them hostile and all wandering, observers and guns spread among them.
Scenario crowd(int vehicles, int observers, int guns) {
  Scenario sc;
  sc.duration_s = 3600.0;
  sc.world.size_x_m = sc.world.size_z_m = 20000.0;
  sc.world.terrain.kind = TerrainKind::hills;
  sc.world.terrain.sea_fraction = 0.0;
  sc.world.terrain.cell_m = 30.0;
  sc.world.sea_level_m = -1000.0;
  sc.groups.push_back({.id = "red", .type = 51, .count = vehicles / 2, .from = {500, 500}, .to = {19500, 19500}});
  sc.groups.push_back({.id = "blue", .type = 8, .count = vehicles - vehicles / 2, .from = {500, 500}, .to = {19500, 19500}});
  for (int b = 0; b < guns / 4; ++b) {
    BatterySetup battery;
    battery.id = "b" + std::to_string(b);
    battery.rounds = 100000;
    for (int g = 0; g < 4; ++g) battery.guns.push_back({battery.id + "-" + std::to_string(g), {2000.0 + 3000.0 * b, 9000.0 + 60.0 * g}});
    sc.batteries.push_back(battery);
  }
  for (int o = 0; o < observers; ++o) {
    ObserverSetup observer;
    observer.id = "o" + std::to_string(o);
    observer.at = {1000.0 + 900.0 * o, 10000.0 + (o % 5) * 1500.0};
    observer.missions = {{MissionAction::destroy, 51}};
    sc.observers.push_back(observer);
  }
  return sc;
}

/// Simulated seconds per second of one core.
void mission(benchmark::State& state) {
  const Scenario sc = crowd(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), static_cast<int>(state.range(2)));
  double simulated = 0.0;
  std::size_t events = 0, shells = 0;
  for (auto _ : state) {
    state.PauseTiming();
    auto made = Mission::make(sc);
    if (!made) {
      state.SkipWithError(made.error().text().c_str());
      break;
    }
    state.ResumeTiming();
    made->advance(60.0);
    simulated += made->now();
    events = made->recording().events.size();
    shells = made->recording().shells.size();
  }
  state.counters["times_real_time"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
  state.counters["events"] = static_cast<double>(events);
  state.counters["shells"] = static_cast<double>(shells);
}
BENCHMARK(mission)->Args({10, 1, 4})->Args({1000, 20, 24})->ArgNames({"vehicles", "observers", "guns"})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace npsee

BENCHMARK_MAIN();
