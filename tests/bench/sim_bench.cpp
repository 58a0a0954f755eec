#include <npsee/explosion.h>

#include <benchmark/benchmark.h>

namespace npsee {
namespace {

/// The measured case: fragments with drag and up to eight bounces, seven arcs each on average.
Preset bouncing(std::int64_t count) {
  Preset preset;
  preset.layers.emplace_back();
  Layer& layer = preset.layers[0];
  layer.count = count;
  layer.drag_ps = 0.15;
  layer.restitution = 0.55;
  layer.friction = 0.2;
  layer.bounce_limit = 8;
  layer.rest_speed_mps = 0.5;
  layer.lifetime_mean_s = 12.0;
  layer.lifetime_deviation_s = 1.0;
  return preset;
}

void perParticle(benchmark::State& state, std::int64_t count) {
  state.counters["s_per_particle"] = benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void compile(benchmark::State& state) {
  const Preset preset = bouncing(state.range(0));
  std::size_t bytes = 0;
  for (auto _ : state) {
    const auto explosion = *Explosion::compile(preset, std::nullopt, nullptr, {.threads = 1, .force_baseline = state.range(1) == 0});
    bytes = explosion->memoryBytes();
  }
  perParticle(state, state.range(0));
  state.counters["bytes_per_particle"] = static_cast<double>(bytes) / static_cast<double>(state.range(0));
}
BENCHMARK(compile)->ArgNames({"particles", "avx2"})->Args({100, 1})->Args({100000, 0})->Args({100000, 1})->Args({1000000, 1})->Unit(benchmark::kMillisecond);

void at(benchmark::State& state, unsigned fields, double turbulence_m) {
  Preset preset = bouncing(state.range(0));
  preset.layers[0].turbulence_m = turbulence_m;
  const auto explosion = *Explosion::compile(preset, std::nullopt, nullptr, {.threads = 1, .force_baseline = state.range(1) == 0});
  Frame frame;
  double t = 0.0, bounces = 0.0;
  for (auto _ : state) {
    // Times all over the effect, as scrubbing asks for them.
    t += 3.7;
    if (t > 12.0) t -= 12.0;
    explosion->at(t, frame, fields);
    benchmark::DoNotOptimize(frame.y.data());
    benchmark::ClobberMemory();
  }
  explosion->at(11.0, frame, kAllFields);
  for (std::size_t i = 0; i < frame.count; ++i) bounces += frame.bounces[i];
  state.counters["mean_bounces"] = bounces / static_cast<double>(frame.count);
  perParticle(state, state.range(0));
}
BENCHMARK_CAPTURE(at, positions, kPosition, 0.0)->ArgNames({"particles", "avx2"})->Args({1000, 0})->Args({1000, 1})->Args({10000, 1})->Args({100000, 0})->Args({100000, 1})->Args({1000000, 1});
BENCHMARK_CAPTURE(at, positions_velocities, kVelocity, 0.0)->ArgNames({"particles", "avx2"})->Args({100000, 0})->Args({100000, 1});
BENCHMARK_CAPTURE(at, everything, kAllFields, 0.0)->ArgNames({"particles", "avx2"})->Args({100000, 0})->Args({100000, 1});
BENCHMARK_CAPTURE(at, everything_in_eddies, kAllFields, 1.5)->ArgNames({"particles", "avx2"})->Args({100000, 0})->Args({100000, 1});

/// A model of about 2,000 triangles: cutting alone, and a layer of its pieces.
void cutModel(benchmark::State& state) {
  const SolidModel model = *findSolidModel("house", {});
  for (auto _ : state) benchmark::DoNotOptimize(cutToPieces(model, state.range(0), 1000.0, {1993, 1}));
}
BENCHMARK(cutModel)->Arg(20)->Arg(200)->Arg(2000)->Unit(benchmark::kMillisecond);

void comeApart(benchmark::State& state) {
  Preset preset;
  preset.layers.emplace_back();
  preset.layers[0].form = Form::pieces;
  preset.layers[0].pieces_model = "house";
  preset.layers[0].count = state.range(0);
  for (auto _ : state) benchmark::DoNotOptimize(Explosion::compile(preset));
}
BENCHMARK(comeApart)->Arg(200)->Arg(2000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace npsee

BENCHMARK_MAIN();
