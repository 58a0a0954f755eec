#pragma once

#include <npsee/explosion.h>

#include <gtest/gtest.h>

namespace npsee::test {

/// A preset of one layer with one piece that flies without chance: no deviations, leaning by 30 degrees, long-lived.
inline Preset onePiece() {
  Preset preset;
  preset.layers.emplace_back();
  Layer& layer = preset.layers[0];
  layer.count = 1;
  layer.lifetime_deviation_s = 0.0;
  layer.lifetime_mean_s = 20.0;
  return preset;
}

inline std::shared_ptr<const Explosion> compiled(const Preset& preset, const Ground* ground = nullptr, const CompileOptions& options = {}) {
  auto explosion = Explosion::compile(preset, std::nullopt, ground, options);
  EXPECT_TRUE(explosion) << (explosion ? "" : explosion.error().text());
  return explosion ? *explosion : nullptr;
}

inline ExactFrame exactAt(const Explosion& explosion, double t) {
  ExactFrame frame;
  explosion.at(t, frame);
  return frame;
}

}  // namespace npsee::test
