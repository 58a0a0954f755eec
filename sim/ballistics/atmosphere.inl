// The standard atmosphere. Included inside the unnamed namespace of a kernel; R is double or lanes::Doubles.

template <class R>
NPSEE_KERNEL_INLINE R number(double value) {
  if constexpr (sizeof(R) == sizeof(double)) return value;
  else return filled<R>(value);
}

/// The second number where the first is not one.
template <class R>
NPSEE_KERNEL_INLINE R larger(R a, R b) {
  return select(a > b, a, b);
}
template <class R>
NPSEE_KERNEL_INLINE R smaller(R a, R b) {
  return select(a < b, a, b);
}

/// Density and speed of sound of the ICAO standard atmosphere at geometric height h [m].
///
///   H = Re h / (Re + h);  below 11 km: T/T0 = 1 - 0.0065 H / 288.15, rho = 1.225 (T/T0)^4.2558797, a = 340.29399 sqrt(T/T0)
///   above: rho = 0.36391801 exp((11000 - H) g / (R T)), a = 295.06949
///
/// Valid from -5 km (lower heights count as that) to 20 km; above that the isothermal layer simply goes on.
/// Source: U.S. Standard Atmosphere 1976 (ICAO Doc 7488 to 32 km agrees).
template <class R>
NPSEE_KERNEL_INLINE void standardAir(R h, R& density, R& sound) {
  // Above 100 km there is next to nothing, and the series below, H = h - h^2/Re + h^3/Re^2 - ..., is good to there (1e-8;
  // 1e-14 in the troposphere).
  h = smaller(larger(h, number<R>(-5000.0)), number<R>(100000.0));
  const R e = h * (1.0 / kEarthRadius_m);
  const R geopotential = h * (1.0 - e * (1.0 - e * (1.0 - e * (1.0 - e * (1.0 - e)))));
  const R theta = larger(1.0 - (0.0065 / 288.15) * geopotential, number<R>(1.0 - 0.0065 / 288.15 * 11000.0));
  // (T/T0)^0.2558797 by a polynomial about 0.94, relative error 4e-16 on [0.745, 1.14]; the four whole powers are exact.
  const R x = theta - 0.94, x2 = x * x, x4 = x2 * x2, x8 = x4 * x4;
  const R p0 = (0.98429201795605532268 + x * 0.26793653858190058483) + x2 * (-0.10605160503669407661 + x * 0.065591048652768567133);
  const R p1 = (-0.047869608875106565185 + x * 0.038133951266193841537) + x2 * (-0.032076553263831010535 + x * 0.028001831071161396068);
  const R p2 = (-0.025116525517028181368 + x * 0.022987816142485004137) + x2 * (-0.02124075555047451619 + x * 0.020092462703623187606);
  const R p3 = -0.021813835791560535735 + x * 0.020312969006489059592;
  const R power = (p0 + x4 * p1) + x8 * (p2 + x4 * p3);
  const R theta2 = theta * theta;
  density = 1.225 * (theta2 * theta2 * power);
  sound = 340.29399 * squareRoot(theta);
  const auto high = geopotential > 11000.0;
  if (any(high)) {
    density = select(high, 0.36391801 * exponential((11000.0 - geopotential) * (9.80665 / (287.05287 * 216.65))), density);
    sound = select(high, number<R>(295.06949), sound);
  }
}
