// Integrators of fixed step: the thesis's predictor-corrector and RK4.

#include "sim/ballistics/kernels.h"
#include "sim/core/elementary.h"

#include <algorithm>
#include <cmath>

namespace npsee::ballistics {
namespace {

using namespace lanes;

#include "sim/ballistics/atmosphere.inl"

#include "sim/ballistics/forces.inl"

Lane<double> laneOf(const ShotConstants& shot) {
  Lane<double> q{shot.drag, shot.lift, shot.magnus, shot.yaw_drag2, {}, {}};
  for (int i = 0; i < 3; ++i) {
    q.wind[i] = shot.wind[i];
    q.omega2[i] = shot.omega2[i];
  }
  return q;
}

/// One flight being integrated; `step` holds the last step, whose k[0] and k[6] are the derivatives at its ends.
class Fixed {
 public:
  Fixed(const Setup& setup, const ShotConstants& shot, Progress& progress) : s_(setup), q_(laneOf(shot)), progress_(progress) {
    std::copy(shot.y0, shot.y0 + kStates, step.y0);
    step.h = setup.integration.step_s;
    evaluate(0.0, step.y0, step.k[0], nullptr);
  }

  void advance() {
    if (s_.integration.integrator == Integrator::rk4) rungeKutta();
    else predictCorrect();
    ++progress_.flight.steps;
  }

  void accept(int count) {
    step.t = count * s_.integration.step_s;
    std::copy(step.y1, step.y1 + kStates, step.y0);
    std::copy(step.k[6], step.k[6] + kStates, step.k[0]);
  }

  /// Numbers of a flight, not of an explosion; anything not a number fails too.
  bool sane() const {
    for (int i = 0; i < kStates; ++i)
      if (!(std::fabs(step.y1[i]) < 1e12 && std::fabs(step.k[6][i]) < 1e12)) return false;
    return true;
  }

  Step step;

 private:
  void evaluate(double t, const double* y, double* dy, const double* lagged) {
    double yaw2, mach;
    derivative(s_, q_, t, y, dy, yaw2, mach, lagged);
    progress_.yaw2_max = larger(progress_.yaw2_max, yaw2);
    progress_.mach_max = larger(progress_.mach_max, mach);
    ++progress_.flight.evaluations;
  }

  void rungeKutta() {
    const double h = step.h;
    double at[kStates], k2[kStates], k3[kStates], k4[kStates];
    const double* k1 = step.k[0];
    for (int i = 0; i < kStates; ++i) at[i] = step.y0[i] + 0.5 * h * k1[i];
    evaluate(step.t + 0.5 * h, at, k2, nullptr);
    for (int i = 0; i < kStates; ++i) at[i] = step.y0[i] + 0.5 * h * k2[i];
    evaluate(step.t + 0.5 * h, at, k3, nullptr);
    for (int i = 0; i < kStates; ++i) at[i] = step.y0[i] + h * k3[i];
    evaluate(step.t + h, at, k4, nullptr);
    for (int i = 0; i < kStates; ++i) step.y1[i] = step.y0[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
    evaluate(step.t + h, step.y1, step.k[6], nullptr);
  }

  /// Lieske's scheme as the thesis tells it: predict velocity and spin with the first derivative, evaluate, correct with the
  /// second difference, evaluate again. The yaw of repose uses the acceleration of the step before.
  void predictCorrect() {
    const double h = step.h;
    const double* f0 = step.k[0];
    double predicted[kStates], f1[kStates];
    for (int i = 0; i < 3; ++i) {
      predicted[i] = step.y0[i] + h * step.y0[3 + i] + 0.5 * h * h * f0[3 + i];
      predicted[3 + i] = step.y0[3 + i] + h * f0[3 + i];
    }
    predicted[6] = step.y0[6] + h * f0[6];
    evaluate(step.t + h, predicted, f1, f0 + 3);
    for (int i = 0; i < 3; ++i) {
      const double second = f1[3 + i] - f0[3 + i];
      step.y1[i] = predicted[i] + h * h / 6.0 * second;
      step.y1[3 + i] = predicted[3 + i] + 0.5 * h * second;
    }
    step.y1[6] = predicted[6] + 0.5 * h * (f1[6] - f0[6]);
    evaluate(step.t + h, step.y1, step.k[6], f1 + 3);
  }

  const Setup& s_;
  const Lane<double> q_;
  Progress& progress_;
};

}  // namespace

void flyFixed(const Setup& setup, const ShotConstants& shot, Progress& progress, Recorder* recorder) {
  Fixed flight(setup, shot, progress);
  for (int count = 1;; ++count) {
    flight.advance();
    // A step far too long for the drag makes an explicit method explode: the flight ends instead.
    if (!flight.sane()) return;
    const bool over = findEvents(setup, shot, flight.step, progress);
    if (recorder) recorder->step(flight.step);
    flight.accept(count);
    if (over || flight.step.t >= setup.integration.time_limit_s || count >= setup.integration.step_limit) return;
  }
}

}  // namespace npsee::ballistics
