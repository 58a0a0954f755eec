#pragma once

#include <npsee/preset.h>

namespace npsee::explosion {

/// Radius of a blast front over its life as a part of the last radius.
///
///   R / R1 = c u^(2/5)                  u <= u0      a strong shock: E t^2 / rho R^5 = const
///   R / R1 = c (u0^(2/5) + s (u - u0))  u >= u0      sound, at the speed s that the front has there
///
/// u age / lifetime [-], u0 = 1/4, s = (2/5) u0^(-3/5), c such that it ends at 1. Points of the curve: between them it is piecewise linear,
/// within 0.3 % of the law.
/// Source: G. I. Taylor 1950, The formation of a blast wave by a very intense explosion, Proc. R. Soc. A 201, 159-174.
Curve shockGrowth();

/// (1 - u)^2: the overpressure that bends light falls off fast.
Curve shockFading();

}  // namespace npsee::explosion
