// State of a chunk's particles at a time, four at a time. Part of a kernel (kernel.inl).

/// Number of the arc each of four particles is on at `age`. Start times are compared as floats rounded down, so the answer is
/// right or, within a rounding of a contact, one too high; the caller steps back by the exact times.
NPSEE_KERNEL_INLINE Ints arcNumbers(const Chunk& chunk, int four, Doubles age) {
  const Floats rounded = narrow(age);
  Ints number = {0, 0, 0, 0};
  const float* row = chunk.starts.data() + std::size_t{4} * chunk.first_row[four];
  const float* end = chunk.starts.data() + std::size_t{4} * chunk.first_row[four + 1];
  for (; row != end; row += 4) number -= load(row) <= rounded;
  return number;
}

/// Gathers the arcs of four particles; `tau` is the time since each began, zero for particles at rest.
struct Gathered {
  Motion<Doubles> motion;
  Doubles tau;
  Ints number;
};

NPSEE_KERNEL_INLINE Gathered gather(const LayerConstants& c, const Chunk& chunk, int four, Doubles age) {
  Gathered out;
  out.number = arcNumbers(chunk, four, age);
  const Arc* arcs[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    const int particle = 4 * four + lane;
    const Arc* arc = chunk.arcs.data() + chunk.first_arc[particle] + out.number[lane];
    while (out.number[lane] > 0 && arc->start_s > age[lane]) {
      --arc;
      --out.number[lane];
    }
    arcs[lane] = arc;
  }
  Doubles start = load(&arcs[0]->start_s), vx = load(&arcs[1]->start_s), vy = load(&arcs[2]->start_s), vz = load(&arcs[3]->start_s);
  transpose(start, vx, vy, vz);
  // The fourth float read is the next arc's or the spare one's, and not used.
  Floats x = load(&arcs[0]->x), y = load(&arcs[1]->x), z = load(&arcs[2]->x), unused = load(&arcs[3]->x);
  transpose(x, y, z, unused);

  const Masks first = __builtin_convertvector(out.number, Masks) == 0;
  const Doubles zero = all(0.0);
  out.motion = {widen(x) + select(first, all(c.origin_x), zero), widen(y) + select(first, all(c.origin_y), all(c.ground_y)),
                widen(z) + select(first, all(c.origin_z), zero), vx, vy, vz};
  Ints still;
  for (int lane = 0; lane < kLanes; ++lane) still[lane] = chunk.rests[4 * four + lane] & (out.number[lane] == chunk.last_arc[4 * four + lane]);
  out.tau = select(__builtin_convertvector(still, Masks) != 0, zero, greater(age - start, zero));
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

/// Time a particle has been tumbling: its age, but not beyond the moment it came to rest.
NPSEE_KERNEL_INLINE Doubles timeMoving(const Chunk& chunk, int four, const Gathered& now, Doubles age) {
  Doubles out = age;
  for (int lane = 0; lane < kLanes; ++lane) {
    const int particle = 4 * four + lane;
    if (chunk.rests[particle] && now.number[lane] == chunk.last_arc[particle]) out[lane] = chunk.arcs[chunk.first_arc[particle] + chunk.last_arc[particle]].start_s;
  }
  return out;
}

template <FlightLaw kLaw, class Real>
NPSEE_KERNEL_INLINE void evaluateFour(const LayerConstants& c, const Chunk& chunk, double t, int four, int at, const FrameView<Real>& out) {
  const int p = 4 * four;
  const Doubles zero = all(0.0);
  const Doubles life = load(chunk.lifetime_s.data() + p);
  const Doubles since_birth = t - (chunk.birth_s.empty() ? all(c.start_s) : load(chunk.birth_s.data() + p));
  const Masks alive = (since_birth >= 0.0) & (since_birth < life);
  const Doubles age = lesser(greater(since_birth, zero), life);

  const Gathered now = gather(c, chunk, four, age);
  const Motion<Doubles> m = flown<kLaw, Doubles>(c.flight, now.motion, now.tau);
  store(out.x + at, m.x);
  store(out.y + at, m.y);
  store(out.z + at, m.z);

  const Doubles alive_one = select(alive, all(1.0), zero);
  const Doubles life_part = age / select(life > 0.0, life, all(1.0));
  Doubles size = widen(load(chunk.size_m.data() + p)) * alive_one;
  if (!c.size_over_life.empty()) size = size * alongLife(c.size_over_life, life_part, [](const CurvePoint& point) { return point.value; });
  store(out.size + at, size);
  for (int lane = 0; lane < kLanes; ++lane) out.alive[at + lane] = static_cast<std::uint8_t>(alive[lane] & 1);

  if (out.vx) {
    store(out.vx + at, m.vx);
    store(out.vy + at, m.vy);
    store(out.vz + at, m.vz);
  }
  if (out.age) store(out.age + at, age);
  if (out.bounces)
    for (int lane = 0; lane < kLanes; ++lane) out.bounces[at + lane] = static_cast<std::uint8_t>(now.number[lane]);
  if (!out.r && !out.qx) return;
  const Doubles phase = widen(load(chunk.phase_rad.data() + p));
  if (out.r) look(c, life_part, alive_one, phase, at, out);
  if (out.qx) orientation(chunk, p, timeMoving(chunk, four, now, age), phase, at, out);
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
  const int whole = chunk.count / kLanes;
  for (int four = 0; four < whole; ++four) evaluateFour<kLaw>(c, chunk, t, four, kLanes * four, out);
  if (const int rest = chunk.count - kLanes * whole; rest > 0) {
    Tail<Real> tail;
    evaluateFour<kLaw>(c, chunk, t, whole, 0, tail.view(out));
    tail.copyOut(out, kLanes * whole, rest);
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
