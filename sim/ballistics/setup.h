#pragma once

#include "sim/ballistics/kernels.h"

namespace npsee::ballistics {

/// The equations' constants for a projectile under conditions.
Setup setupOf(const Projectile& projectile, const Conditions& conditions, FlightModel model, const Integration& integration);

/// A shot's own constants.
ShotConstants constantsOf(const Setup& setup, const Shot& shot);

/// What is reported of a finished flight.
Flight flightOf(const Setup& setup, const Shot& shot, const Progress& progress);

/// Spin where it is in closed form, thesis eq. 3.15.
double closedFormSpin(const Setup& setup, const double* y, double time_s);

}  // namespace npsee::ballistics
