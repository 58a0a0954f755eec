#include "editor/document/launch_probe.h"
#include "editor/document/session.h"
#include "editor/document/template_ease.h"

#include <npsee/explosion.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace npsee::editor {
namespace {

SessionOptions probing() { return {.library = {}, .wait_for_compile = true}; }

TEST(LaunchProbe, HoldsTheVeryDrawsOfALayerThatHangsOnNothing) {
  Session session(probing());
  session.update(0.0);
  const LaunchProbe probe = probeLaunch(session.document.preset(), 0, 1000);
  Frame frame;
  session.explosion()->at(0.0, frame, kVelocity);
  ASSERT_EQ(probe.speed_mps.size(), frame.count);
  // The same velocity, whose length is rounded twice.
  for (std::size_t i = 0; i < frame.count; ++i) EXPECT_FLOAT_EQ(probe.speed_mps[i], std::hypot(frame.vx[i], frame.vy[i], frame.vz[i]));
  EXPECT_TRUE(std::equal(probe.size_m.begin(), probe.size_m.end(), frame.size.begin()));
  EXPECT_EQ(session.design.probe.speed_mps, probe.speed_mps) << "found beside, the same";
  const Layer& layer = session.document.layer();
  for (std::size_t i = 0; i < probe.x_m.size(); ++i) {
    EXPECT_LE(std::hypot(probe.x_m[i], probe.z_m[i]), static_cast<float>(layer.region_radius_m) * 1.0001f);
    EXPECT_LE(static_cast<double>(probe.angle_rad[i]), layer.ejection_angle_rad + 1e-3);
    EXPECT_GT(probe.lifetime_s[i], 0.0f);
  }
}

TEST(LaunchProbe, LayersThatHangOnOthersAndEmitOverTimeHaveOneToo) {
  Session session(probing());
  ASSERT_TRUE(session.document.duplicateLayer().has_value());
  const auto set = [&](std::string_view key, const Value& value) { ASSERT_TRUE(session.document.assign(*findParameter(Scope::layer, key), value).has_value()); };
  set("parent", std::string("fragments"));
  set("trigger", std::string("death"));
  set("duration", 2.0);
  set("start", 1.0);
  set("lifetime_mean", 3.0);
  set("lifetime_deviation", 0.0);
  session.update(0.0);
  ASSERT_EQ(session.design.probe.lifetime_s.size(), 100u);
  EXPECT_NEAR(static_cast<double>(session.design.probe.lifetime_s[7]), 3.0, 1e-5);
  EXPECT_NE(session.design.histogram("speed_deviation"), nullptr);
  EXPECT_EQ(session.design.histogram("lifetime_deviation"), nullptr) << "nothing spreads";
}

TEST(LaunchProbe, IsBoundedAndEmptyWithoutParticles) {
  Preset preset;
  preset.layers.emplace_back();
  preset.layers[0].count = 3'000'000;
  EXPECT_EQ(probeLaunch(preset, 0, 500).x_m.size(), 500u);
  EXPECT_TRUE(probeLaunch(preset, 1, 500).x_m.empty());
  preset.layers[0].count = 0;
  preset.layers[0].density = 0.0;
  EXPECT_TRUE(probeLaunch(preset, 0, 500).x_m.empty());
}

TEST(Histogram, CountsEveryValueBetweenItsEnds) {
  const std::vector<float> values{1.0f, 2.0f, 2.0f, 5.0f};
  const Histogram histogram = histogramOf(values);
  EXPECT_EQ(histogram.low, 1.0);
  EXPECT_EQ(histogram.high, 5.0);
  EXPECT_EQ(histogram.mean, 2.5);
  int sum = 0;
  for (const int bin : histogram.bins) sum += bin;
  EXPECT_EQ(sum, 4);
  EXPECT_EQ(histogram.most, 2);
  EXPECT_FALSE(histogramOf(std::vector<float>{3.0f, 3.0f}).spread());
  EXPECT_FALSE(histogramOf({}).spread());
}

TEST(TemplateEase, GlidesToAJumpWithoutPassingItAndThenRests) {
  auto preset = std::make_shared<Preset>();
  preset->layers.emplace_back();
  preset->layers[0].speed_mean_mps = 10.0;
  TemplateEase ease;
  ease.update(preset, 0, 0.0, false);
  EXPECT_EQ(ease.shown().layers[0].speed_mean_mps, 10.0) << "the first one is there at once";
  auto jumped = std::make_shared<Preset>(*preset);
  jumped->layers[0].speed_mean_mps = 100.0;
  double before = 10.0;
  int frames = 0;
  do {
    ease.update(jumped, 0, 1.0 / 60.0, false);
    const double now = ease.shown().layers[0].speed_mean_mps;
    EXPECT_GE(now, before);
    EXPECT_LE(now, 100.0);
    before = now;
    ++frames;
  } while (ease.moving() && frames < 200);
  EXPECT_GT(frames, 5);
  EXPECT_LT(frames, 60) << "within a second";
  EXPECT_EQ(before, 100.0);
}

TEST(TemplateEase, AtOnceIsAtOnceAndScriptsNeverMove) {
  Session session(probing());
  session.update(0.0);
  ASSERT_TRUE(session.document.assign(*findParameter(Scope::layer, "speed_mean"), 120.0).has_value());
  session.update(1.0 / 60.0);
  EXPECT_EQ(session.design.ease.shown().layers[0].speed_mean_mps, 120.0);
  EXPECT_FALSE(session.design.ease.moving());
}

}  // namespace
}  // namespace npsee::editor
