// Bounces over flat ground, four particles at a time. Part of a kernel (kernel.inl).

/// Appends the arc that begins with `motion` (heights relative to `ground_y` after the first) in each active lane.
NPSEE_KERNEL_INLINE void appendArcs(ArcRoom& room, Masks active, Doubles start, const Motion<Doubles>& m) {
  for (int lane = 0; lane < kLanes; ++lane) {
    if (!active[lane]) continue;
    Arc& arc = room.arcs[lane][++room.last[lane]];
    arc.start_s = start[lane];
    arc.vx = m.vx[lane];
    arc.vy = m.vy[lane];
    arc.vz = m.vz[lane];
    arc.x = static_cast<float>(m.x[lane]);
    arc.y = static_cast<float>(m.y[lane]);
    arc.z = static_cast<float>(m.z[lane]);
  }
}

NPSEE_KERNEL_INLINE Doubles asFloats(Doubles x) { return widen(narrow(x)); }

template <FlightLaw kLaw>
NPSEE_KERNEL_INLINE void findArcsOf(const LayerConstants& c, const Launches& from, int first, ArcRoom& room) {
  for (int lane = 0; lane < kLanes; ++lane) {
    room.last[lane] = -1;
    room.rests[lane] = false;
  }
  Motion<Doubles> m{load(from.x + first), load(from.y + first), load(from.z + first), load(from.vx + first), load(from.vy + first), load(from.vz + first)};
  const Doubles life = load(from.lifetime_s + first);
  const Doubles zero = all(0.0);
  Masks active = zero == zero;
  Doubles start = zero;
  appendArcs(room, active, start, m);
  if (!c.collide) return;

  // From here on positions are absolute horizontally and relative to the ground vertically.
  m.x += c.origin_x;
  m.z += c.origin_z;
  m.y = greater(m.y + c.origin_y - c.ground_y, zero);
  for (int bounce = 0; bounce <= c.bounce_limit; ++bounce) {
    const Doubles tau = contactTime<kLaw, Doubles>(c.flight, m.y, m.vy, life - start);
    active = active & (tau < kNever_s);
    if (!any(active)) return;
    const Motion<Doubles> hit = flown<kLaw, Doubles>(c.flight, m, select(active, tau, zero));
    start = select(active, start + tau, start);
    const Doubles up = -c.restitution * lesser(hit.vy, zero);
    const Masks stays = (up < c.rest_speed_mps) | (all(bounce) >= (double)c.bounce_limit) | (up == 0.0);
    const double kept = 1.0 - c.friction;
    m = {asFloats(hit.x), zero, asFloats(hit.z), select(stays, zero, kept * hit.vx), select(stays, zero, up), select(stays, zero, kept * hit.vz)};
    appendArcs(room, active, start, m);
    for (int lane = 0; lane < kLanes; ++lane) room.rests[lane] = room.rests[lane] || (active[lane] && stays[lane]);
    active = active & ~stays;
  }
}

void findArcs(const LayerConstants& c, const Launches& from, int first, ArcRoom& room) {
  switch (c.flight.law) {
    case FlightLaw::ballistic: return findArcsOf<FlightLaw::ballistic>(c, from, first, room);
    case FlightLaw::exponential: return findArcsOf<FlightLaw::exponential>(c, from, first, room);
    case FlightLaw::series: return findArcsOf<FlightLaw::series>(c, from, first, room);
  }
}
