#pragma once

#include <npsee/explosion.h>

#include <cmath>
#include <cstdint>

namespace npsee::test {

/// A frame made by hand, for tests of drawing that must not depend on the simulator.
struct HandMade {
  Frame frame;
  std::vector<LayerSpan> layers;

  /// Adds one particle; layers are continued while the form stays the same.
  void add(Form form, const Vec3& at, double size, const Colour& colour = {0.82, 0.70, 0.52}, double opacity = 1.0, const Vec3& velocity = {}) {
    if (layers.empty() || layers.back().form != form) layers.push_back({"layer " + std::to_string(layers.size()), frame.count, 0, form});
    ++layers.back().count;
    ++frame.count;
    const auto put = [](std::vector<float>& array, double value) { array.push_back(static_cast<float>(value)); };
    put(frame.x, at.x), put(frame.y, at.y), put(frame.z, at.z), put(frame.size, size);
    put(frame.vx, velocity.x), put(frame.vy, velocity.y), put(frame.vz, velocity.z);
    put(frame.r, colour.r), put(frame.g, colour.g), put(frame.b, colour.b), put(frame.a, opacity);
    // Some turn of its own for each: a unit quaternion from the particle's number.
    const double k = 0.7 * static_cast<double>(frame.count), size_q = std::sqrt(1.0 + k * k + 0.25 * k * k + 0.49);
    put(frame.qx, k / size_q), put(frame.qy, 0.5 * k / size_q), put(frame.qz, 0.7 / size_q), put(frame.qw, 1.0 / size_q);
    frame.alive.push_back(1);
    frame.bounces.push_back(0);
  }

  /// `count` particles of a form in a dome of the given radius over the ground, with a golden-angle spread.
  void addDome(Form form, std::size_t count, double radius_m, double size_m, const Colour& colour = {0.82, 0.70, 0.52}, double opacity = 1.0) {
    for (std::size_t i = 0; i < count; ++i) {
      const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(count), turn = 2.399963 * static_cast<double>(i);
      const double reach = radius_m * std::sqrt(1.0 - u * u), outward = std::fmod(0.61803398875 * static_cast<double>(i), 1.0);
      const Vec3 at{reach * std::cos(turn) * std::cbrt(outward), radius_m * u * std::cbrt(outward), reach * std::sin(turn) * std::cbrt(outward)};
      add(form, at, size_m * (0.7 + 0.6 * outward), colour, opacity, 2.0 * at);
    }
  }
};

}  // namespace npsee::test
