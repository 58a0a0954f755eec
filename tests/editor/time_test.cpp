#include "editor/document/moments.h"
#include "editor/document/past.h"
#include "editor/document/playback.h"
#include "editor/document/statistics.h"
#include "tests/editor/editor_script.h"

#include <gtest/gtest.h>

#include <cmath>

namespace npsee::editor {
namespace {

using test::EditorScript;

/// One particle thrown straight up at 20 m/s from the ground, that bounces once and lies still or dies.
std::shared_ptr<const Explosion> thrown(double lifetime_s) {
  Preset preset;
  Layer layer;
  layer.count = 1;
  layer.region_shape = RegionShape::point;
  layer.ejection_angle_rad = 0.0;
  layer.speed_mean_mps = 20.0;
  layer.speed_deviation_mps = layer.size_deviation_m = layer.lifetime_deviation_s = 0.0;
  layer.lifetime_mean_s = lifetime_s;
  layer.bounce_limit = 0;
  preset.layers.push_back(layer);
  return *Explosion::compile(preset);
}

TEST(Moments, TheFirstContactIsWhenTheParabolaMeetsTheGround) {
  const auto explosion = thrown(30.0);
  const Moments moments = momentsOf(*explosion);
  ASSERT_TRUE(moments.first_contact_s.has_value());
  EXPECT_NEAR(*moments.first_contact_s, 2.0 * 20.0 / Preset().gravity_mps2, 2e-3);
}

TEST(Moments, AParticleThatDiesInTheAirHasNoContactButADeath) {
  const Moments moments = momentsOf(*thrown(1.5));
  EXPECT_FALSE(moments.first_contact_s.has_value());
  ASSERT_TRUE(moments.last_death_s.has_value());
  EXPECT_NEAR(*moments.last_death_s, 1.5, 1e-6);
  const auto marks = marksOf(moments);
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_EQ(marks[0].name, "burst");
  EXPECT_EQ(marks[1].name, "last death");
}

TEST(Moments, NothingHappensWithoutParticles) {
  const auto empty = Explosion::compile(Preset());
  ASSERT_TRUE(empty.has_value());
  EXPECT_EQ(marksOf(momentsOf(**empty)).size(), 1u);
}

TEST(Figures, AreThoseOfOneThrownParticle) {
  const auto explosion = thrown(30.0);
  Frame frame;
  explosion->at(1.0, frame, kVelocity);
  const FrameFigures figures = figuresOf(frame);
  const double g = Preset().gravity_mps2, speed = 20.0 - g;
  EXPECT_EQ(figures.alive, 1u);
  EXPECT_NEAR(figures.fastest_mps, speed, 1e-4);
  EXPECT_NEAR(figures.energy_Jpkg, 0.5 * speed * speed, 1e-2);
  EXPECT_NEAR(figures.extent.max.y, 20.0 - 0.5 * g, 0.05);
  explosion->at(-1.0, frame, kVelocity);
  EXPECT_EQ(figuresOf(frame).alive, 0u);
}

TEST(Past, LooksBackInEqualStepsAndNotBeforeTheBurst) {
  const auto explosion = thrown(30.0);
  Past past;
  const auto& frames = past.at(explosion, 1.0, 2.0, 4);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_DOUBLE_EQ(frames[0].time_s, 0.5);
  EXPECT_DOUBLE_EQ(frames[1].time_s, 0.0);
  EXPECT_EQ(&past.at(explosion, 1.0, 2.0, 4), &frames) << "kept";
  EXPECT_TRUE(past.at(nullptr, 1.0, 2.0, 4).empty());
}

TEST(Past, RoundTimesAreOneTwoOrFive) {
  for (double duration = 0.03; duration < 900.0; duration *= 1.37) {
    const double time = roundTime(duration, 0.1), lead = time / std::pow(10.0, std::floor(std::log10(time) + 1e-9));
    EXPECT_TRUE(std::abs(lead - 1.0) < 1e-6 || std::abs(lead - 2.0) < 1e-6 || std::abs(lead - 5.0) < 1e-6) << time;
    EXPECT_LE(time, 0.1 * duration * 1.0001);
    EXPECT_GT(time, 0.1 * duration / 2.51);
  }
}

TEST(Playback, LoopsWithinItsRangeAndPlaysOnFromBehindIt) {
  Playback playback;
  playback.setDuration(10.0);
  playback.seek(2.0);
  playback.beginRange(2.0);
  playback.endRange(3.0);
  playback.playing = true;
  playback.advance(1.25);
  EXPECT_DOUBLE_EQ(playback.time_s, 2.25);
  playback.seek(5.0);
  playback.advance(1.0);
  EXPECT_DOUBLE_EQ(playback.time_s, 6.0);
  playback.seek(2.5);
  playback.loop = false;
  playback.advance(2.0);
  EXPECT_DOUBLE_EQ(playback.time_s, 3.0);
  EXPECT_FALSE(playback.playing);
  playback.clearRange();
  playback.playing = playback.loop = true;
  playback.advance(8.0);
  EXPECT_DOUBLE_EQ(playback.time_s, 1.0);
}

TEST(Playback, RangesAreNeverInsideOutOrEmpty) {
  Playback playback;
  playback.setDuration(4.0);
  playback.endRange(1.0);
  EXPECT_EQ(playback.from_s, 0.0);
  EXPECT_EQ(playback.to_s, 1.0);
  playback.beginRange(2.0);
  EXPECT_EQ(playback.from_s, 2.0);
  EXPECT_EQ(playback.to_s, 4.0);
  playback.endRange(0.0);
  EXPECT_FALSE(playback.hasRange());
  playback.beginRange(4.0);
  EXPECT_FALSE(playback.hasRange());
  playback.beginRange(1.0);
  playback.setDuration(0.5);
  playback.playing = true;
  for (int i = 0; i < 100; ++i) playback.advance(0.1);
  EXPECT_LE(playback.time_s, 0.5) << "a range beyond the end of a shorter effect is none";
}

TEST_F(EditorScript, MarksOfTheTimeLineAreGoneTo) {
  passes(R"(expect visible mark:burst
expect mark.contact > 0
expect mark.death > 5
click "mark:first contact"
expect playing = no
expect time > 0.1
expect time < 3
note
key shift+Period
expect time > noted
key shift+Comma
expect time = noted
key shift+Comma
expect time = 0
)");
}

TEST_F(EditorScript, ARangeIsMarkedByKeysShiftDragAndItsEndsAndThenLooped) {
  passes(R"(set time 1
key I
set time 2
key O
expect loop.from = 1
expect loop.to = 2
key Space
wait 200
expect time >= 1
expect time <= 2
key Space
drag loop:to 100 0
expect loop.to > 2.2
expect loop.from = 1
drag loop:from 40 0
expect loop.from > 1.1
key shift+L
expect loop.to = 0
hold shift
drag thumb:time 80 0
let shift
expect loop.to > 1
expect loop.to != 2
expect undo = 0
)");
}

TEST_F(EditorScript, TheSlowestMotionIsAHundredth) {
  passes("set time 0\nkey LeftBracket\nkey LeftBracket\nkey LeftBracket\nkey LeftBracket\nkey LeftBracket\nkey LeftBracket\nkey LeftBracket\nexpect speed = 0.01\nkey Space\nwait 60\nexpect time > 0.005\nexpect time < 0.02\n");
}

TEST_F(EditorScript, OverlaysAreSwitchedByKeyAndButtonAndSeenInThePicture) {
  for (const auto& [key, name] : {std::pair{"N", "onion skin"}, {"T", "trails"}, {"V", "speed"}, {"K", "figures"}}) {
    passes("set time 1\nmouse 700 10\nwait 3\nsave " + in("off.png") + "\nkey " + key + "\nsave " + in("on.png") + "\nclick \"toggle:" + name + "\"\nmouse 700 10\nwait 3\nsave " + in("again.png") + "\nexpect undo = 0\n");
    const auto off = picture("off.png"), on = picture("on.png"), again = picture("again.png");
    int different = 0, left = 0;
    for (int y = 80; y < 760; ++y)
      for (int x = 270; x < 1020; ++x) {
        different += std::abs(off.pixel(x, y)[0] - on.pixel(x, y)[0]) > 12 ? 1 : 0;
        left += std::abs(off.pixel(x, y)[0] - again.pixel(x, y)[0]) > 12 ? 1 : 0;
      }
    EXPECT_GT(different, 200) << name;
    EXPECT_EQ(left, 0) << name;
  }
}

TEST_F(EditorScript, FiguresAreThoseOfWhatIsShown) {
  passes(R"(set time 0
expect fastest > 15
set time 1
note
set fragments.speed_mean 40
expect fastest > noted
expect energy > noted
click button:enable:fragments
expect fastest = 0
expect alive = 0
)");
}

}  // namespace
}  // namespace npsee::editor
