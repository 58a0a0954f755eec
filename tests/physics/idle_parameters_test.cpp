// Parameters that are said to have no effect have none.

#include "tests/support/explosions.h"
#include "tests/support/random_preset.h"

#include <npsee/parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace npsee {
namespace {

/// A random preset of few particles in which every reason to have no effect is met now and then.
Preset someLayer(std::mt19937_64& random) {
  Preset preset = test::randomPreset(random);
  Layer& layer = preset.layers[0];
  layer.count = 12;
  layer.duration_s = 0.0;
  layer.collide = random() % 2 == 0;
  layer.follow_ground = random() % 4 == 0;
  if (random() % 3 == 0) layer.turbulence_m = 0.0;
  if (random() % 3 == 0) layer.temperature_k = 0.0;
  if (random() % 3 == 0) layer.speed_deviation_mps = layer.size_deviation_m = 0.0;
  if (random() % 3 == 0) layer.colour_over_life = {{0.0, {1.0, 0.5, 0.0}}, {1.0, {0.1, 0.1, 0.1}}};
  if (random() % 3 != 0) return preset;
  Layer child = layer;
  layer = Layer{};
  layer.count = 3;
  layer.name = "parent";
  child.parent = layer.name;
  child.trigger = Trigger::birth;
  preset.layers.push_back(child);
  return preset;
}

/// Another value than the present one.
Value anotherValue(const Parameter& row, const Value& now, std::mt19937_64& random) {
  if (const auto* on = std::get_if<bool>(&now)) return !*on;
  if (const auto* whole = std::get_if<std::int64_t>(&now)) return *whole + 1;
  if (row.type == ParameterType::colour) return Colour{0.123, 0.456, 0.789};
  return test::randomValue(row, random);
}

/// What hot layers glow by, which is not in the frames.
bool sameHeat(const Explosion& a, const Explosion& b) {
  return std::ranges::equal(a.layers(), b.layers(), [](const LayerSpan& p, const LayerSpan& q) { return p.temperature_k == q.temperature_k && (p.temperature_k == 0.0 || p.cooling_s == q.cooling_s); });
}

bool sameFrames(const Explosion& a, const Explosion& b) {
  if (!sameHeat(a, b)) return false;
  for (const double t : {0.0, 0.3, 1.7}) {
    const ExactFrame p = test::exactAt(a, t), q = test::exactAt(b, t);
    if (p.x != q.x || p.y != q.y || p.z != q.z || p.size != q.size || p.r != q.r || p.g != q.g || p.b != q.b || p.a != q.a || p.alive != q.alive || p.qx != q.qx) return false;
  }
  return true;
}

TEST(Parameters, SaidToHaveNoEffectHaveNone) {
  std::mt19937_64 random(1993);
  std::map<std::string_view, int> tried;
  for (int i = 0; i < 300; ++i) {
    const Preset preset = someLayer(random);
    const Layer& layer = preset.layers.back();
    if (!validate(preset).empty()) continue;
    const auto before = test::compiled(preset);
    ASSERT_NE(before, nullptr);
    for (const Parameter& row : parameters()) {
      const std::string_view why = withoutEffect(row, preset, &layer);
      if (why.empty()) continue;
      Preset changed = preset;
      if (row.scope == Scope::burst) row.assign(changed, anotherValue(row, row.get(preset), random));
      else row.assign(changed.layers.back(), anotherValue(row, row.get(layer), random));
      if (!validate(changed).empty()) continue;
      ++tried[row.key];
      const auto after = test::compiled(changed);
      ASSERT_NE(after, nullptr);
      EXPECT_TRUE(sameFrames(*before, *after)) << row.key << ": " << why;
    }
  }
  // A layer without a parent must have no trigger, so that one cannot be tried.
  for (const Parameter& row : parameters())
    if (row.idle != nullptr && row.key != "trigger") {
      EXPECT_GT(tried[row.key], 3) << row.key;
    }
}

TEST(Parameters, TheRingAloneHasAnInnerRadius) {
  Preset preset;
  preset.layers.emplace_back();
  Layer& layer = preset.layers[0];
  const Parameter& inner = *findParameter(Scope::layer, "region.inner_radius");
  layer.region_shape = RegionShape::disc;
  EXPECT_EQ(withoutEffect(inner, preset, &layer), "the region's shape has no such size");
  layer.region_shape = RegionShape::ring;
  EXPECT_EQ(withoutEffect(inner, preset, &layer), "");
}

}  // namespace
}  // namespace npsee
