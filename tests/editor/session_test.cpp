#include "editor/document/camera_moves.h"
#include "editor/document/session.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

namespace npsee::editor {
namespace {

SessionOptions waiting() { return {.library = {}, .wait_for_compile = true}; }

void change(Session& session, double speed) { ASSERT_TRUE(session.document.assign(*findParameter(Scope::layer, "speed_mean"), speed).has_value()); }

TEST(Playback, RunsLoopsAndStopsAtTheEnd) {
  Playback playback;
  playback.setDuration(2.0);
  playback.speed = 0.5;
  playback.advance(1.0);
  EXPECT_DOUBLE_EQ(playback.time_s, 0.5);
  playback.speed = 1.0;
  playback.advance(2.0);
  EXPECT_DOUBLE_EQ(playback.time_s, 0.5) << "loops";
  playback.loop = false;
  playback.advance(5.0);
  EXPECT_DOUBLE_EQ(playback.time_s, 2.0);
  EXPECT_FALSE(playback.playing);
  playback.toggle();
  EXPECT_DOUBLE_EQ(playback.time_s, 0.0) << "started at the end it begins anew";
}

TEST(Playback, StepsToAndFroMeetTheSameMoments) {
  Playback playback;
  playback.setDuration(10.0);
  for (int i = 0; i < 100; ++i) playback.step(1);
  const double there = playback.time_s;
  playback.step(7);
  playback.step(-7);
  EXPECT_EQ(playback.time_s, there);
  EXPECT_FALSE(playback.playing);
  playback.seek(-3.0);
  EXPECT_EQ(playback.time_s, 0.0);
  playback.step(-1);
  EXPECT_EQ(playback.time_s, 0.0);
}

TEST(Playback, NothingToPlayStaysAtZero) {
  Playback playback;
  playback.setDuration(0.0);
  playback.advance(1.0);
  EXPECT_EQ(playback.time_s, 0.0);
}

TEST(FrameQueue, HandsOutTheSameBytesAsADirectEvaluation) {
  Preset preset = Snapshot::fresh();
  preset.layers[0].count = 3000;
  const auto first = Explosion::compile(preset);
  preset.seed = 7;
  const auto second = Explosion::compile(preset);
  ASSERT_TRUE(first && second);
  FrameQueue queue(render::kSceneFields);
  Frame direct, queued;
  int taken = 0;
  for (int i = 0; i < 400; ++i) {
    // Seeks, strides and another explosion in between.
    const auto& explosion = i / 50 % 2 == 0 ? *first : *second;
    const double step = i % 7 == 0 ? 0.05 : 1.0 / 60.0, time = onGrid(0.013 * (i % 120), step);
    explosion->at(time, direct, render::kSceneFields);
    if (queue.take(explosion.get(), time, queued)) {
      ++taken;
      ASSERT_EQ(queued.count, direct.count);
      ASSERT_EQ(queued.x, direct.x) << time;
      ASSERT_EQ(queued.alive, direct.alive);
    }
    queue.plan(explosion, {onGrid(0.013 * ((i + 1) % 120), (i + 1) % 7 == 0 ? 0.05 : 1.0 / 60.0), 1.5, 0.25});
    std::this_thread::sleep_for(std::chrono::microseconds(i % 3 == 0 ? 0 : 500));
  }
  EXPECT_GT(taken, 0);
}

TEST(Session, APlayedEffectIsShownOnAGridOfMomentsAndAPausedOneExactly) {
  Session session({});
  ASSERT_TRUE(session.document.assign(*findParameter(Scope::layer, "count"), std::int64_t{3000}).has_value());
  session.update(0.0);
  for (int i = 0; i < 50'000 && session.compiling(); ++i) session.update(0.0);
  session.playback.seek(0.0);
  Frame direct;
  for (int i = 0; i < 40; ++i) {
    session.update(0.0171);
    session.explosion()->at(onGrid(session.playback.time_s, Playback::kFrame_s), direct, render::kSceneFields);
    ASSERT_EQ(session.frame().y, direct.y) << i;
  }
  session.playback.playing = false;
  session.playback.seek(0.1234);
  session.update(0.0);
  session.explosion()->at(0.1234, direct, render::kSceneFields);
  EXPECT_EQ(session.frame().y, direct.y);
}

TEST(Session, NewLoopsEverythingFromTheBurst) {
  Session session(waiting());
  session.update(0.0);
  session.playback.seek(0.5);
  session.playback.beginRange(0.5);
  session.playback.endRange(1.0);
  session.design.locked = {"fragments.speed_mean"};
  session.startNew();
  EXPECT_FALSE(session.playback.hasRange());
  EXPECT_EQ(session.playback.time_s, 0.0);
  EXPECT_TRUE(session.design.locked.empty());
}

TEST(Session, BroughtBackWorkWithoutAFileBeginsAnew) {
  Session session(waiting());
  session.update(0.0);
  session.playback.seek(0.5);
  session.playback.beginRange(0.5);
  session.design.solo = {"fragments"};
  session.keepForComparing();
  Document lost;
  ASSERT_TRUE(lost.addLayer().has_value());
  session.recover({WorkMode::explosion, {}, lost.text()});
  EXPECT_EQ(session.document.preset().layers.size(), 2u);
  EXPECT_FALSE(session.playback.hasRange());
  EXPECT_EQ(session.playback.time_s, 0.0);
  EXPECT_TRUE(session.design.solo.empty());
  EXPECT_FALSE(session.compare.on());
}

TEST(Session, ThePicturesFaultIsTakenBackWhenItIsRightAgain) {
  Session session(waiting());
  session.update(0.0);
  const auto set = [&](std::string_view key, const Value& value) { ASSERT_TRUE(session.document.assign(*findParameter(Scope::layer, key), value).has_value()); };
  set("form", std::string("pieces"));
  set("pieces.model", std::string("nope.obj"));
  session.update(0.0);
  EXPECT_NE(session.notices.error.find("nope.obj"), std::string::npos) << session.notices.error;
  session.undo();
  session.update(0.0);
  EXPECT_EQ(session.notices.error, "");
  session.redo();
  session.update(0.0);
  session.notices.error = "Something else went wrong.";
  session.undo();
  session.update(0.0);
  EXPECT_EQ(session.notices.error, "Something else went wrong.") << "that stays until it is dismissed";
}

TEST(Session, EditingKeepsTheMomentAndRecompiles) {
  Session session(waiting());
  session.update(0.0);
  ASSERT_NE(session.explosion(), nullptr);
  session.playback.playing = false;
  session.playback.seek(0.7);
  session.update(0.0);
  const Frame before = session.frame();
  const render::Camera camera = session.camera;
  change(session, 60.0);
  session.update(0.0);
  EXPECT_EQ(session.playback.time_s, 0.7);
  EXPECT_NE(session.frame().y, before.y);
  EXPECT_EQ(session.camera, camera) << "an edit moves no camera";
}

TEST(Session, TheFirstParticlesOfAnEmptyPresetComeIntoView) {
  Session session(waiting());
  ASSERT_TRUE(session.document.deleteLayer().has_value());
  session.update(0.0);
  EXPECT_GT(length(session.camera.eye - session.camera.target), 10.0);
  ASSERT_TRUE(session.document.addLayer().has_value());
  session.update(0.0);
  EXPECT_EQ(session.camera, render::framing(session.explosion()->extent(), session.aspect()));
}

TEST(Session, TheHistogramsValuesFollowTheDistribution) {
  Session session(waiting());
  const auto set = [&](std::string_view key, const Value& value) { ASSERT_TRUE(session.document.assign(*findParameter(Scope::layer, key), value).has_value()); };
  set("count", std::int64_t{20'000});
  set("speed_mean", 40.0);
  set("speed_deviation", 4.0);
  set("speed_distribution", std::string("uniform"));
  session.update(0.0);
  const auto& speeds = session.design.probe.speed_mps;
  ASSERT_EQ(speeds.size(), 20'000u);
  const auto [least, most] = std::ranges::minmax(speeds);
  // Uniform within mean +- deviation; 20,000 draws come within a thousandth of the range's ends.
  EXPECT_NEAR(static_cast<double>(least), 36.0, 0.02);
  EXPECT_NEAR(static_cast<double>(most), 44.0, 0.02);
  set("size_deviation", 0.0);
  set("size_over_life", Curve{{0.0, 0.25}, {1.0, 2.0}});
  session.update(0.0);
  EXPECT_NEAR(static_cast<double>(session.design.probe.size_m.front()), session.document.layer().size_mean_m, 1e-6) << "without the curve over life";
  set("duration", 1.0);
  session.update(0.0);
  EXPECT_EQ(session.design.probe.speed_mps.size(), 20'000u) << "though no single moment shows them all";
}

TEST(Session, TheEffectStaysFramedInANewShapeUntilTheCameraIsMoved) {
  Session session(waiting());
  session.update(0.0);
  session.setAspect(0.8);
  EXPECT_EQ(session.camera, render::framing(session.explosion()->extent(), 0.8));
  session.camera = moved(session.camera, CameraKey::viewpoint_y_plus, 1.0);
  const render::Camera own = session.camera;
  session.setAspect(2.0);
  EXPECT_EQ(session.camera, own);
}

TEST(Session, AWindowShowsTheLastGoodPictureUntilTheNextIsReady) {
  Session session({});
  session.update(0.0);
  const Explosion* first = session.explosion();
  ASSERT_NE(first, nullptr) << "the first one is waited for";
  ASSERT_TRUE(session.document.assign(*findParameter(Scope::layer, "count"), std::int64_t{400'000}).has_value());
  session.update(0.0);
  ASSERT_NE(session.explosion(), nullptr);
  for (int i = 0; i < 100'000 && (session.compiling() || session.explosion() == first); ++i) session.update(0.0);
  EXPECT_EQ(session.explosion()->particleCount(), 400'000u);
}

TEST(Session, UnsavedWorkIsAskedAboutBeforeItIsLost) {
  Session session(waiting());
  session.quit();
  EXPECT_TRUE(session.quitting()) << "nothing to lose";

  Session other(waiting());
  change(other, 60.0);
  other.quit();
  EXPECT_EQ(other.asking(), Intent::quit);
  EXPECT_FALSE(other.quitting());
  other.answer(Answer::cancel);
  EXPECT_EQ(other.asking(), Intent::none);
  EXPECT_EQ(other.document.layer().speed_mean_mps, 60.0);
  other.startNew();
  EXPECT_EQ(other.document.layer().speed_mean_mps, 60.0) << "waits for the answer";
  other.answer(Answer::discard);
  EXPECT_NE(other.document.layer().speed_mean_mps, 60.0);
  EXPECT_FALSE(other.document.dirty());
}

TEST(Session, SavingAsAnAnswerAsksForANameAndThenGoesOn) {
  const test::TemporaryFolder folder;
  Session session(waiting());
  change(session, 60.0);
  session.quit();
  session.answer(Answer::save);
  EXPECT_EQ(session.files.mode, FilePanel::Mode::save_as);
  EXPECT_FALSE(session.quitting());
  session.files.name = folder / "kept";
  session.confirmFiles();
  EXPECT_TRUE(session.quitting());
  EXPECT_TRUE(std::filesystem::exists(folder / "kept.npsee.json"));
}

TEST(Session, ClosingTheFilePanelLeavesTheQuestionOpen) {
  Session session(waiting());
  change(session, 60.0);
  session.quit();
  session.answer(Answer::save);
  session.closeFiles();
  EXPECT_EQ(session.asking(), Intent::quit);
  session.answer(Answer::cancel);
  EXPECT_FALSE(session.quitting());
}

TEST(Session, AFailedSaveKeepsTheQuestionAndTheWork) {
  const test::TemporaryFolder folder;
  Session session(waiting());
  ASSERT_TRUE(session.document.saveAs(folder / "mine").has_value());
  change(session, 60.0);
  std::filesystem::remove_all(folder.path());
  session.quit();
  session.answer(Answer::save);
  EXPECT_FALSE(session.quitting());
  EXPECT_EQ(session.asking(), Intent::quit);
  EXPECT_FALSE(session.notices.error.empty());
  EXPECT_TRUE(session.document.dirty());
}

TEST(Session, AnUnreadableFileIsAMessageAndTheDocumentStays) {
  Session session(waiting());
  session.open("/no/such/file.npsee.json");
  EXPECT_NE(session.notices.error.find("/no/such/file.npsee.json"), std::string::npos);
  EXPECT_EQ(session.document.name(), "untitled");
}

TEST(Folder, ListsFoldersThenPresetsAndSaysWhatIsWrong) {
  const test::TemporaryFolder folder;
  for (const char* name : {"b.npsee.json", "a.npsee.json", "notes.txt", ".hidden.npsee.json"}) test::spill(folder / name, "{}");
  std::filesystem::create_directory(folder / "z");
  const FolderListing listing = listFolder(folder.path());
  ASSERT_EQ(listing.entries.size(), 3u);
  EXPECT_EQ(listing.entries[0].name, "z");
  EXPECT_EQ(listing.entries[1].name, "a.npsee.json");
  EXPECT_TRUE(listing.problem.empty());
  EXPECT_FALSE(listFolder(folder / "missing").problem.empty());
}

TEST(CameraMoves, EachThesisKeyMovesOnePointAlongOneAxis) {
  const render::Camera camera{{1, 2, 30}, {4, 5, 6}};
  const double s = 2.0;
  const struct { CameraKey key; Vec3 eye, target; } cases[] = {
      {CameraKey::viewpoint_z_minus, {0, 0, -s}, {}}, {CameraKey::viewpoint_z_plus, {0, 0, s}, {}}, {CameraKey::viewpoint_x_plus, {s, 0, 0}, {}}, {CameraKey::viewpoint_x_minus, {-s, 0, 0}, {}},
      {CameraKey::viewpoint_y_plus, {0, s, 0}, {}}, {CameraKey::viewpoint_y_minus, {0, -s, 0}, {}}, {CameraKey::reference_y_plus, {}, {0, s, 0}}, {CameraKey::reference_y_minus, {}, {0, -s, 0}},
      {CameraKey::reference_x_minus, {}, {-s, 0, 0}}, {CameraKey::reference_x_plus, {}, {s, 0, 0}}};
  for (const auto& [key, eye, target] : cases) {
    const render::Camera to = moved(camera, key, s);
    EXPECT_EQ(to.eye, camera.eye + eye);
    EXPECT_EQ(to.target, camera.target + target);
  }
}

TEST(CameraMoves, KeyStepsAreRoundAndFollowTheEffectsSize) {
  EXPECT_DOUBLE_EQ(keyStep_m(20.0), 1.0);
  EXPECT_DOUBLE_EQ(keyStep_m(45.0), 2.0);
  EXPECT_DOUBLE_EQ(keyStep_m(100.0), 5.0);
  EXPECT_DOUBLE_EQ(keyStep_m(2.0), 0.1);
}

TEST(CameraMoves, OrbitingKeepsDistanceAndNeverReachesThePole) {
  render::Camera camera{{1, 20, 30}, {4, 5, 6}};
  const double distance = length(camera.eye - camera.target);
  for (int i = 0; i < 50; ++i) {
    camera = orbited(camera, 0.3, 0.2);
    EXPECT_NEAR(length(camera.eye - camera.target), distance, 1e-9);
    EXPECT_LT(std::abs(camera.eye.y - camera.target.y), distance * 0.99999);
  }
}

TEST(CameraMoves, DollyingKeepsThePlaceUnderThePointer) {
  const render::Camera camera{{0, 0, 40}, {0, 0, 0}};
  const double half = std::tan(0.5 * camera.fov_y_rad), x = 0.5, y = -0.25;
  const Vec3 before{x * half * 40.0, y * half * 40.0, 0.0};
  const render::Camera nearer = dollied(camera, 0.5, x, y);
  EXPECT_NEAR(length(nearer.eye - nearer.target), 20.0, 1e-9);
  EXPECT_NEAR(nearer.target.x + x * half * 20.0, before.x, 1e-9);
  EXPECT_NEAR(nearer.target.y + y * half * 20.0, before.y, 1e-9);
}

TEST(CameraMoves, PanningShiftsBothPoints) {
  const render::Camera camera{{0, 0, 40}, {0, 0, 0}};
  const render::Camera to = panned(camera, 0.5, 0.0);
  EXPECT_EQ(to.eye - to.target, camera.eye - camera.target);
  EXPECT_LT(to.target.x, 0.0) << "the picture follows the pointer to the right";
}

}  // namespace
}  // namespace npsee::editor
