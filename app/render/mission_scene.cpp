#include "app/render/mission_scene.h"

#include "app/render/ground_picture.h"
#include "app/render/mission_bursts.h"
#include "app/render/mission_models.h"
#include "app/render/mission_overlays.h"
#include "app/render/mission_smoke.h"
#include "app/render/model_pass.h"
#include "app/render/overlay_pass.h"
#include "app/render/stroke_pass.h"
#include "app/render/terrain_pass.h"
#include "sim/world/scenario_files.h"

#include <algorithm>
#include <cmath>
#include <thread>

namespace npsee::render {
namespace {

using Kind = MissionCamera::Kind;

/// What a map shows: no haze, daylight.
MissionLight mapLight() {
  MissionLight light;
  light.visibility_m = 0.0;
  return light;
}

/// The hour's light and air. An observer sees through the air as it is; a camera that nobody stands behind sees at least what it
/// looks at.
MissionLight lightFor(const Recording& recording, double time_s, const MissionCamera& camera, const MissionEye& eye) {
  MissionLight light = lightAt(recording, time_s);
  constexpr double kMostAir = 0.5;  // optical depth to the subject
  const double distance_m = camera.kind == Kind::observer ? 0.0 : camera.kind == Kind::free ? length(camera.target - eye.lens.eye) : camera.distance_m;
  light.visibility_m = std::max(light.visibility_m, 3.912 * distance_m / kMostAir);
  return light;
}

TerrainLines linesOf(const MissionView& view, const MissionEye& eye) {
  TerrainLines lines;
  lines.strength = view.overlays.contours ? 1.0 : 0.0;
  lines.map = eye.kind == Kind::plan;
  if (!lines.map) return lines;
  // About ten grid lines from edge to edge, and contours that stay apart.
  const double span = view.camera.span_m;
  lines.grid_m = span < 1500.0 ? 100.0 : span < 15000.0 ? 1000.0 : span < 60000.0 ? 5000.0 : 10000.0;
  lines.contour_m = span < 3000.0 ? 5.0 : span < 9000.0 ? 10.0 : span < 30000.0 ? 20.0 : 50.0;
  return lines;
}

/// The glow of an observer's naked eye needs no reticle; binoculars have one.
double circleRadius(const MissionEye& eye) { return 0.5 * kCircleShare * std::min(eye.width, eye.height); }

}  // namespace

struct MissionScene::Impl {
  TerrainModel ground;
  Weapons weapons;
  MissionBursts bursts;
  Counts counts;
  // Made with the first picture.
  struct Passes {
    gl::Program sky;
    gl::VertexArray nothing;
    TerrainPass terrain;
    ModelPass models;
    OverlayPass overlay;
    StrokePass strokes;
    GroundPicture kept;
  };
  std::unique_ptr<Passes> passes;
  struct Fan {
    Vec3 eye;
    double range_m = -1.0;
    const float* ground = nullptr;
    std::vector<GroundCorner> corners;
  } fan;
  std::vector<AreaVertex> areas;
  std::vector<StrokeVertex> strokes;

  Expected<void> makePasses();
  void drawSky(const View& view, const MissionEye& eye, const MissionLight& light) const;
  void drawGround(const GroundKey& key, const View& view, const MissionEye& eye);
  void drawAreas(const std::vector<GroundCorner>& corners, const MissionEye& eye, const View& view, double extinction_per_m, double nearer);
  void drawFan(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const View& at_origin);
  void drawOverlays(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const MissionEye& whole, const View& at_origin, bool night);
};

Expected<void> MissionScene::Impl::makePasses() {
  if (passes) return {};
  auto made = std::make_unique<Passes>();
  const auto take = [](auto pass, auto& slot) -> Expected<void> {
    if (!pass) return tl::unexpected<Error>(pass.error());
    slot = std::move(*pass);
    return {};
  };
  if (auto done = take(gl::Program::fromFiles("fullscreen.vert", "mission_sky.frag"), made->sky); !done) return done;
  if (auto done = take(TerrainPass::create(), made->terrain); !done) return done;
  if (auto done = take(ModelPass::create(), made->models); !done) return done;
  if (auto done = take(OverlayPass::create(), made->overlay); !done) return done;
  if (auto done = take(StrokePass::create(), made->strokes); !done) return done;
  made->nothing = gl::VertexArray::make();
  passes = std::move(made);
  return {};
}

void MissionScene::Impl::drawSky(const View& view, const MissionEye& eye, const MissionLight& light) const {
  // After the ground, at the far plane: only what is left of the picture is shaded.
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  passes->sky.use();
  setView(passes->sky, view);
  setLight(passes->sky, light, eye.lens.eye);
  passes->sky.set("u_depth", 1.0f);
  glBindVertexArray(passes->nothing.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void MissionScene::Impl::drawGround(const GroundKey& key, const View& view, const MissionEye& eye) {
  if (passes->kept.restore(key)) return;
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  passes->terrain.draw(ground, eye.lens.eye, view, key.width, key.height, key.light, key.lines);
  drawSky(view, eye, key.light);
  passes->kept.drawn(key);
}

void MissionScene::Impl::drawAreas(const std::vector<GroundCorner>& corners, const MissionEye& eye, const View& view, double extinction_per_m, double nearer) {
  areas.clear();
  for (const GroundCorner& corner : corners) {
    const Vec3 from = (1.0 - nearer) * (corner.at - eye.lens.eye);
    areas.push_back({{static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(from.z)}, corner.colour});
  }
  passes->overlay.drawAreas(areas, view, extinction_per_m);
}

void MissionScene::Impl::drawFan(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const View& at_origin) {
  if (!view.overlays.sight_fan || recording.observers.empty()) return;
  const std::size_t index = view.overlays.observer >= 0 && static_cast<std::size_t>(view.overlays.observer) < recording.observers.size() ? static_cast<std::size_t>(view.overlays.observer) : 0;
  double range = 4000.0;
  for (const ObserverSetup& setup : recording.scenario.observers)
    if (setup.id == recording.observers[index].id) range = setup.max_range_m;
  if (recording.scenario.world.weather.night) range *= recording.scenario.world.weather.night_range;
  const Vec3 from = recording.observerEye(index, time_s);
  const float* samples = recording.terrain.heights().data();
  if (fan.eye != from || fan.range_m != range || fan.ground != samples) fan = {from, range, samples, sightFan(recording.terrain, from, std::max(range, 10.0))};
  drawAreas(fan.corners, eye, at_origin, 0.0, 0.005);
}

/// `whole` is the eye of the picture, `eye` that of what it is drawn into.
void MissionScene::Impl::drawOverlays(const Recording& recording, double time_s, const MissionView& view, const MissionEye& eye, const MissionEye& whole, const View& at_origin, bool night) {
  drawFan(recording, time_s, view, eye, at_origin);
  const OverlayDrawing overlays = overlaysOf(recording, time_s, view, whole, marksOf(recording, time_s, view, whole), weapons);
  strokes.clear();
  addStrokes(overlays.ground, whole, strokes);
  passes->strokes.draw(strokes, StrokePass::Hiding::by_depth);
  strokes.clear();
  addStrokes(overlays.screen, whole.width, whole.height, strokes);
  if (eye.reticle) {
    addStrokes(reticleOf(whole, view.camera.field_mil, night), whole.width, whole.height, strokes);
    passes->overlay.drawMask(eye.width, eye.height, circleRadius(eye));
  }
  passes->strokes.draw(strokes, StrokePass::Hiding::none);
}

Expected<std::unique_ptr<MissionScene>> MissionScene::make(const Recording& recording) {
  auto impl = std::make_unique<Impl>();
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  impl->ground = TerrainModel::make(recording.terrain, threads);
  auto weapons = world::missionWeapons(recording.scenario);
  if (!weapons) return tl::unexpected<Error>(weapons.error());
  impl->weapons = std::move(*weapons);
  return std::unique_ptr<MissionScene>(new MissionScene(std::move(impl)));
}

MissionScene::MissionScene(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
MissionScene::~MissionScene() = default;

std::vector<MissionMark> MissionScene::marks(const Recording& recording, double time_s, const MissionView& view, int width, int height) const {
  return marksOf(recording, time_s, view, missionEye(recording, time_s, view.camera, width, height));
}

const std::vector<std::string>& MissionScene::warnings() const { return impl_->bursts.warnings(); }
const MissionScene::Counts& MissionScene::counts() const { return impl_->counts; }

Expected<void> MissionScene::draw(EffectPasses& effects, const Recording& recording, double time_s, const MissionView& view, int width, int height, const MissionLook& look, TileMask& bright) {
  Impl& own = *impl_;
  if (auto made = own.makePasses(); !made) return made;
  if (!own.ground.of(recording.terrain)) {
    own.ground = TerrainModel::make(recording.terrain, view.threads);
    own.passes->terrain.forget();
    own.passes->kept.forget();
  }
  // Lines, marks and the least size of models count in the picture's pixels, whatever it is drawn into.
  MissionEye whole = missionEye(recording, time_s, view.camera, width, height);
  whole.lens.aside_x = look.aside_x;
  whole.lens.aside_y = look.aside_y;
  MissionEye eye = whole;
  eye.width = look.width;
  eye.height = look.height;
  const View at_origin = eye.view();
  const bool map = eye.kind == Kind::plan;
  const MissionLight light = map ? mapLight() : lightFor(recording, time_s, view.camera, eye);

  own.drawGround({eye.lens, eye.width, eye.height, boundSamples(), light, linesOf(view, eye), recording.terrain.heights().data()}, at_origin, eye);
  if (view.overlays.scorch) own.drawAreas(scorchMarks(recording, time_s, eye), eye, at_origin, extinctionOf(light.visibility_m), 0.003);
  own.bursts.prepare(recording, time_s, view, whole, light, own.passes->models);
  const std::vector<ModelInstance> models = missionModels(recording, time_s, view, whole, own.passes->models, own.bursts.inPieces());
  own.drawAreas(modelShadows(recording, models, whole, own.passes->models), eye, at_origin, extinctionOf(light.visibility_m), 0.002);
  own.passes->models.draw(models, eye.lens.eye, at_origin, light);
  if (auto drawn = own.bursts.drawOpaque(effects, eye); !drawn) return drawn;
  if (auto drawn = own.bursts.drawBlended(effects, eye); !drawn) return drawn;
  if (!map) own.bursts.markBright(bright, eye);
  own.drawOverlays(recording, time_s, view, eye, whole, at_origin, light.night);
  own.counts = {own.passes->terrain.tiles(), models.size(), own.bursts.count(), own.bursts.particles(), own.bursts.compiled()};
  return {};
}

}  // namespace npsee::render
