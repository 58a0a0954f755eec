#include "sim/explosion/shock_growth.h"

#include "sim/core/elementary.h"

namespace npsee::explosion {
namespace {

double power(double base, double exponent) { return base > 0.0 ? exponential(exponent * logarithm(base)) : 0.0; }

constexpr double kSonic = 0.25;

double grown(double u) {
  const double start = power(kSonic, 0.4), speed = 0.4 * power(kSonic, -0.6), scale = 1.0 / (start + speed * (1.0 - kSonic));
  return scale * (u <= kSonic ? power(u, 0.4) : start + speed * (u - kSonic));
}

}  // namespace

Curve shockGrowth() {
  // Even steps of the radius where it grows by the power law, whose slope is endless at the beginning.
  constexpr int kSteps = 24;
  Curve out;
  for (int i = 0; i <= kSteps; ++i) {
    const double u = kSonic * power(static_cast<double>(i) / kSteps, 2.5);
    out.push_back({u, grown(u)});
  }
  out.push_back({1.0, 1.0});
  return out;
}

Curve shockFading() {
  constexpr int kSteps = 12;
  Curve out;
  for (int i = 0; i <= kSteps; ++i) {
    const double u = static_cast<double>(i) / kSteps;
    out.push_back({u, (1.0 - u) * (1.0 - u)});
  }
  return out;
}

}  // namespace npsee::explosion
