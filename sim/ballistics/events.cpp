// Apex and impact: roots on the dense output of a step.

#include "sim/ballistics/kernels.h"

#include <algorithm>
#include <cmath>

namespace npsee::ballistics {
namespace {

using Dense = std::array<std::array<double, kStates>, 5>;

double component(const Dense& c, int i, double theta) {
  const double rest = 1.0 - theta;
  const auto a = static_cast<std::size_t>(i);
  return c[0][a] + theta * (c[1][a] + rest * (c[2][a] + theta * (c[3][a] + rest * c[4][a])));
}

/// Root of f between a and b, where f(a) and f(b) differ in sign: Illinois false position, bisecting where that is slow.
template <class F>
double root(const F& f, double a, double fa, double b, double fb) {
  int side = 0;
  for (int i = 0; i < 100 && std::fabs(b - a) > 1e-13; ++i) {
    double m = (a * fb - b * fa) / (fb - fa);
    if (!(m > a && m < b) || i % 8 == 7) m = 0.5 * (a + b);
    const double fm = f(m);
    if (fm == 0.0) return m;
    if ((fm > 0.0) == (fb > 0.0)) {
      b = m, fb = fm;
      if (side == 1) fa *= 0.5;
      side = 1;
    } else {
      a = m, fa = fm;
      if (side == -1) fb *= 0.5;
      side = -1;
    }
    // Metres and metres per second: a nanometre is enough.
    if (std::fabs(fm) < 1e-9) return m;
  }
  return b;
}

class Finder {
 public:
  Finder(const Setup& setup, const ShotConstants& shot, const Step& step, Progress& progress) : s_(setup), q_(shot), step_(step), progress_(progress) {
    denseOutput(step, s_.integration.integrator != Integrator::dormand_prince, c_);
  }

  bool run() {
    double apex = -1.0;
    if (step_.y0[4] > 0.0 && step_.y1[4] <= 0.0) {
      apex = root([&](double x) { return component(c_, 4, x); }, 0.0, step_.y0[4], 1.0, step_.y1[4]);
      noteApex(apex);
    }
    if (s_.ground) return terrain();
    if (apex > 0.0 && apex < 1.0) return crossing(0.0, apex) || crossing(apex, 1.0) || lost();
    return crossing(0.0, 1.0) || lost();
  }

 private:
  double height(double theta) const {
    double h = component(c_, 1, theta);
    if (s_.gravity == GravityModel::curved) {
      const double x = component(c_, 0, theta), z = component(c_, 2, theta);
      h += (x * x + z * z) * (0.5 / kEarthRadius_m);
    }
    return h;
  }

  /// Height over the surface to fall on.
  double clearance(double theta) const {
    if (!s_.ground) return height(theta) - s_.target_height_m;
    const double x = component(c_, 0, theta), z = component(c_, 2, theta);
    const double east = x * q_.sine + z * q_.cosine, south = z * q_.sine - x * q_.cosine;
    const double ground = s_.ground->height(q_.muzzle_m.x + east, q_.muzzle_m.z + south);
    return q_.muzzle_m.y + height(theta) - ground;
  }

  void noteApex(double theta) {
    Flight& flight = progress_.flight;
    // Wind or terrain-following lift could make several summits; the highest counts.
    const double ordinate = height(theta);
    if (progress_.past_apex && ordinate <= flight.max_ordinate_m) return;
    progress_.past_apex = true;
    flight.max_ordinate_m = ordinate;
    flight.apex_time_s = step_.t + theta * step_.h;
    flight.apex_range_m = component(c_, 0, theta);
    flight.apex_drift_m = component(c_, 2, theta);
  }

  bool impactAt(double theta) {
    Flight& flight = progress_.flight;
    flight.end = FlightEnd::impact;
    flight.time_of_flight_s = step_.t + theta * step_.h;
    flight.height_m = height(theta);
    for (int i = 0; i < kStates; ++i) progress_.impact_state[i] = component(c_, i, theta);
    return true;
  }

  /// Impact where the clearance falls from above to below zero between two places of the step.
  bool crossing(double a, double b) {
    const double fa = clearance(a), fb = clearance(b);
    if (!(fa > 0.0 && fb <= 0.0)) return false;
    return impactAt(root([&](double x) { return clearance(x); }, a, fa, b, fb));
  }

  /// Below a flat surface and falling: it will never be met.
  bool lost() const { return step_.y1[4] <= 0.0 && clearance(1.0) < 0.0; }

  /// Samples no further apart than half the terrain's detail; between two of them, where the shell is near the ground, the least
  /// clearance is looked for, so that not even a ridge's tip is jumped over.
  bool terrain() {
    const double detail = std::max(s_.ground->detail(), 0.01);
    const double dx = step_.y1[0] - step_.y0[0], dz = step_.y1[2] - step_.y0[2];
    const double wanted = std::ceil(std::sqrt(dx * dx + dz * dz) / (0.5 * detail));
    const int samples = wanted < 100000.0 ? std::max(4, static_cast<int>(wanted)) : 100000;
    double before = 0.0, clear_before = clearance(0.0);
    for (int i = 1; i <= samples; ++i) {
      const double theta = static_cast<double>(i) / samples, clear = clearance(theta);
      if (progress_.armed && clear <= 0.0) {
        if (clear_before <= 0.0) return impactAt(before);
        return impactAt(root([&](double x) { return clearance(x); }, before, clear_before, theta, clear));
      }
      if (progress_.armed && tip(before, clear_before, theta, clear, detail)) return true;
      // The muzzle may stand on or in the surface's cell: what happens within it is no impact.
      const double x = component(c_, 0, theta), z = component(c_, 2, theta);
      if (clear > 0.0 && clear < 1e7) progress_.armed = progress_.armed || clear > 1.0 || x * x + z * z > detail * detail;
      else progress_.armed = progress_.armed || x * x + z * z > detail * detail;
      before = theta;
      clear_before = clear;
    }
    // Below any terrain there is.
    return step_.y1[4] <= 0.0 && !(step_.y1[1] > -50000.0);
  }

  /// Impact on a tip of the ground that stands between two clear samples: the clearance falls after the first and rises before
  /// the second.
  bool tip(double a, double clear_a, double b, double clear_b, double detail) {
    // Half a cell away, only ground steeper than 4 in 1 could reach so high.
    if (!(clear_a > 0.0) || std::fmin(clear_a, clear_b) > 2.0 * detail) return false;
    const double little = 1e-3 * (b - a);
    if (clearance(a + little) >= clear_a || clearance(b - little) >= clear_b) return false;
    double low = a, high = b;
    for (int i = 0; i < 40; ++i) {
      const double third = (high - low) / 3.0;
      if (clearance(low + third) < clearance(high - third)) high -= third;
      else low += third;
    }
    const double least = 0.5 * (low + high), clear = clearance(least);
    if (clear > 0.0) return false;
    return impactAt(root([&](double x) { return clearance(x); }, a, clear_a, least, clear));
  }

  const Setup& s_;
  const ShotConstants& q_;
  const Step& step_;
  Progress& progress_;
  Dense c_;
};

}  // namespace

void denseOutput(const Step& step, bool hermite, Dense& c) {
  // Source: Hairer, Norsett and Wanner, Solving ODEs I, section II.6 (continuous extension of order 4).
  constexpr double d[7] = {-12715105075.0 / 11282082432.0, 0.0, 87487479700.0 / 32700410799.0, -10690763975.0 / 1880347072.0,
                           701980252875.0 / 199316789632.0, -1453857185.0 / 822651844.0, 69997945.0 / 29380423.0};
  for (std::size_t i = 0; i < kStates; ++i) {
    const double difference = step.y1[i] - step.y0[i];
    c[0][i] = step.y0[i];
    c[1][i] = difference;
    c[2][i] = step.h * step.k[0][i] - difference;
    c[3][i] = difference - step.h * step.k[6][i] - c[2][i];
    double sum = 0.0;
    if (!hermite)
      for (int j = 0; j < 7; ++j) sum += d[j] * step.k[j][i];
    c[4][i] = step.h * sum;
  }
}

bool findEvents(const Setup& setup, const ShotConstants& shot, const Step& step, Progress& progress) { return Finder(setup, shot, step, progress).run(); }

}  // namespace npsee::ballistics
