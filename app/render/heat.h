#pragma once

#include "app/gl/program.h"

#include <npsee/explosion.h>

#include <span>
#include <vector>

namespace npsee::render {

/// Temperature of a particle of a hot layer, K: T = T0 / (1 + 3 t / c)^(1/3), which is dT/dt ~ -T^4, a body that cools by its own
/// radiation (Stefan and Boltzmann) into surroundings far colder; after the time c it has fallen to 63 %. 0 in a cold layer.
double temperatureAt(const LayerSpan& layer, double age_s);
/// That of particle i of a frame; 0 where the frame has no ages.
double temperatureAt(const LayerSpan& layer, const Frame& frame, std::size_t i);

/// Light that a black body gives off, linear: its colour by Wien's law at 610, 550 and 465 nm beside white of 6500 K, largest component
/// 1, times its red light beside that at 1300 K, which daylight hardly outshines, at most 2.5. Nothing below 700 K.
Vec3 emittedLight(double temperature_k);

/// Colour of a soft form as hot as that, sRGB-coded: its own where it is too cold to glow, a black body's where it is not.
Colour hotColour(const Colour& own, double temperature_k);

/// Temperatures of a frame's particles, K, in its order; empty where no layer is hot or the frame has no ages.
void temperaturesOf(const Frame& frame, std::span<const LayerSpan> layers, std::vector<float>& out);

/// Sets u_emitted, a table of emittedLight for shaders, as heat.glsl reads it.
void setEmitted(const gl::Program& program);

}  // namespace npsee::render
