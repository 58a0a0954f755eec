// The Dormand-Prince integrator for one flight or four at a time. Included after forces.inl; R is double or lanes::Doubles.
//
// Each lane has its own step size, so a flight does exactly the same operations alone or beside others, and the results have
// equal bits.

NPSEE_KERNEL_INLINE double lane(double x, int) { return x; }
NPSEE_KERNEL_INLINE double lane(const Doubles& x, int i) { return x[i]; }
NPSEE_KERNEL_INLINE double lane(const Eight& x, int i) { return x[i]; }

// Source: Dormand and Prince 1980; Hairer, Norsett and Wanner, Solving ODEs I, table II.5.2.
constexpr double kNodes[7] = {0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
constexpr double kWeights[7][6] = {{},
                                   {1.0 / 5},
                                   {3.0 / 40, 9.0 / 40},
                                   {44.0 / 45, -56.0 / 15, 32.0 / 9},
                                   {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                                   {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                                   {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
constexpr double kErrors[7] = {71.0 / 57600, 0.0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

constexpr double kLongestStep_s = 16.0, kShortestStep_s = 1e-9;

/// x^(-1/5) to about 1e-4, from its bit pattern two steps of Newton's method, for the step size; x > 0.
NPSEE_KERNEL_INLINE double inverseFifthRoot(double x) {
  double z = elementary_detail::fromBits(0x4cb8a66666666666ll - elementary_detail::bitsOf(x) / 5);
  for (int i = 0; i < 2; ++i) {
    const double z2 = z * z;
    z = z * (1.2 - 0.2 * x * (z2 * z2 * z));
  }
  return z;
}

template <class R>
struct Flock {
  static constexpr int kWidth = sizeof(R) / sizeof(double);
  Lane<R> q;
  R t, h, y[kStates], y1[kStates], k[7][kStates], error_scale[kStates];
  R error, yaw2_max, mach_max, attempt_yaw2, attempt_mach;
  bool refused[kWidth];       ///< the attempt before was refused
  std::ptrdiff_t who[kWidth];  ///< shot in each lane, -1 = idle
};

template <class R>
__attribute__((noinline)) void evaluate(const Setup& s, const Lane<R>& q, R t, const R* y, R* dy, R& yaw2, R& mach) {
  derivative(s, q, t, y, dy, yaw2, mach);
}

/// Stage j of the attempt: the state it is evaluated at goes to `at`.
template <class R, int J>
NPSEE_KERNEL_INLINE void stage(const Setup& s, Flock<R>& f, R* at) {
  for (int i = 0; i < kStates; ++i) {
    R sum = kWeights[J][0] * f.k[0][i];
    for (int l = 1; l < J; ++l)
      if (kWeights[J][l] != 0.0) sum += kWeights[J][l] * f.k[l][i];
    at[i] = f.y[i] + f.h * sum;
  }
  R yaw2, mach;
  evaluate(s, f.q, R(f.t + kNodes[J] * f.h), at, f.k[J], yaw2, mach);
  f.attempt_yaw2 = larger(f.attempt_yaw2, yaw2);
  f.attempt_mach = larger(f.attempt_mach, mach);
}

/// Tries a step in every lane: y1, the stages and the scaled error.
template <class R>
__attribute__((noinline)) void attempt(const Setup& s, Flock<R>& f) {
  R at[kStates];
  f.attempt_yaw2 = f.attempt_mach = number<R>(0.0);
  stage<R, 1>(s, f, at);
  stage<R, 2>(s, f, at);
  stage<R, 3>(s, f, at);
  stage<R, 4>(s, f, at);
  stage<R, 5>(s, f, at);
  stage<R, 6>(s, f, f.y1);
  f.error = number<R>(0.0);
  R nothing = number<R>(0.0);  // 0, or not a number where any state is not: comparisons would lose that
  for (int i = 0; i < kStates; ++i) {
    R sum = kErrors[0] * f.k[0][i];
    for (int l = 2; l < 7; ++l) sum += kErrors[l] * f.k[l][i];
    const R scaled = f.h * sum * f.error_scale[i];
    f.error = larger(f.error, larger(scaled, R(-scaled)));
    nothing += 0.0 * scaled;
  }
  f.error += nothing;
}

/// Puts a shot into a lane.
template <class R>
void board(const ShotConstants& shot, Flock<R>& f, int i) {
  setLane(f.q.drag, i, shot.drag);
  setLane(f.q.lift, i, shot.lift);
  setLane(f.q.magnus, i, shot.magnus);
  setLane(f.q.yaw_drag2, i, shot.yaw_drag2);
  for (int a = 0; a < 3; ++a) {
    setLane(f.q.wind[a], i, shot.wind[a]);
    setLane(f.q.omega2[a], i, shot.omega2[a]);
  }
  for (int a = 0; a < kStates; ++a) {
    setLane(f.y[a], i, shot.y0[a]);
    setLane(f.error_scale[a], i, shot.error_scale[a]);
  }
  setLane(f.t, i, 0.0);
  setLane(f.h, i, 0.0);
  setLane(f.yaw2_max, i, 0.0);
  setLane(f.mach_max, i, 0.0);
}

/// First derivative and first step size of the lanes that were just boarded.
template <class R>
void depart(const Setup& s, Flock<R>& f, unsigned boarded) {
  R dy[kStates], yaw2, mach;
  evaluate(s, f.q, f.t, f.y, dy, yaw2, mach);
  for (int i = 0; i < Flock<R>::kWidth; ++i) {
    if (!(boarded & (1u << i))) continue;
    for (int a = 0; a < kStates; ++a) setLane(f.k[0][a], i, lane(dy[a], i));
    setLane(f.yaw2_max, i, lane(yaw2, i));
    setLane(f.mach_max, i, lane(mach, i));
    // A twentieth of the time in which the velocity changes by itself.
    double u2 = 0.0, a2 = 0.0;
    for (int a = 3; a < 6; ++a) {
      u2 += lane(f.y[a], i) * lane(f.y[a], i);
      a2 += lane(dy[a], i) * lane(dy[a], i);
    }
    const double first = 0.05 * squareRoot(u2 / (a2 + 1e-12));
    setLane(f.h, i, first < 1e-3 ? 1e-3 : first < 2.0 ? first : 2.0);
  }
}

/// Copies one lane's step for the finder of events.
template <class R>
void extract(const Flock<R>& f, int i, Step& step) {
  step.t = lane(f.t, i);
  step.h = lane(f.h, i);
  for (int a = 0; a < kStates; ++a) {
    step.y0[a] = lane(f.y[a], i);
    step.y1[a] = lane(f.y1[a], i);
    for (int j = 0; j < 7; ++j) step.k[j][a] = lane(f.k[j][a], i);
  }
}

/// Height above the surface's reference: the sphere where gravity is curved.
template <class R>
NPSEE_KERNEL_INLINE R heightOf(const Setup& s, const R* y) {
  if (s.gravity != GravityModel::curved) return y[1];
  return y[1] + (y[0] * y[0] + y[2] * y[2]) * (0.5 / kEarthRadius_m);
}

/// After an attempt, lane by lane: accept or refuse, look for events, choose the next step. Returns the lanes that finished.
template <class R>
unsigned settle(const Setup& s, const ShotConstants* shots, Progress* all_progress, Recorder* recorder, Flock<R>& f) {
  const R below = heightOf(s, f.y1) - s.target_height_m;
  R next_h = f.h, accepted = number<R>(0.0);
  unsigned finished = 0;
  for (int i = 0; i < Flock<R>::kWidth; ++i) {
    if (f.who[i] < 0) continue;
    Progress& progress = all_progress[f.who[i]];
    const double error = lane(f.error, i), h = lane(f.h, i);
    progress.flight.evaluations += 6;
    const bool accept = error <= 1.0;
    // Also where the error is not a number.
    double factor = 0.2;
    if (error < 1e-4) factor = 5.0;
    else if (error < 1e6) factor = 0.9 * inverseFifthRoot(error);
    // Right after a refusal there is no growth: what made the step fail lies just ahead.
    const double most = f.refused[i] ? 1.0 : 5.0;
    factor = factor < 0.2 ? 0.2 : factor > most ? most : factor;
    f.refused[i] = !accept;
    double next = h * factor;
    next = next < kShortestStep_s ? kShortestStep_s : next < kLongestStep_s ? next : kLongestStep_s;
    setLane(next_h, i, next);
    if (!accept) {
      // No step is short enough: a body so light that the air stops it within a nanosecond. The flight ends.
      if (h <= kShortestStep_s) finished |= 1u << i;
      continue;
    }
    setLane(accepted, i, 1.0);
    ++progress.flight.steps;
    const bool apex = lane(f.y[4], i) > 0.0 && lane(f.y1[4], i) <= 0.0;
    bool over = false;
    if (apex || recorder || s.ground || !(lane(below, i) >= 0.0)) {
      Step step;
      extract(f, i, step);
      over = findEvents(s, shots[f.who[i]], step, progress);
      if (recorder) recorder->step(step);
    }
    if (over || lane(f.t, i) + h >= s.integration.time_limit_s || progress.flight.steps >= s.integration.step_limit) {
      progress.yaw2_max = lane(larger(f.yaw2_max, f.attempt_yaw2), i);
      progress.mach_max = lane(larger(f.mach_max, f.attempt_mach), i);
      finished |= 1u << i;
    }
  }
  const auto take = accepted > 0.5;
  for (int a = 0; a < kStates; ++a) {
    f.y[a] = select(take, f.y1[a], f.y[a]);
    f.k[0][a] = select(take, f.k[6][a], f.k[0][a]);
  }
  f.t = select(take, f.t + f.h, f.t);
  f.yaw2_max = select(take, larger(f.yaw2_max, f.attempt_yaw2), f.yaw2_max);
  f.mach_max = select(take, larger(f.mach_max, f.attempt_mach), f.mach_max);
  f.h = next_h;
  return finished;
}

/// Flies all shots, each lane taking the next one as soon as it is free.
template <class R>
void flyFlock(const Setup& s, const ShotConstants* shots, Progress* progress, std::size_t count, Recorder* recorder) {
  constexpr int kWidth = Flock<R>::kWidth;
  Flock<R> f{};
  std::size_t next = 0;
  int flying = 0;
  unsigned free_lanes = (1u << kWidth) - 1u;
  for (;;) {
    unsigned boarded = 0;
    for (int i = 0; i < kWidth; ++i) {
      if (!(free_lanes & (1u << i))) continue;
      if (next < count) {
        board(shots[next], f, i);
        f.who[i] = static_cast<std::ptrdiff_t>(next++);
        progress[f.who[i]].flight.evaluations = 1;
        boarded |= 1u << i;
        ++flying;
      } else {
        // An idle lane stands still at a harmless state.
        board(shots[0], f, i);
        f.who[i] = -1;
      }
    }
    if (flying == 0) return;
    if (boarded) depart(s, f, boarded);
    do {
      attempt(s, f);
      free_lanes = settle(s, shots, progress, recorder, f);
    } while (free_lanes == 0);
    flying -= __builtin_popcount(free_lanes);
  }
}
