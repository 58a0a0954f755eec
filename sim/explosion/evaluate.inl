// State of a chunk's particles at a time, four at a time. Part of a kernel (kernel.inl).

/// Particles whose arcs are looked up together, so that memory is fetched ahead of the arithmetic.
constexpr int kGroup = 64;

/// Where the particles of a group are in their lives.
struct Lookup {
  alignas(32) double age[kGroup];           ///< clamped to 0..lifetime, s
  alignas(16) std::int32_t number[kGroup];  ///< arc
  const Arc* arc[kGroup];
};

NPSEE_KERNEL_INLINE Doubles sinceBirth(const LayerConstants& c, const Chunk& chunk, int p, double t) {
  return t - (chunk.birth_s.empty() ? all(c.start_s) : load(chunk.birth_s.data() + p));
}

/// Number of the arc each of four particles is on. Start times are compared as floats rounded down, so the answer is right or,
/// within a rounding of a contact, too high; gather() steps back by the exact times.
NPSEE_KERNEL_INLINE Ints arcNumbers(const Chunk& chunk, int four, Doubles age) {
  const Floats rounded = narrow(age);
  Ints number = {0, 0, 0, 0};
  const float* row = chunk.starts.data() + std::size_t{4} * chunk.first_row[four];
  const float* end = chunk.starts.data() + std::size_t{4} * chunk.first_row[four + 1];
  for (; row != end; row += 4) number -= load(row) <= rounded;
  return number;
}

NPSEE_KERNEL_INLINE void lookUp(const LayerConstants& c, const Chunk& chunk, double t, int first_four, int fours, Lookup& out) {
  const Arc* arcs = chunk.arcs.data();
  for (int i = 0; i < fours; ++i) {
    const int four = first_four + i;
    const Doubles age = lesser(greater(sinceBirth(c, chunk, 4 * four, t), all(0.0)), load(chunk.lifetime_s.data() + 4 * four));
    store(out.age + 4 * i, age);
    const Ints number = arcNumbers(chunk, four, age);
    std::memcpy(out.number + 4 * i, &number, sizeof number);
    const Ints place = loadInts(chunk.first_arc.data() + 4 * four) + number;
    for (int lane = 0; lane < kLanes; ++lane) {
      const Arc* arc = arcs + static_cast<std::uint32_t>(place[lane]);
      out.arc[4 * i + lane] = arc;
      __builtin_prefetch(arc);
    }
  }
}

/// The arcs of four particles; `tau` is the time since each began, zero for particles at rest.
struct Gathered {
  Motion<Doubles> motion;
  Doubles tau, start;
  Ints number;
  Ints still;  ///< all ones where the particle is at rest
};

/// Steps back where rounding chose an arc that has not begun yet.
__attribute__((noinline, cold, unused)) void stepBack(Lookup& look, int at) {
  for (int lane = at; lane < at + kLanes; ++lane)
    while (look.number[lane] > 0 && look.arc[lane]->start_s > look.age[lane]) {
      --look.arc[lane];
      --look.number[lane];
    }
}

/// First and second half of four arcs: start and vy, x, z, vx, vz.
struct Halves {
  Twin front[kLanes];
  Floats back[kLanes];
};

NPSEE_KERNEL_INLINE Halves loadArcs(const Lookup& look, int at) {
  Halves out;
  for (int lane = 0; lane < kLanes; ++lane) {
    const auto* arc = reinterpret_cast<const char*>(look.arc[at + lane]);
    std::memcpy(&out.front[lane], arc, sizeof(Twin));
    std::memcpy(&out.back[lane], arc + sizeof(Twin), sizeof(Floats));
  }
  return out;
}

NPSEE_KERNEL_INLINE Doubles heightsOf(const Chunk& chunk, const Lookup& look, int at) {
  Floats out;
  for (int lane = 0; lane < kLanes; ++lane) out[lane] = chunk.heights[static_cast<std::size_t>(look.arc[at + lane] - chunk.arcs.data())];
  return widen(out);
}

NPSEE_KERNEL_INLINE Gathered gather(const LayerConstants& c, const Chunk& chunk, int four, Lookup& look, int at) {
  const Doubles age = load(look.age + at), zero = all(0.0);
  Halves arcs = loadArcs(look, at);
  Ints number = loadInts(look.number + at);
  Masks first = wideMask(number == 0);
  Doubles start = select(first, zero, firsts(arcs.front));
  if (any(start > age)) [[unlikely]] {
    stepBack(look, at);
    arcs = loadArcs(look, at);
    number = loadInts(look.number + at);
    first = wideMask(number == 0);
    start = select(first, zero, firsts(arcs.front));
  }
  const auto [x, z, vx, vz] = transposed(arcs.back);
  const Doubles later_y = chunk.heights.empty() ? all(c.ground_y) : heightsOf(chunk, look, at);

  Gathered out;
  out.number = number;
  out.still = number == loadCounts(chunk.rest_arc.data() + 4 * four);
  out.motion = {widen(x) + select(first, all(c.origin_x), zero), select(first, firsts(arcs.front) + c.origin_y, later_y), widen(z) + select(first, all(c.origin_z), zero),
                widen(vx), seconds(arcs.front), widen(vz)};
  out.start = start;
  out.tau = select(wideMask(out.still), zero, age - start);
  return out;
}

/// Piecewise linear between points, constant outside; 1 without points.
template <class Points, class Read>
NPSEE_KERNEL_INLINE Doubles alongLife(const Points& points, Doubles u, Read read) {
  Doubles out = all(read(points.front()));
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double from = points[i - 1].at, to = points[i].at, a = read(points[i - 1]), b = read(points[i]);
    const double slope = to > from ? (b - a) / (to - from) : 0.0;
    const Doubles here = a + (u - from) * slope;
    out = select(u >= from, here, out);
    out = select(u >= to, all(b), out);
  }
  return out;
}

template <class Real>
NPSEE_KERNEL_INLINE void look(const LayerConstants& c, Doubles life_part, Doubles alive_one, Doubles phase, int at, const FrameView<Real>& out) {
  // A particle's brightness follows its tumbling phase, which is uniform in 0..2 pi and shows nowhere else.
  const Doubles shade = 1.0 + c.colour_variation * (phase * (1.0 / 3.14159265358979323846) - 1.0);
  const auto limited = [](Doubles x) { return lesser(greater(x, all(0.0)), all(1.0)); };
  if (c.colour_over_life.empty()) {
    store(out.r + at, limited(c.colour.r * shade));
    store(out.g + at, limited(c.colour.g * shade));
    store(out.b + at, limited(c.colour.b * shade));
  } else {
    store(out.r + at, limited(shade * alongLife(c.colour_over_life, life_part, [](const GradientStop& s) { return s.colour.r; })));
    store(out.g + at, limited(shade * alongLife(c.colour_over_life, life_part, [](const GradientStop& s) { return s.colour.g; })));
    store(out.b + at, limited(shade * alongLife(c.colour_over_life, life_part, [](const GradientStop& s) { return s.colour.b; })));
  }
  Doubles opacity = c.opacity * alive_one;
  if (!c.opacity_over_life.empty()) opacity = opacity * alongLife(c.opacity_over_life, life_part, [](const CurvePoint& p) { return p.value; });
  store(out.a + at, limited(opacity));
}

/// Orientation: turned about the particle's own axis by phase + rate x time in motion.
template <class Real>
NPSEE_KERNEL_INLINE void orientation(const Chunk& chunk, int p, Doubles moving, Doubles phase, int at, const FrameView<Real>& out) {
  Doubles sine, cosine;
  sineCosine(0.5 * (phase + widen(load(chunk.rate_radps.data() + p)) * moving), sine, cosine);
  store(out.qx + at, widen(load(chunk.axis_x.data() + p)) * sine);
  store(out.qy + at, widen(load(chunk.axis_y.data() + p)) * sine);
  store(out.qz + at, widen(load(chunk.axis_z.data() + p)) * sine);
  store(out.qw + at, cosine);
}

/// Out of line, so that layers without turbulence keep their registers.
__attribute__((noinline, unused)) void stirFour(const Turbulence& eddies, const Doubles& age, const Doubles& life, const Doubles& still, Motion<Doubles>& m) {
  const Doubles pace = 1.0 / select(life > 0.0, life, all(1.0));
  stir<Doubles>(eddies, age * pace, select(still > 0.0, all(0.0), pace), m);
}

template <FlightLaw kLaw, class Real>
NPSEE_KERNEL_INLINE void evaluateFour(const LayerConstants& c, const Chunk& chunk, double t, int four, Lookup& look_up, int in_group, int at, const FrameView<Real>& out) {
  const int p = 4 * four;
  const Gathered now = gather(c, chunk, four, look_up, in_group);
  Motion<Doubles> m = flown<kLaw, Doubles>(c.flight, now.motion, now.tau);
  const Doubles life = load(chunk.lifetime_s.data() + p), age = load(look_up.age + in_group);
  if (c.turbulence.amplitude_m > 0.0) {
    const Masks still = wideMask(now.still);
    stirFour(c.turbulence, select(still, now.start, age), life, select(still, all(1.0), all(0.0)), m);
  }
  store(out.x + at, m.x);
  store(out.y + at, m.y);
  store(out.z + at, m.z);

  const Doubles since_birth = sinceBirth(c, chunk, p, t);
  const Masks alive = ((since_birth >= 0.0) | (all(c.stands ? t : -1.0) >= 0.0)) & (since_birth < life);
  const Doubles alive_one = select(alive, all(1.0), all(0.0));
  storeCounts(out.alive + at, narrowMask(alive) & 1);
  const bool curves = !c.size_over_life.empty() || (out.r && !(c.colour_over_life.empty() && c.opacity_over_life.empty()));
  const Doubles life_part = curves ? age / select(life > 0.0, life, all(1.0)) : all(0.0);
  Doubles size = widen(load(chunk.size_m.data() + p)) * alive_one;
  if (!c.size_over_life.empty()) size = size * alongLife(c.size_over_life, life_part, [](const CurvePoint& point) { return point.value; });
  store(out.size + at, size);

  if (out.vx) {
    store(out.vx + at, m.vx);
    store(out.vy + at, m.vy);
    store(out.vz + at, m.vz);
  }
  if (out.age) store(out.age + at, age);
  if (out.bounces) storeCounts(out.bounces + at, c.follow ? Ints{0, 0, 0, 0} : now.number);
  if (!out.r && !out.qx) return;
  const Doubles phase = widen(load(chunk.phase_rad.data() + p));
  if (out.r) look(c, life_part, alive_one, phase, at, out);
  // A particle tumbles up to the moment it comes to rest.
  if (out.qx) orientation(chunk, p, select(wideMask(now.still), now.start, age), phase, at, out);
}

/// The same frame pointers moved on, or into a small room for the last few particles, so that nothing behind them is touched.
template <class Real>
struct Tail {
  Real room[16][kLanes];
  std::uint8_t bytes[2][kLanes];

  FrameView<Real> view(const FrameView<Real>& wanted) {
    const auto pick = [this](Real* pointer, int i) { return pointer ? room[i] : nullptr; };
    return {pick(wanted.x, 0), pick(wanted.y, 1), pick(wanted.z, 2), pick(wanted.vx, 3), pick(wanted.vy, 4), pick(wanted.vz, 5), pick(wanted.size, 6), pick(wanted.age, 7),
            pick(wanted.r, 8), pick(wanted.g, 9), pick(wanted.b, 10), pick(wanted.a, 11), pick(wanted.qx, 12), pick(wanted.qy, 13), pick(wanted.qz, 14), pick(wanted.qw, 15),
            bytes[0], wanted.bounces ? bytes[1] : nullptr};
  }

  void copyOut(const FrameView<Real>& to, int at, int count) const {
    Real* const pointers[] = {to.x, to.y, to.z, to.vx, to.vy, to.vz, to.size, to.age, to.r, to.g, to.b, to.a, to.qx, to.qy, to.qz, to.qw};
    for (int i = 0; i < 16; ++i)
      if (pointers[i]) std::memcpy(pointers[i] + at, room[i], sizeof(Real) * static_cast<std::size_t>(count));
    std::memcpy(to.alive + at, bytes[0], static_cast<std::size_t>(count));
    if (to.bounces) std::memcpy(to.bounces + at, bytes[1], static_cast<std::size_t>(count));
  }
};

template <FlightLaw kLaw, class Real>
NPSEE_KERNEL_INLINE void evaluateChunk(const LayerConstants& c, const Chunk& chunk, double t, const FrameView<Real>& out) {
  constexpr int kFours = kGroup / kLanes;
  const int whole = chunk.count / kLanes, fours = (chunk.count + kLanes - 1) / kLanes;
  Lookup looks[2];
  lookUp(c, chunk, t, 0, std::min(kFours, fours), looks[0]);
  for (int first = 0, turn = 0; first < fours; first += kFours, turn ^= 1) {
    // One group ahead: its arcs travel here while this group is computed.
    if (const int next = first + kFours; next < fours) lookUp(c, chunk, t, next, std::min(kFours, fours - next), looks[turn ^ 1]);
    const int end = std::min(first + kFours, whole);
    for (int four = first; four < end; ++four) evaluateFour<kLaw>(c, chunk, t, four, looks[turn], kLanes * (four - first), kLanes * four, out);
    if (whole < fours && whole >= first && whole < first + kFours) {
      Tail<Real> tail;
      evaluateFour<kLaw>(c, chunk, t, whole, looks[turn], kLanes * (whole - first), 0, tail.view(out));
      tail.copyOut(out, kLanes * whole, chunk.count - kLanes * whole);
    }
  }
}

template <class Real>
void evaluate(const LayerConstants& c, const Chunk& chunk, double t, const FrameView<Real>& out) {
  switch (c.flight.law) {
    case FlightLaw::ballistic: return evaluateChunk<FlightLaw::ballistic>(c, chunk, t, out);
    case FlightLaw::exponential: return evaluateChunk<FlightLaw::exponential>(c, chunk, t, out);
    case FlightLaw::series: return evaluateChunk<FlightLaw::series>(c, chunk, t, out);
  }
}
