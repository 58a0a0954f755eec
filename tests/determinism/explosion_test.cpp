#include "tests/support/explosions.h"

#include <npsee/parameters.h>

#include <gtest/gtest.h>

#include <cstring>

namespace npsee {
namespace {

using test::compiled;

/// Layers of every flight law with children of every trigger, and a model that comes apart with trails on its pieces.
Preset family(bool with_model = true) {
  Preset preset;
  preset.wind_mps = {3.0, 0.5, -2.0};
  for (int i = 0; i < 7; ++i) preset.layers.emplace_back();
  const char* names[] = {"root", "weak drag", "drag", "births", "trail", "splash", "end"};
  for (std::size_t i = 0; i < 7; ++i) {
    preset.layers[i].name = names[i];
    preset.layers[i].count = i < 3 ? 1503 : 2;
    preset.layers[i].size_over_life = {{0.0, 1.0}, {1.0, 0.5}};
    preset.layers[i].colour_over_life = {{0.0, {1, 1, 0}}, {0.4, {1, 0.2, 0}}, {1.0, {0, 0, 0}}};
  }
  preset.layers[1].drag_ps = 1e-4;
  preset.layers[2].drag_ps = 0.3;
  preset.layers[2].duration_s = 1.0;
  const Trigger triggers[] = {Trigger::birth, Trigger::path, Trigger::bounce, Trigger::death};
  for (std::size_t i = 3; i < 7; ++i) {
    preset.layers[i].parent = i == 4 ? "drag" : "root";
    preset.layers[i].trigger = triggers[i - 3];
    preset.layers[i].inherit_velocity = 0.5;
  }
  if (!with_model) return preset;
  Layer model, smoke;
  model.name = "model";
  model.form = Form::pieces;
  model.pieces_model = "car";
  model.count = 75;
  model.start_s = 0.4;
  model.duration_s = 0.3;
  smoke.name = "trails";
  smoke.parent = "model";
  smoke.trigger = Trigger::path;
  smoke.count = 3;
  preset.layers.push_back(model);
  preset.layers.push_back(smoke);
  return preset;
}

/// Every bit of a frame, in one string.
template <class Real>
std::string bytesOf(const BasicFrame<Real>& f) {
  std::string out;
  for (const auto* v : {&f.x, &f.y, &f.z, &f.vx, &f.vy, &f.vz, &f.size, &f.age, &f.r, &f.g, &f.b, &f.a, &f.qx, &f.qy, &f.qz, &f.qw})
    out.append(reinterpret_cast<const char*>(v->data()), f.count * sizeof(Real));
  for (const auto* v : {&f.alive, &f.bounces}) out.append(reinterpret_cast<const char*>(v->data()), f.count);
  return out;
}

std::string exactBytes(const Explosion& explosion, double t, int threads = 1) {
  ExactFrame frame;
  explosion.at(t, frame, kAllFields, threads);
  return bytesOf(frame);
}

/// The same with eddies in every layer, one that follows the ground and a trail of even distances.
Preset stirred() {
  Preset preset = family();
  for (Layer& layer : preset.layers) {
    layer.turbulence_m = 1.5;
    layer.turbulence_size_m = 3.0;
  }
  preset.layers[1].follow_ground = true;
  preset.layers[4].path_spacing = PathSpacing::distance;
  return preset;
}

const double kTimes[] = {0.0, 0.3, 1.7, 2.14, 4.4, 5.9, 7.5};

TEST(Determinism, SeekingInAnyOrderGivesTheSameBytes) {
  const auto explosion = compiled(family());
  std::vector<std::string> forwards;
  Frame frame;
  for (const double t : kTimes) {
    explosion->at(t, frame);
    forwards.push_back(bytesOf(frame));
  }
  for (std::size_t i = std::size(kTimes); i-- > 0;) {
    explosion->at(kTimes[i], frame);
    EXPECT_EQ(bytesOf(frame), forwards[i]) << kTimes[i];
  }
}

TEST(Determinism, AnyNumberOfThreadsGivesTheSameBytes) {
  const auto one = compiled(family()), seven = compiled(family(), nullptr, {.threads = 7});
  for (const double t : kTimes) {
    const std::string bytes = exactBytes(*one, t);
    EXPECT_EQ(exactBytes(*seven, t), bytes) << t;
    EXPECT_EQ(exactBytes(*one, t, 5), bytes) << t;
  }
}

TEST(Determinism, EveryInstructionSetGivesTheSameBytes) {
  const auto best = compiled(family()), baseline = compiled(family(), nullptr, {.force_baseline = true});
  for (const double t : kTimes) EXPECT_EQ(exactBytes(*best, t), exactBytes(*baseline, t)) << t;
}

TEST(Determinism, TurbulenceHasTheSameBytesForAnyOrderThreadsAndInstructionSet) {
  const auto best = compiled(stirred()), seven = compiled(stirred(), nullptr, {.threads = 7}), baseline = compiled(stirred(), nullptr, {.force_baseline = true});
  std::vector<std::string> forwards;
  for (const double t : kTimes) forwards.push_back(exactBytes(*best, t));
  for (std::size_t i = std::size(kTimes); i-- > 0;) {
    EXPECT_EQ(exactBytes(*best, kTimes[i], 3), forwards[i]) << kTimes[i];
    EXPECT_EQ(exactBytes(*seven, kTimes[i]), forwards[i]) << kTimes[i];
    EXPECT_EQ(exactBytes(*baseline, kTimes[i]), forwards[i]) << kTimes[i];
  }
}

TEST(Determinism, FramesForDrawingAreTheExactOnesRounded) {
  const auto explosion = compiled(family());
  Frame frame;
  ExactFrame exact;
  explosion->at(1.7, frame);
  explosion->at(1.7, exact);
  for (std::size_t i = 0; i < frame.count; ++i) {
    ASSERT_EQ(frame.x[i], static_cast<float>(exact.x[i]));
    ASSERT_EQ(frame.y[i], static_cast<float>(exact.y[i]));
    ASSERT_EQ(frame.vy[i], static_cast<float>(exact.vy[i]));
    ASSERT_EQ(frame.qw[i], static_cast<float>(exact.qw[i]));
    ASSERT_EQ(frame.bounces[i], exact.bounces[i]);
  }
}

TEST(Determinism, AskingForFewerFieldsChangesNoneOfThem) {
  const auto explosion = compiled(family());
  Frame all, few;
  explosion->at(1.7, all);
  explosion->at(1.7, few, kPosition);
  EXPECT_TRUE(few.vx.empty());
  for (std::size_t i = 0; i < all.count; ++i) {
    ASSERT_EQ(all.x[i], few.x[i]);
    ASSERT_EQ(all.size[i], few.size[i]);
  }
}

TEST(Determinism, AnotherSeedGivesOtherBytes) {
  Preset preset = family();
  const std::string bytes = exactBytes(*compiled(preset), 1.7);
  ++preset.seed;
  EXPECT_NE(exactBytes(*compiled(preset), 1.7), bytes);
  const auto same = Explosion::compile(preset, 1993u);
  EXPECT_EQ(exactBytes(**same, 1.7), bytes);
}

/// FNV-1a, 64 bit.
std::uint64_t hashOf(const std::string& bytes) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return hash;
}

// A change of this number changes the look of every preset ever saved: the commit that does it says which effect changed and why.
TEST(Determinism, ThePinnedExplosionKeepsItsBits) { EXPECT_EQ(hashOf(exactBytes(*compiled(family(false)), 2.14)), 3258781039494920218ull); }

}  // namespace
}  // namespace npsee
