// Forces on the shell. Included after atmosphere.inl; R is double or lanes::Doubles.

/// ShotConstants, one number or one per lane.
template <class R>
struct Lane {
  R drag, lift, magnus, yaw_drag2, wind[3], omega2[3];
};

/// Row of the coefficient table a Mach number falls in, and its lower knot.
NPSEE_KERNEL_INLINE const double* rowOf(const CompiledAero& aero, double mach, double& from) {
  // An attempt that explodes is refused later; here it must only find a row. The comparison is false for what is no number.
  mach = mach < 1e30 ? mach : 1e30;
  const double place = mach * aero.bucket_scale;
  const std::int64_t bucket = place < static_cast<double>(aero.last_bucket) ? static_cast<std::int64_t>(place) : aero.last_bucket;
  const double* knot = aero.knot + aero.bucket[bucket];
  while (mach >= knot[1]) ++knot;
  from = *knot;
  return aero.row + (knot - aero.knot) * static_cast<std::ptrdiff_t>(kCoefficients * 4);
}

/// Place in the coefficient table: rows and the distance from their lower knots.
template <class R>
struct Place;
template <>
struct Place<double> {
  const double* row;
  double s;
  Place(const CompiledAero& aero, double mach) {
    double from;
    row = rowOf(aero, mach, from);
    s = mach - from;
  }
  __attribute__((always_inline)) double operator[](Coefficient c) const {
    const double* p = row + 4 * static_cast<int>(c);
    return p[0] + s * (p[1] + s * (p[2] + s * p[3]));
  }
};
template <>
struct Place<Doubles> {
  const double* row[4];
  Doubles s;
  Place(const CompiledAero& aero, Doubles mach) {
    double from[4];
    for (int lane = 0; lane < 4; ++lane) row[lane] = rowOf(aero, mach[lane], from[lane]);
    s = mach - load(from);
  }
  __attribute__((always_inline)) Doubles operator[](Coefficient c) const {
    const int at = 4 * static_cast<int>(c);
    Doubles p0 = load(row[0] + at), p1 = load(row[1] + at), p2 = load(row[2] + at), p3 = load(row[3] + at);
    transpose(p0, p1, p2, p3);
    return p0 + s * (p1 + s * (p2 + s * p3));
  }
};

template <>
struct Place<Eight> {
  Place<Doubles> a, b;
  Place(const CompiledAero& aero, const Eight& mach) : a(aero, mach.low), b(aero, mach.high) {}
  __attribute__((always_inline)) Eight operator[](Coefficient c) const { return {a[c], b[c]}; }
};

template <class R>
struct V3 {
  R x, y, z;
};
template <class R>
NPSEE_KERNEL_INLINE V3<R> crossed(const V3<R>& a, const V3<R>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class R>
NPSEE_KERNEL_INLINE R dotted(const V3<R>& a, const V3<R>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Gravity and Coriolis acceleration, and the height above the sphere (or the flat earth).
template <class R>
NPSEE_KERNEL_INLINE V3<R> bodyForces(const Setup& s, const Lane<R>& q, const R* y, R& height) {
  V3<R> g{number<R>(0.0), number<R>(-s.g_mps2), number<R>(0.0)};
  height = y[1];
  if (s.gravity == GravityModel::curved) {
    height = y[1] + (y[0] * y[0] + y[2] * y[2]) * (0.5 / kEarthRadius_m);
    const R fraction = number<R>(-s.g_mps2 / kEarthRadius_m);
    g = {fraction * y[0], -s.g_mps2 * (1.0 - y[1] * (2.0 / kEarthRadius_m)), fraction * y[2]};
  } else if (s.gravity == GravityModel::inverse_square) {
    const R ratio = kEarthRadius_m / (kEarthRadius_m + larger(y[1], number<R>(-0.5 * kEarthRadius_m)));
    g.y = -s.g_mps2 * (ratio * ratio);
  }
  if (s.coriolis) {
    const V3<R> c = crossed(V3<R>{q.omega2[0], q.omega2[1], q.omega2[2]}, V3<R>{y[3], y[4], y[5]});
    g = {g.x - c.x, g.y - c.y, g.z - c.z};
  }
  return g;
}

/// Yaw of repose of a spinning shell, ae = c (v x du/dt) with c = -8 Ix p / (pi rho d^3 CMa V^4) = k / w, w = rho V^4 CMa.
///
/// du/dt holds lift and Magnus force, hence ae again. v x du/dt = v x G + L (v x ae) + K V^2 ae with G gravity and Coriolis, L ae
/// the lift and K (ae x v) the Magnus acceleration; as ae is normal to v this linear equation has the solution
///   ae = (s b + q (v x b)) / (s^2 + q^2 V^2),  b = k (v x G),  s = w - k K V^2,  q = k L,
/// which is what repeated substitution tends to where it converges. docs/physics.md derives it.
template <class R>
NPSEE_KERNEL_INLINE V3<R> yawOfRepose(R k, R w, R lift, R magnus, const V3<R>& v, R v2, const V3<R>& vg) {
  const V3<R> b{k * vg.x, k * vg.y, k * vg.z};
  const R s = w - k * magnus * v2, q = k * lift;
  const R scale = 1.0 / (s * s + q * q * v2), along = s * scale, across = q * scale;
  const V3<R> vb = crossed(v, b);
  return {along * b.x + across * vb.x, along * b.y + across * vb.y, along * b.z + across * vb.z};
}

/// Derivative of the state. `lagged` is the acceleration of the step before, for the thesis's way to the yaw of repose; null
/// for the exact one. `yaw2` is the square of the yaw of repose, `mach` the Mach number.
template <class R>
NPSEE_KERNEL_INLINE void derivative(const Setup& s, const Lane<R>& q, R t, const R* y, R* dy, R& yaw2, R& mach, const R* lagged = nullptr) {
  R height;
  const V3<R> g = bodyForces(s, q, y, height);
  for (int i = 0; i < 3; ++i) dy[i] = y[3 + i];
  yaw2 = mach = dy[6] = number<R>(0.0);
  if (s.model == FlightModel::vacuum) {
    dy[3] = g.x, dy[4] = g.y, dy[5] = g.z;
    return;
  }
  R density, sound;
  if (s.atmosphere.icao) standardAir(R(height + s.altitude_m), density, sound);
  else density = number<R>(s.atmosphere.density_kgm3), sound = number<R>(s.atmosphere.sound_speed_mps);
  const V3<R> v{y[3] - q.wind[0], y[4] - q.wind[1], y[5] - q.wind[2]};
  // A shell at rest in the air has no direction; a floor keeps the quotients below finite.
  const R v2 = larger(dotted(v, v), number<R>(1e-12)), speed = squareRoot(v2);
  mach = speed / sound;
  const Place<R> aero(*s.aero, mach);

  R p = y[6];
  if (s.spin_damped) {
    const R rate = s.spin_k * density * speed * aero[Coefficient::cspin];
    if (s.closed_form_spin) p = p * exponential(smaller(rate * t, number<R>(0.0)));  // thesis eq. 3.15
    else dy[6] = rate * p;
  }
  R cd = aero[Coefficient::cd0];
  V3<R> a = g;
  if (s.yaw) {
    const R cla = aero[Coefficient::cla];
    const R cma = larger(aero[Coefficient::cma], number<R>(1e-3));
    const R magnus = -q.magnus * density * p * aero[Coefficient::cmagf];
    const R thick = larger(density * v2 * v2, number<R>(1e-60));
    const R k = -s.yaw_k * p;
    R lift = q.lift * density * cla * v2;
    // The thesis takes the acceleration of the step before and does not look for the fixed point.
    const V3<R> turning = lagged ? crossed(v, V3<R>{lagged[0], lagged[1], lagged[2]}) : crossed(v, g);
    const R zero = number<R>(0.0);
    V3<R> ae = yawOfRepose(k, thick * cma, lagged ? zero : lift, lagged ? zero : magnus, v, v2, turning);
    yaw2 = dotted(ae, ae);
    if (s.aero->cubic_yaw) {
      // The cubic terms are small corrections: two substitutions of the yaw they depend on.
      for (int pass = 0; pass < 2; ++pass) {
        const R bounded = smaller(yaw2, number<R>(kYawClamp_rad * kYawClamp_rad));
        lift = q.lift * density * (cla + aero[Coefficient::cla3] * bounded) * v2;
        const R moment = larger(cma + aero[Coefficient::cma3] * bounded, number<R>(1e-3));
        ae = yawOfRepose(k, thick * moment, lagged ? zero : lift, lagged ? zero : magnus, v, v2, turning);
        yaw2 = dotted(ae, ae);
      }
    }
    const auto over = yaw2 > kYawClamp_rad * kYawClamp_rad;
    if (any(over)) {
      const R shrink = select(over, kYawClamp_rad / squareRoot(larger(yaw2, number<R>(1e-12))), number<R>(1.0));
      ae = {shrink * ae.x, shrink * ae.y, shrink * ae.z};
      yaw2 = select(over, number<R>(kYawClamp_rad * kYawClamp_rad), yaw2);
    }
    cd = cd + aero[Coefficient::cda2] * (q.yaw_drag2 * yaw2);
    const V3<R> side = crossed(ae, v);
    a = {a.x + lift * ae.x + magnus * side.x, a.y + lift * ae.y + magnus * side.y, a.z + lift * ae.z + magnus * side.z};
  }
  const R drag = q.drag * density * cd * speed;
  dy[3] = a.x - drag * v.x;
  dy[4] = a.y - drag * v.y;
  dy[5] = a.z - drag * v.z;
}
