#version 330 core
#include "soft.glsl"
#include "surface.glsl"
flat in vec3 v_velocity;  // world m/s

void main() {
  // What covers less than half of what is behind it is no surface.
  if (softLight().a < 0.5) discard;
  writeSurface(v_velocity);
}
