// Drawing, read-back and PNG on the offscreen driver. CPU time is that of all threads together, which other work on the
// machine disturbs least.
#include "app/gl/context.h"
#include "app/render/png_encoder.h"
#include "app/render/renderer.h"
#include "app/render/shipped_assets.h"
#include "app/render/smoke_shade.h"
#include "app/render/smoke_shadow.h"
#include "tests/support/scene.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace npsee::render {
namespace {

constexpr int kWidth = 1280, kHeight = 720;

Renderer& renderer() {
  static const auto context = gl::makeOffscreenContext();
  if (!context) {
    std::fprintf(stderr, "%s\n", context.error().text().c_str());
    std::exit(4);
  }
  static auto made = Renderer::create();
  return **made;
}

Scene sceneOf(const test::HandMade& made) {
  Scene scene;
  scene.frame = &made.frame;
  scene.layers = made.layers;
  scene.ground_colour = {0.36, 0.34, 0.29};
  return scene;
}

const Camera kCamera = framing({{-20.0, 0.0, -20.0}, {20.0, 20.0, 20.0}}, static_cast<double>(kWidth) / kHeight);

void drawTetrahedra(benchmark::State& state) {
  test::HandMade made;
  made.addDome(Form::tetrahedron, static_cast<std::size_t>(state.range(0)), 20.0, 0.4);
  const Scene scene = sceneOf(made);
  Image image;
  for (auto _ : state)
    if (!renderer().drawToImage(scene, kCamera, kWidth, kHeight, image)) state.SkipWithError("not drawn");
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(drawTetrahedra)->Arg(0)->Arg(100)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void drawForm(benchmark::State& state) {
  test::HandMade made;
  made.addDome(static_cast<Form>(state.range(0)), 1000, 20.0, 1.0, {0.6, 0.5, 0.4}, 0.6);
  const Scene scene = sceneOf(made);
  Image image;
  for (auto _ : state)
    if (!renderer().drawToImage(scene, kCamera, kWidth, kHeight, image)) state.SkipWithError("not drawn");
}
BENCHMARK(drawForm)->DenseRange(0, 9)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

/// A shipped preset at the busiest of its times.
struct Busy {
  std::string name;
  Preset preset;
  std::shared_ptr<const Explosion> explosion;
  double time_s = 0.0;

  Scene scene(const Frame& frame) const {
    Scene scene;
    scene.frame = &frame;
    scene.layers = explosion->layers();
    scene.ground_height_m = preset.ground_height_m;
    scene.ground_colour = preset.ground_colour;
    return scene;
  }
  Camera camera() const { return framing(explosion->extent(), static_cast<double>(kWidth) / kHeight); }
};

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// The time that takes longest of twenty.
void findBusiest(Busy& busy) {
  Image image;
  Frame frame;
  double longest = 0.0;
  for (int i = 0; i < 20; ++i) {
    const double time_s = busy.explosion->duration_s() * (i + 0.5) / 20.0;
    busy.explosion->at(time_s, frame, kSceneFields, 2);
    const double begin = seconds();
    if (!renderer().drawToImage(busy.scene(frame), busy.camera(), kWidth, kHeight, image)) continue;
    if (const double took = seconds() - begin; took > longest) {
      longest = took;
      busy.time_s = time_s;
    }
  }
}

const std::vector<Busy>& presets() {
  static const std::vector<Busy> all = [] {
    std::vector<Busy> out;
    for (const ShippedAsset& asset : shippedPresets()) {
      auto preset = parsePreset(asset.text, asset.name);
      if (!preset) continue;
      auto explosion = Explosion::compile(*preset);
      if (!explosion) continue;
      out.push_back({std::string(asset.name), std::move(*preset), *explosion, 0.0});
    }
    std::ranges::sort(out, {}, &Busy::name);
    return out;
  }();
  return all;
}

/// A frame as `npsee render` makes it: particles, drawing, read-back. `particles` is the share of the wall time that the simulator takes; the
/// other counters are milliseconds of the passes, each waited for, which together take a little longer than the frame.
void drawPreset(benchmark::State& state, Busy busy, Quality quality) {
  findBusiest(busy);
  Image image;
  Frame frame;
  double simulated = 0.0;
  const double begin = seconds();
  for (auto _ : state) {
    const double before = seconds();
    busy.explosion->at(busy.time_s, frame, kSceneFields, 2);
    simulated += seconds() - before;
    Scene scene = busy.scene(frame);
    scene.quality = quality;
    if (!renderer().drawToImage(scene, busy.camera(), kWidth, kHeight, image)) state.SkipWithError("not drawn");
  }
  state.counters["particles"] = simulated / std::max(seconds() - begin, 1e-9);
  state.counters["at_s"] = busy.time_s;
  double last = 0.0;
  std::map<std::string, double> passes;
  renderer().watchPasses([&](std::string_view pass) {
    const double now = seconds();
    passes["ms_" + std::string(pass)] += 1e3 * (now - last);
    last = now;
  });
  for (int i = 0; i < 3; ++i) {
    Scene scene = busy.scene(frame);
    scene.quality = quality;
    last = seconds();
    if (!renderer().drawToImage(scene, busy.camera(), kWidth, kHeight, image)) state.SkipWithError("not drawn");
  }
  renderer().watchPasses({});
  for (const auto& [pass, took] : passes) state.counters[pass] = took / 3.0;
}

void registerPresets() {
  for (const Quality quality : {Quality::normal, Quality::draft, Quality::fine})
    for (const Busy& busy : presets())
      benchmark::RegisterBenchmark(("preset/" + std::string(kQualityNames[static_cast<std::size_t>(quality)]) + '/' + busy.name).c_str(), [&busy, quality](benchmark::State& state) { drawPreset(state, busy, quality); })
          ->Unit(benchmark::kMillisecond)
          ->MeasureProcessCPUTime()
          ->UseRealTime()
          ->MinTime(0.3);
}

/// Light inside smoke and its shadow, of so many puffs.
void shadeSmoke(benchmark::State& state) {
  test::HandMade made;
  made.addDome(Form::smoke, static_cast<std::size_t>(state.range(0)), 20.0, 4.0, {0.5, 0.5, 0.5}, 0.5);
  SmokeShade shade;
  SmokeShadowMap map;
  const Vec3 sun{-0.5263, 0.7105, 0.4671};
  for (auto _ : state) {
    shade.build(made.frame, made.layers, sun);
    mapSmokeShadow(made.frame, made.layers, {}, sun, map);
    for (std::size_t i = 0; i < made.frame.count; ++i) benchmark::DoNotOptimize(shade.at({static_cast<double>(made.frame.x[i]), static_cast<double>(made.frame.y[i]), static_cast<double>(made.frame.z[i])}, 2.0));
  }
}
BENCHMARK(shadeSmoke)->Arg(100)->Arg(2000)->Arg(20000)->Unit(benchmark::kMillisecond);

void encodePicture(benchmark::State& state) {
  test::HandMade made;
  made.addDome(Form::tetrahedron, static_cast<std::size_t>(state.range(0)), 20.0, 0.4);
  const auto image = renderer().drawToImage(sceneOf(made), kCamera, kWidth, kHeight);
  std::size_t bytes = 0;
  for (auto _ : state) bytes = encodePng(*image)->size();
  state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(encodePicture)->Arg(100)->Arg(10000)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

/// Two pictures in turn that share sky and ground, as those of a sequence do.
void encodeSequence(benchmark::State& state) {
  std::vector<Image> images;
  for (const double size_m : {0.4, 0.5}) {
    test::HandMade made;
    made.addDome(Form::tetrahedron, static_cast<std::size_t>(state.range(0)), 20.0, size_m);
    images.push_back(std::move(*renderer().drawToImage(sceneOf(made), kCamera, kWidth, kHeight)));
  }
  PngEncoder encoder;
  std::size_t bytes = 0, turn = 0;
  for (auto _ : state) bytes = encoder.encode(images[++turn % 2])->size();
  state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(encodeSequence)->Arg(100)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void startContextAndFirstPicture(benchmark::State& state) {
  test::HandMade made;
  made.addDome(Form::tetrahedron, 100, 20.0, 0.4);
  for (auto _ : state) {
    auto context = gl::makeOffscreenContext();
    auto fresh = Renderer::create();
    benchmark::DoNotOptimize((*fresh)->drawToImage(sceneOf(made), kCamera, kWidth, kHeight));
  }
}
// Last: it leaves the process without the context the others share.
BENCHMARK(startContextAndFirstPicture)->Iterations(5)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace npsee::render

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  npsee::render::registerPresets();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
