#include "editor/document/session.h"
#include "editor/mission/session.h"
#include "tests/support/process.h"
#include "tests/support/small_mission.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace npsee::editor {
namespace {

/// A session that waits for its simulation, with the small mission opened.
class MissionSessions : public testing::Test {
 protected:
  void SetUp() override { open(test::smallMission()); }
  void open(const Scenario& scenario) {
    ASSERT_TRUE(saveScenario(scenario, folder_ / "small.mission.json").has_value());
    session.open(folder_ / "small.mission.json");
    ASSERT_EQ(session.notices.error, "");
    ASSERT_TRUE(session.inMission());
    session.update(0.0);
    ASSERT_NE(mission.recording(), nullptr) << session.notices.error;
  }
  void play(double seconds) {
    mission.clock.playing = true;
    for (double t = 0.0; t < seconds; t += 0.1) session.update(0.1);
    mission.clock.playing = false;
  }
  int count(EventKind kind) const { return static_cast<int>(std::ranges::count(mission.recording()->events, kind, &MissionEvent::kind)); }

  test::TemporaryFolder folder_;
  Session session{{.library = {}, .wait_for_compile = true}};
  MissionSession& mission = session.mission();
};

TEST_F(MissionSessions, TheWholeMissionIsSimulatedBeforeItIsPlayed) {
  EXPECT_TRUE(mission.recording()->finished);
  EXPECT_EQ(mission.recording()->duration_s, 120.0);
  EXPECT_EQ(mission.clock.time_s, 0.0);
  EXPECT_GT(count(EventKind::fire), 0);
  EXPECT_FALSE(mission.shots().empty());
  EXPECT_EQ(mission.recording()->hash, runMission(test::smallMission())->hash) << "as the command line simulates it";
}

TEST_F(MissionSessions, AnEditSimulatesAnewAndKeepsTheMoment) {
  mission.clock.seek(33.0);
  const std::string before = mission.recording()->hash;
  const auto camera = mission.view.camera;
  ASSERT_TRUE(mission.document.edit("Move", {}, [](Scenario& s) { shift(s, {ObjectRef::Kind::vehicle, "t72-1"}, -200.0, 100.0); }).has_value());
  session.update(0.0);
  EXPECT_NE(mission.recording()->hash, before);
  EXPECT_EQ(mission.clock.time_s, 33.0);
  EXPECT_EQ(mission.view.camera, camera) << "an edit moves no camera";
  session.undo();
  session.update(0.0);
  EXPECT_EQ(mission.recording()->hash, before);
}

TEST_F(MissionSessions, AMissionThatCannotBeSimulatedIsAMessageAndTheLastGoodOneStays) {
  const Recording* good = mission.recording();
  ASSERT_TRUE(mission.document.edit("Weapon", {}, [](Scenario& s) { s.batteries[0].weapon = 999; }).has_value());
  session.update(0.0);
  EXPECT_EQ(mission.recording(), good);
  EXPECT_NE(session.notices.error.find("999"), std::string::npos) << session.notices.error;
  EXPECT_NE(session.notices.error.find("last good"), std::string::npos);
  session.undo();
  session.update(0.0);
  EXPECT_EQ(session.notices.error, "") << "what is shown is right again";
}

TEST_F(MissionSessions, WithAPersonInTheLoopTheFutureIsNotSimulated) {
  mission.clock.seek(2.0);
  ASSERT_TRUE(mission.take("fo1").has_value());
  session.update(0.0);
  EXPECT_TRUE(mission.live());
  EXPECT_LT(mission.recording()->duration_s, 3.0);
  play(10.0);
  EXPECT_NEAR(mission.recording()->duration_s, mission.clock.time_s, 0.11);
  ASSERT_TRUE(mission.release("fo1").has_value());
  session.update(0.0);
  EXPECT_FALSE(mission.live());
  EXPECT_TRUE(mission.recording()->finished);
}

TEST_F(MissionSessions, APersonCallsAndCorrectsFireAndIsGraded) {
  Scenario scenario = test::smallMission();
  scenario.observers[0].human = true;  // else the rules have called before he is there
  open(scenario);
  ASSERT_TRUE(mission.take("fo1").has_value());
  play(1.0);
  mission.call.grid = {7000.0, 4800.0};
  mission.call.description = "tank in the open";
  ASSERT_TRUE(mission.callForFire("fo1").has_value());
  play(1.0);
  auto open = openMissions(*mission.recording(), "fo1", mission.clock.time_s);
  ASSERT_EQ(open.size(), 1u);
  EXPECT_EQ(open[0].method, "adjust_fire");
  for (int i = 0; i < 60 && openMissions(*mission.recording(), "fo1", mission.clock.time_s)[0].rounds == 0; ++i) play(1.0);
  ASSERT_GT(count(EventKind::detonation), 0);
  play(1.0);
  mission.corrections[open[0].number] = {100.0, 0.0};
  ASSERT_TRUE(mission.correct("fo1", open[0].number, false).has_value());
  play(1.0);
  EXPECT_EQ(count(EventKind::correction), 1);
  const Grade grade = gradeOf(*mission.recording(), "fo1", mission.clock.time_s);
  EXPECT_EQ(grade.corrections, 1) << eventLog(*mission.recording());
  ASSERT_TRUE(mission.endMission("fo1", open[0].number).has_value());
  play(1.0);
  EXPECT_TRUE(openMissions(*mission.recording(), "fo1", mission.clock.time_s).empty());
}

TEST_F(MissionSessions, ScrubbingBackOverAPersonsDeedsSimulatesThemIdentically) {
  ASSERT_TRUE(mission.take("t72-1").has_value());
  play(1.0);
  ASSERT_TRUE(mission.drive("t72-1", 8.0, 0.1).has_value());
  play(5.0);
  ASSERT_TRUE(mission.drive("t72-1", 4.0, -0.2).has_value());
  play(5.0);
  const double end = mission.clock.time_s;
  const auto tracked = mission.recording()->vehicles[0].track;
  const Pose live = tracked.at(end);
  EXPECT_GT(live.speed_mps, 0.0);
  // The same commands from the beginning, in one go.
  const auto again = runMission(*mission.document.snapshot(), end, *mission.document.commands());
  ASSERT_TRUE(again.has_value());
  const Pose replayed = again->vehicles[0].track.at(end);
  EXPECT_EQ(replayed.x_m, live.x_m);
  EXPECT_EQ(replayed.z_m, live.z_m);
  mission.clock.seek(3.0);
  session.update(0.0);
  EXPECT_EQ(mission.recording()->vehicles[0].track.at(3.0).x_m, tracked.at(3.0).x_m);
  // What he does anew in the past rewrites what he did afterwards.
  ASSERT_TRUE(mission.drive("t72-1", 0.0, 0.0).has_value());
  EXPECT_EQ(mission.document.commands()->size(), 3u);
}

TEST_F(MissionSessions, CamerasKeepWhatTheyWere) {
  using CameraKind = render::MissionCamera::Kind;
  ASSERT_EQ(mission.view.camera.kind, CameraKind::orbit);
  mission.view.camera.yaw_rad = 1.25;
  mission.look(CameraKind::plan);
  EXPECT_EQ(mission.view.camera.kind, CameraKind::plan);
  mission.look(CameraKind::observer, 0);
  EXPECT_EQ(mission.view.camera.subject, 0);
  mission.look(CameraKind::orbit);
  EXPECT_EQ(mission.view.camera.yaw_rad, 1.25);
}

TEST_F(MissionSessions, AMissionWithNothingInItIsShownEmpty) {
  Scenario empty;
  empty.duration_s = 10.0;
  empty.world.size_x_m = empty.world.size_z_m = 1000.0;
  open(empty);
  EXPECT_TRUE(mission.recording()->finished);
  EXPECT_TRUE(mission.shots().empty());
  mission.look(render::MissionCamera::Kind::observer);
  mission.look(render::MissionCamera::Kind::follow);
  mission.showSelected();
  play(12.0);
  EXPECT_EQ(mission.clock.time_s, 10.0);
}

TEST_F(MissionSessions, OpeningAPresetKeepsTheMissionAndAsksOnlyAboutWhatIsLost) {
  ASSERT_TRUE(mission.document.edit("Move", {}, [](Scenario& s) { s.duration_s = 60.0; }).has_value());
  ASSERT_TRUE(savePreset(Preset{}, folder_ / "burst.npsee.json").has_value());
  session.open(folder_ / "burst.npsee.json");
  EXPECT_EQ(session.asking(), Intent::none) << "the mission is not lost";
  EXPECT_FALSE(session.inMission());
  EXPECT_TRUE(mission.document.dirty());
  session.quit();
  EXPECT_EQ(session.asking(), Intent::quit);
  EXPECT_TRUE(session.inMission()) << "what is asked about is shown";
  session.answer(Answer::save);
  EXPECT_TRUE(session.quitting());
  EXPECT_EQ(loadScenario(folder_ / "small.mission.json")->duration_s, 60.0);
}

TEST(MissionRunnerThread, TheNewestRequestIsTheOneThatIsAnswered) {
  MissionRunner runner;
  const auto scenario = std::make_shared<const Scenario>(test::smallMission());
  const auto none = std::make_shared<const std::vector<MissionCommand>>();
  for (std::uint64_t i = 1; i <= 20; ++i) runner.request({i, i % 2 == 0 ? scenario : std::make_shared<const Scenario>(test::smallMission()), none, 100.0 + static_cast<double>(i)});
  std::optional<MissionRunner::Result> last;
  while (runner.busy() || !last || last->number != 20)
    if (auto result = runner.poll(std::chrono::milliseconds(50))) last = std::move(result);
  ASSERT_TRUE(last->recording.has_value());
  EXPECT_TRUE(last->complete);
  EXPECT_EQ((*last->recording)->duration_s, 120.0);
}

TEST(MissionRunnerThread, GoingOnInStepsIsTheSameAsInOneGo) {
  MissionRunner runner;
  const auto scenario = std::make_shared<const Scenario>(test::smallMission());
  const auto none = std::make_shared<const std::vector<MissionCommand>>();
  std::shared_ptr<const Recording> recording;
  for (int i = 1; i <= 48; ++i) {
    runner.request({static_cast<std::uint64_t>(i), scenario, none, 2.5 * i});
    const auto result = runner.poll(std::chrono::minutes(1));
    ASSERT_TRUE(result && result->recording);
    recording = *result->recording;
  }
  EXPECT_EQ(eventLog(*recording), eventLog(*runMission(*scenario)));
}

}  // namespace
}  // namespace npsee::editor
