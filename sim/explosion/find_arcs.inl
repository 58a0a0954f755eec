// Bounces over flat ground, eight particles at a time: finding a contact is a long chain of dependent operations, so two fours run side by side. Part of a kernel (kernel.inl).

/// Appends the arc that begins with `motion` in each active lane; `start` is the height for the first one.
NPSEE_KERNEL_INLINE void appendArcs(ArcRoom& room, const EightMasks& active, const Eight& start, const Motion<Eight>& m) {
  for (int lane = 0; lane < kEight; ++lane) {
    if (!active[lane]) continue;
    Arc& arc = room.arcs[lane][++room.last[lane]];
    arc.start_s = start[lane];
    arc.vy = m.vy[lane];
    arc.x = static_cast<float>(m.x[lane]);
    arc.z = static_cast<float>(m.z[lane]);
    arc.vx = static_cast<float>(m.vx[lane]);
    arc.vz = static_cast<float>(m.vz[lane]);
  }
}

// What an arc stores of a place, and of a velocity along the ground.
NPSEE_KERNEL_INLINE Eight asFloats(const Eight& x) { return {widen(narrow(x.low)), widen(narrow(x.high))}; }
NPSEE_KERNEL_INLINE Eight towardsZero(const Eight& x) { return fromBits(bitsOf(x) & kFloatBits); }

template <FlightLaw kLaw>
NPSEE_KERNEL_INLINE void findArcsOf(const LayerConstants& c, const Launches& from, int first, ArcRoom& room) {
  for (int lane = 0; lane < kEight; ++lane) {
    room.last[lane] = -1;
    room.rests[lane] = false;
  }
  Motion<Eight> m{loadEight(from.x + first), loadEight(from.y + first), loadEight(from.z + first), loadEight(from.vx + first), loadEight(from.vy + first), loadEight(from.vz + first)};
  const Eight life = loadEight(from.lifetime_s + first);
  const Eight zero = filled<Eight>(0.0);
  EightMasks active = filled<Eight>(1.0) > zero;
  Eight start = zero;
  appendArcs(room, active, m.y, m);
  if (!c.collide) return;

  // From here on positions are absolute horizontally and relative to the ground vertically.
  m.x += c.origin_x;
  m.z += c.origin_z;
  m.y = greater(m.y + c.origin_y - c.ground_y, zero);
  for (int bounce = 0; bounce <= c.bounce_limit; ++bounce) {
    const Eight tau = contactTime<kLaw, Eight>(c.flight, m.y, m.vy, life - start);
    active = active & (tau < kNever_s);
    if (!any(active)) return;
    const Motion<Eight> hit = flown<kLaw, Eight>(c.flight, m, select(active, tau, zero));
    start = select(active, start + tau, start);
    const Eight up = -c.restitution * lesser(hit.vy, zero);
    const EightMasks stays = (up < c.rest_speed_mps) | (filled<Eight>(bounce) >= static_cast<double>(c.bounce_limit)) | (up == 0.0);
    const double kept = 1.0 - c.friction;
    m = {asFloats(hit.x), zero, asFloats(hit.z), towardsZero(select(stays, zero, kept * hit.vx)), select(stays, zero, up), towardsZero(select(stays, zero, kept * hit.vz))};
    appendArcs(room, active, start, m);
    for (int lane = 0; lane < kEight; ++lane) room.rests[lane] = room.rests[lane] || (active[lane] && stays[lane]);
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
