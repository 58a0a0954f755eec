#include "app/render/mission_overlays.h"
#include "app/render/mission_scene.h"
#include "tests/support/missions.h"
#include "tests/support/rendering.h"

#include <npsee/units.h>

#include <gtest/gtest.h>

#include <cmath>

namespace npsee::render {
namespace {

class Missions : public test::Rendering {
 protected:
  static Image draw(const Recording& recording, double time_s, const MissionView& view, int width = 480, int height = 270) {
    auto scene = MissionScene::make(recording);
    EXPECT_TRUE(scene) << (scene ? "" : scene.error().text());
    Image image;
    if (scene) {
      const auto drawn = renderer_->drawToImage(**scene, recording, time_s, view, width, height, image);
      EXPECT_TRUE(drawn) << (drawn ? "" : drawn.error().text());
    }
    return image;
  }
};

using test::brightness;

Terrain cone() {
  TerrainSource source;
  source.kind = TerrainKind::function;
  source.expression = "cone";
  source.params = {{"top_x", 2000.0}, {"top_z", 2000.0}, {"top_height", 500.0}, {"radius", 1200.0}, {"base_height", 20.0}};
  return test::terrainOf(source, 4000.0);
}

MissionView fromAbove(const Vec3& target, double span_m) {
  MissionView view;
  view.camera.kind = MissionCamera::Kind::plan;
  view.camera.target = target;
  view.camera.span_m = span_m;
  view.overlays.contours = false;
  view.overlays.icons = false;
  return view;
}

TEST_F(Missions, SlopesTurnedToTheSunAreBrighter) {
  const test::HandRecording made(cone());
  const Image image = draw(made.recording, 0.0, fromAbove({2000.0, 0.0, 2000.0}, 3000.0));
  // The sun stands in the south-west: the cone's flank there against the one in the north-east.
  double lit = 0.0, shaded = 0.0;
  for (int k = 20; k < 60; ++k) {
    lit += brightness(image.pixel(240 - k, 135 + k));
    shaded += brightness(image.pixel(240 + k, 135 - k));
  }
  EXPECT_GT(lit, 1.3 * shaded);
}

TEST_F(Missions, TheSeaCoversWhatLiesBelowItsLevel) {
  TerrainSource source;
  source.kind = TerrainKind::function;
  source.expression = "slope";
  source.params = {{"from", 1900.0}, {"to", 2100.0}, {"low", -30.0}, {"high", 30.0}};
  const test::HandRecording made(test::terrainOf(source, 4000.0));
  const Image image = draw(made.recording, 0.0, fromAbove({2000.0, 0.0, 2000.0}, 1000.0));
  // West of the shore at x = 2000 the sea is blue, east of it the land is not.
  for (int y = 20; y < 250; y += 10) {
    const std::uint8_t *sea = image.pixel(140, y), *land = image.pixel(340, y);
    EXPECT_GT(sea[2], sea[0] + 10) << y;
    EXPECT_GT(land[0], land[2]) << y;
  }
}

TEST_F(Missions, NoSkyIsSeenThroughTheGround) {
  TerrainSource source;
  source.kind = TerrainKind::hills;
  source.relief_m = 600.0;
  source.scale_m = 3000.0;
  source.sea_fraction = 0.0;
  source.seed = 3;
  const Terrain terrain = test::terrainOf(source, 15000.0, -100.0);
  const test::HandRecording made(terrain);
  MissionView view;
  view.camera.kind = MissionCamera::Kind::free;
  view.camera.eye = {7000.0, terrain.surface(7000.0, 7000.0) + 500.0, 7000.0};
  view.camera.target = view.camera.eye + Vec3{300.0, -400.0, -500.0};
  view.overlays = {};
  view.smooth = false;
  const Image image = draw(made.recording, 0.0, view);
  // The sky is the only thing here that is bluer than it is red.
  int holes = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) holes += image.pixel(x, y)[2] > image.pixel(x, y)[0] + 25;
  EXPECT_EQ(holes, 0);
}

TEST_F(Missions, TheSameMomentGivesTheSameBytesWhateverWasDrawnBefore) {
  test::HandRecording made(cone());
  made.vehicle(1500.0, 3300.0, Side::hostile);
  made.observer(800.0, 3600.0);
  made.burst({1500.0, made.recording.terrain.surface(1500.0, 3350.0), 3350.0}, 3.0, "air_burst");
  MissionView view;
  view.camera.target = {1500.0, 40.0, 3300.0};
  view.camera.distance_m = 200.0;
  const Image first = draw(made.recording, 3.5, view);
  auto scene = MissionScene::make(made.recording);
  ASSERT_TRUE(scene);
  Image image;
  for (const double t : {0.0, 10.0, 3.2}) ASSERT_TRUE(renderer_->drawToImage(**scene, made.recording, t, fromAbove({2000.0, 0.0, 2000.0}, 3000.0), 200, 200, image));
  view.threads = 3;
  ASSERT_TRUE(renderer_->drawToImage(**scene, made.recording, 3.5, view, 480, 270, image));
  EXPECT_EQ(image.rgba, first.rgba);
}

/// A preset of one particle that neither moves nor fades.
std::shared_ptr<const Preset> still(Form form, double size_m, const Colour& colour) {
  auto preset = std::make_shared<Preset>();
  preset->layers.emplace_back();
  Layer& layer = preset->layers[0];
  layer.form = form;
  layer.region_shape = RegionShape::point;
  layer.count = 1;
  layer.speed_mean_mps = layer.speed_deviation_mps = 0.0;
  layer.trajectory = Trajectory::linear;
  layer.collide = false;
  layer.size_mean_m = size_m;
  layer.size_deviation_m = 0.0;
  layer.lifetime_mean_s = 10.0;
  layer.lifetime_deviation_s = 0.0;
  layer.colour = colour;
  layer.colour_variation = 0.0;
  layer.size_over_life = layer.opacity_over_life = {{0.0, 1.0}, {1.0, 1.0}};
  return preset;
}

TEST_F(Missions, BurntGroundAndBlastFrontsLieOnTheHillside) {
  // On the southern flank, which rises by 500 m in 1200 m.
  test::HandRecording made(cone());
  const Vec3 at{2000.0, made.recording.terrain.surface(2000.0, 2700.0), 2700.0};
  made.burst(at, 3.0, "classic_1993");
  MissionView view;
  view.overlays = {};
  view.overlays.scorch = false;
  view.camera.kind = MissionCamera::Kind::free;
  // Looking along the slope's normal.
  view.camera.eye = at + Vec3{0.0, 110.0, 46.0};
  view.camera.target = at;
  const auto shown = [&](const std::shared_ptr<const Preset>& preset) {
    view.presets[1] = preset;
    return draw(made.recording, 4.0, view);
  };
  const Image bare = shown(still(Form::streak, 0.0, {})), burnt = shown(still(Form::scorch, 30.0, {0.05, 0.04, 0.04})), ring = shown(still(Form::shock, 40.0, {1.0, 1.0, 1.0}));
  EXPECT_LT(brightness(burnt.pixel(240, 135)), 0.6 * brightness(bare.pixel(240, 135)));
  // A camera that looks at the patch head on sees it round: the ground was followed.
  int across = 0, along = 0;
  for (int k = -110; k <= 110; ++k) {
    across += brightness(burnt.pixel(240 + k, 135)) < 0.85 * brightness(bare.pixel(240 + k, 135));
    along += brightness(burnt.pixel(240, 135 + k)) < 0.85 * brightness(bare.pixel(240, 135 + k));
  }
  EXPECT_GT(across, 30);
  EXPECT_NEAR(along, across, 0.45 * across);
  int bright = 0, right = 0;
  for (int k = 5; k < 200; ++k)
    if (brightness(ring.pixel(240 + k, 135)) > brightness(bare.pixel(240 + k, 135)) + 8) ++bright, right = k;
  EXPECT_GT(bright, 1);
  EXPECT_GT(right, 30);
  EXPECT_NEAR(brightness(ring.pixel(240, 135)), brightness(bare.pixel(240, 135)), 3) << "its middle stays as it is";
}

TEST_F(Missions, TheSeaDoesNotBurn) {
  TerrainSource source;
  source.kind = TerrainKind::function;
  source.expression = "slope";
  source.params = {{"from", 1900.0}, {"to", 2100.0}, {"low", -30.0}, {"high", 30.0}};
  test::HandRecording made(test::terrainOf(source, 4000.0));
  made.burst({1500.0, made.recording.terrain.surface(1500.0, 2000.0), 2000.0}, 3.0, "classic_1993");
  MissionView view = fromAbove({1500.0, 0.0, 2000.0}, 120.0);
  view.overlays = {};
  view.overlays.scorch = false;
  view.presets[1] = still(Form::streak, 0.0, {});
  const Image bare = draw(made.recording, 4.0, view);
  view.presets[1] = still(Form::scorch, 30.0, {0.05, 0.04, 0.04});
  EXPECT_EQ(draw(made.recording, 4.0, view).rgba, bare.rgba);
}

/// Pixels that differ, with their mean place.
struct Difference {
  int count = 0;
  double x = 0.0, y = 0.0;
};
Difference differenceOf(const Image& a, const Image& b) {
  Difference out;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      int most = 0;
      for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]));
      if (most < 12) continue;
      ++out.count;
      out.x += x + 0.5;
      out.y += y + 0.5;
    }
  if (out.count > 0) out.x /= out.count, out.y /= out.count;
  return out;
}

MissionView throughBinoculars() {
  MissionView view;
  view.camera.kind = MissionCamera::Kind::observer;
  view.overlays.contours = false;
  return view;
}

Terrain ridge(double crest_m) {
  TerrainSource source;
  source.kind = TerrainKind::function;
  source.expression = "ridge";
  source.params = {{"crest_x", 2000.0}, {"crest_height", crest_m}, {"foot_before", 200.0}, {"foot_after", 200.0}};
  return test::terrainOf(source, 4000.0, -10.0);
}

TEST_F(Missions, ATargetAKnownNumberOfMilsAsideStandsOnThatTick) {
  for (const int mil : {-40, -15, 10, 30}) {
    test::HandRecording made(test::terrainOf({}, 4000.0, -10.0)), without(test::terrainOf({}, 4000.0, -10.0));
    made.observer(500.0, 2000.0);
    without.observer(500.0, 2000.0);
    const double azimuth = toSi(Unit::mil, 1600.0), at = azimuth + toSi(Unit::mil, mil), range = 1500.0;
    const int target = made.vehicle(500.0 + range * std::sin(at), 2000.0 - range * std::cos(at), Side::hostile, TargetClass::heavy_armor, at);
    MissionView view = throughBinoculars();
    view.camera.turn_rad = azimuth;
    const int width = 1280, height = 720;
    const MissionEye eye = missionEye(made.recording, 0.0, view.camera, width, height);
    const double tick = 0.5 * width + pixelsOfMil(eye, mil);
    const auto seen = eye.project(made.recording.vehiclePlace(static_cast<std::size_t>(target), 0.0) + Vec3{0.0, 2.5, 0.0});
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->x, tick, 0.05) << mil;
    // And in the picture: what the vehicle changes lies around the tick, which is drawn there.
    const Image with = draw(made.recording, 0.0, view, width, height), empty = draw(without.recording, 0.0, view, width, height);
    const Difference vehicle = differenceOf(with, empty);
    ASSERT_GT(vehicle.count, 10) << mil;
    EXPECT_NEAR(vehicle.x, tick, 2.0) << mil;
    double dark = 255.0, beside = 0.0;
    for (int dx = -1; dx <= 1; ++dx) dark = std::min(dark, brightness(empty.pixel(static_cast<int>(tick) + dx, height / 2 - 3)));
    for (const int dx : {-5, 5}) beside = std::max(beside, brightness(empty.pixel(static_cast<int>(tick) + dx, height / 2 - 3)));
    EXPECT_LT(dark, 0.8 * beside) << mil;
  }
}

TEST_F(Missions, TheCircleOfTheBinocularsIsAsWideAsItsField) {
  test::HandRecording made(test::terrainOf({}, 4000.0, -10.0));
  made.observer(500.0, 2000.0);
  MissionView view = throughBinoculars();
  view.camera.field_mil = 100.0;
  const MissionEye eye = missionEye(made.recording, 0.0, view.camera, 640, 360);
  EXPECT_NEAR(pixelsOfMil(eye, 50.0), 0.5 * kCircleShare * 360, 1e-6);
  const Image image = draw(made.recording, 0.0, view, 640, 360);
  EXPECT_LT(brightness(image.pixel(20, 180)), 40.0);
  EXPECT_GT(brightness(image.pixel(320, 60)), 60.0);
}

TEST_F(Missions, AVehicleBehindARidgeIsNotSeenFromTheObserversEye) {
  for (const double crest : {60.0, 0.5}) {
    test::HandRecording made(ridge(crest)), without(ridge(crest));
    made.observer(500.0, 2000.0);
    without.observer(500.0, 2000.0);
    made.vehicle(3000.0, 2000.0, Side::hostile);
    MissionView view = throughBinoculars();
    view.camera.turn_rad = toSi(Unit::mil, 1600.0);
    const Difference seen = differenceOf(draw(made.recording, 0.0, view), draw(without.recording, 0.0, view));
    if (crest > 1.0) {
      EXPECT_EQ(seen.count, 0);
    } else {
      EXPECT_GT(seen.count, 4);
    }
    auto scene = MissionScene::make(made.recording);
    ASSERT_TRUE(scene);
    for (const MissionMark& mark : (*scene)->marks(made.recording, 0.0, view, 480, 270))
      if (mark.kind == MissionMark::Kind::vehicle && mark.index == 1) {
        EXPECT_EQ(mark.hidden, crest > 1.0);
      }
  }
}

TEST_F(Missions, TheFollowingCameraHoldsTheShellInTheMiddle) {
  test::HandRecording made(cone());
  const int gun = made.gun(400.0, 3600.0, 0.8, 0.5);
  made.fire(gun, 2.0, 180.0, "air_burst");
  const ShellRecord& shell = made.recording.shells.front();
  MissionCamera camera;
  camera.kind = MissionCamera::Kind::follow;
  camera.distance_m = 30.0;
  for (const double share : {0.1, 0.5, 0.9}) {
    const double t = shell.fired_s + share * (shell.burst_s - shell.fired_s);
    const MissionEye eye = missionEye(made.recording, t, camera, 640, 360);
    const auto pixel = eye.project(shell.at(t));
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x, 320.0, 0.5) << t;
    EXPECT_NEAR(pixel->y, 180.0, 0.5) << t;
  }
  // The eye never sinks into the ground, from the muzzle to after the burst.
  for (double t = 0.0; t < shell.burst_s + 5.0; t += 0.5) {
    const Vec3 at = missionEye(made.recording, t, camera, 640, 360).lens.eye;
    EXPECT_GT(at.y, made.recording.terrain.surface(at.x, at.z) + 1.0) << t;
  }
}

TEST_F(Missions, ABurstShowsThePresetOfItsShellOrTheOneChosenInstead) {
  test::HandRecording made(test::terrainOf({}, 2000.0, -10.0));
  made.burst({1000.0, 0.0, 1000.0}, 1.0, "classic_1993");
  MissionView view;
  view.camera.target = {1000.0, 5.0, 1000.0};
  view.camera.distance_m = 120.0;
  const Image before = draw(made.recording, 0.5, view), own = draw(made.recording, 1.6, view);
  EXPECT_GT(differenceOf(before, own).count, 50);
  auto other = std::make_shared<Preset>();
  other->layers.emplace_back();
  view.presets[1] = other;
  const Image swapped = draw(made.recording, 1.6, view);
  EXPECT_GT(differenceOf(own, swapped).count, 20);
  view.presets.clear();
  view.presets[7] = other;
  EXPECT_EQ(draw(made.recording, 1.6, view).rgba, own.rgba) << "another shell's";
}

TEST_F(Missions, AStandingCameraGivesTheBytesOfAFreshPicture) {
  test::HandRecording made(cone());
  made.vehicle(1500.0, 3300.0, Side::hostile, TargetClass::heavy_armor, 1.0, 8.0);
  MissionView view;
  view.camera.target = {1500.0, 40.0, 3300.0};
  view.camera.distance_m = 200.0;
  for (const bool smooth : {false, true}) {
    view.smooth = smooth;
    auto scene = MissionScene::make(made.recording);
    ASSERT_TRUE(scene);
    Image image;
    for (const double t : {1.0, 2.0, 3.0, 4.0}) {
      ASSERT_TRUE(renderer_->drawToImage(**scene, made.recording, t, view, 240, 136, image));
      EXPECT_EQ(image.rgba, draw(made.recording, t, view, 240, 136).rgba) << t;
    }
  }
}

TEST_F(Missions, ManyBurstsAtOnceStayBounded) {
  test::HandRecording made(test::terrainOf({}, 4000.0, -10.0));
  for (int i = 0; i < 300; ++i) made.burst({1500.0 + 3.0 * i, 0.0, 2000.0 + 40.0 * std::sin(i)}, 1.0 + 0.001 * i, "dense_fragments");
  MissionView view;
  view.camera.target = {2000.0, 0.0, 2000.0};
  view.camera.distance_m = 1500.0;
  auto scene = MissionScene::make(made.recording);
  ASSERT_TRUE(scene);
  Image image;
  ASSERT_TRUE(renderer_->drawToImage(**scene, made.recording, 2.0, view, 240, 136, image));
  EXPECT_LE((*scene)->counts().bursts, 64u + 64u);
  EXPECT_LT((*scene)->counts().particles, 80000u);
}

TEST_F(Missions, NightIsDarkAndAFlareLightsItsSurroundings) {
  test::HandRecording made(test::terrainOf({}, 8000.0, -10.0));
  const MissionView view = [] {
    MissionView out;
    out.camera.target = {4000.0, 0.0, 4000.0};
    out.camera.distance_m = 500.0;
    out.overlays.contours = false;
    return out;
  }();
  const auto ground = [&](const Image& image) { return brightness(image.pixel(240, 200)); };
  const double day = ground(draw(made.recording, 20.0, view));
  made.recording.scenario.world.weather.night = true;
  const double night = ground(draw(made.recording, 20.0, view));
  EXPECT_LT(night, 0.4 * day);
  made.burst({4000.0, 350.0, 4000.0}, 10.0, "");
  made.recording.shells.back().illumination = true;
  EXPECT_GT(ground(draw(made.recording, 20.0, view)), 1.5 * night);
  EXPECT_NEAR(ground(draw(made.recording, 200.0, view)), night, 1.0) << "burnt out";
}

TEST_F(Missions, FogHidesWhatIsFarAndNotWhatIsNear) {
  test::HandRecording made(test::terrainOf({}, 8000.0, -10.0)), without(test::terrainOf({}, 8000.0, -10.0));
  for (auto* one : {&made, &without}) {
    one->observer(1000.0, 4000.0);
    one->recording.scenario.world.weather.visibility_m = 1000.0;
  }
  for (const double range : {250.0, 3000.0}) {
    test::HandRecording with = made;
    with.vehicle(1000.0 + range, 4000.0, Side::hostile);
    MissionView view = throughBinoculars();
    view.camera.turn_rad = toSi(Unit::mil, 1600.0);
    const Difference seen = differenceOf(draw(with.recording, 0.0, view), draw(without.recording, 0.0, view));
    if (range < 1000.0) {
      EXPECT_GT(seen.count, 50);
    } else {
      EXPECT_EQ(seen.count, 0);
    }
  }
}

TEST_F(Missions, GroundAtTheSeasLevelIsLand) {
  // The ridge's plain lies at 0 m, the level of the sea.
  const test::HandRecording made([] {
    TerrainSource source;
    source.kind = TerrainKind::function;
    source.expression = "ridge";
    source.params = {{"crest_x", 2000.0}, {"crest_height", 50.0}, {"foot_before", 200.0}, {"foot_after", 200.0}};
    return test::terrainOf(source, 4000.0);
  }());
  const Image image = draw(made.recording, 0.0, fromAbove({1000.0, 0.0, 2000.0}, 800.0));
  for (int y = 10; y < 260; y += 50) EXPECT_GT(image.pixel(200, y)[0], image.pixel(200, y)[2]) << y;
}

TEST_F(Missions, APlainHasGridLinesAndNoContours) {
  test::HandRecording made(test::terrainOf({}, 8000.0));
  MissionView with = fromAbove({4000.0, 0.0, 4000.0}, 4000.0), without = with;
  with.overlays.contours = true;
  const Image lined = draw(made.recording, 0.0, with), plain = draw(made.recording, 0.0, without);
  int marked = 0;
  for (std::size_t i = 0; i < lined.rgba.size(); i += 4) marked += lined.rgba[i] != plain.rgba[i];
  EXPECT_GT(marked, 500);
  EXPECT_LT(marked, 480 * 270 / 10);
}

}  // namespace
}  // namespace npsee::render
