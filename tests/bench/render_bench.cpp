// Drawing, read-back and PNG on the offscreen driver. CPU time is that of all threads together, which other work on the
// machine disturbs least.
#include "app/gl/context.h"
#include "app/render/png_encoder.h"
#include "app/render/renderer.h"
#include "tests/support/scene.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>

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

BENCHMARK_MAIN();
