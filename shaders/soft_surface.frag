#version 330 core
#include "soft.glsl"
#include "surface.glsl"
flat in vec3 v_velocity;  // world m/s

// Blended from back to front like light: in the end the mean of the puffs, each weighted by its share of what is seen, times the
// cover of all.
void main() { o_surface = surfaceAt(v_velocity) * clamp(softLight().a, 0.0, 1.0); }
